#pragma once

#include "geometry/cancel.h"
#include "graph/problem.h"
#include "graph/value.h"

namespace dini {

/// A value as JSON text in full double precision: {"axes", "type", "values"}, values flat, the last axis fastest.
/// Points at infinity are null; with `full`, meshes carry positions and indices. Stopped early: text that is no JSON.
std::string to_json_text(const Value& value, bool full, const Cancel& cancel);

/// The same, read: for small values.
Json to_json(const Value& value, bool full = false);

Json to_json(const Axes& axes);

}  // namespace dini
