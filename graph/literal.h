#pragma once

#include <optional>
#include <string>

#include "graph/port.h"
#include "graph/reading.h"

namespace dini {

/// Reads a literal for a port as one wire type: numbers and integers within the hard range, finite triples for vectors
/// and points, a choice among the port's words. Generators, circles, spheres and meshes have no literals.
LiteralResult read_literal(const Json& json, WireType type, const InputPort& port);

/// The same as every type that the port takes.
Readings read_literal(const Json& json, const InputPort& port);

/// The value of a parameter at a port that takes `type`, which the type of the parameter fits: an integer may stand for
/// a number, a vector for a point and a choice for a text.
LiteralResult given_to(const InputPort& port, WireType type, const ParameterValue& parameter);

/// Whether values of the type can be written in a document.
bool has_literals(WireType type);

/// A number as text for people: the shortest that reads back, without an exponent where possible.
std::string to_text(double value);

/// "0 to 4", "at least 1", or "any" for a hard range.
std::string range_text(std::optional<double> minimum, std::optional<double> maximum);

/// `json` cut to a length that suits an error message.
std::string excerpt(const Json& json);

}  // namespace dini
