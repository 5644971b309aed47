#pragma once

#include <map>
#include <string>

#include "graph/document.h"
#include "graph/port.h"

namespace dini {

/// Reads one entry of "parameters": a type, a default of that type within its own bounds, and what a form shows.
Result<Parameter> read_parameter(const Json& json, const std::string& pointer);

/// The default of every parameter.
ParameterValues usual_parameters(const Document& document);

/// The value of every parameter: the given one where there is one, else the default. Unknown names, wrong types and
/// values out of bounds are problems in the request, at /parameters/<name>.
Result<ParameterValues> resolve_parameters(const Document& document, const Json& given);

/// The port that a parameter would be if it were an input: types, range and choices, for reading its values.
InputPort parameter_port(const Parameter& parameter);

}  // namespace dini
