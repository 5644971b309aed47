#pragma once

#include "graph/problem.h"
#include "graph/value.h"

namespace dini {

/// A value as JSON in full double precision: {"type", "axes", "values"}, values flat, the last axis fastest.
/// Points at infinity are null; with `full`, meshes carry positions and indices.
Json to_json(const Value& value, bool full = false);

Json to_json(const Axes& axes);

}  // namespace dini
