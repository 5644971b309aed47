#pragma once

// What a graph looks like from outside: its parameters as a JSON Schema, and its outputs.

#include <map>
#include <string>

#include "graph/limits.h"
#include "graph/problem.h"

namespace dini {

class Registry;
struct Document;

/// {"parameters": a JSON Schema of an object, "outputs": ["out", ...]}.
Json interface_of(const Registry& registry, const Document& document);

/// Values that are written as text, as in an address, taken for what the parameters of that interface want: numbers,
/// booleans and lists as JSON, a list without its brackets too, choices as they are. What cannot be read so stays a
/// text, which the check of the graph then finds wrong.
Json parameters_from_text(const Json& interface, const std::map<std::string, std::string>& texts, const Limits& limits);

}  // namespace dini
