#pragma once

// Literals that were read: what text from outside means as a value of a wire type.

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "geometry/expected.h"
#include "graph/value.h"

namespace dini {

/// Why a literal is refused: a code and what would be accepted.
struct LiteralProblem {
  std::string code;
  std::string detail;
};

using LiteralResult = Expected<Argument, LiteralProblem>;

/// What one literal means as each of the wire types that its input takes.
class Readings {
 public:
  void add(WireType type, LiteralResult reading) { each_.emplace_back(type, std::move(reading)); }

  /// As a type that was added; a problem without a code for any other.
  const LiteralResult& as(WireType type) const;

 private:
  std::vector<std::pair<WireType, LiteralResult>> each_;
};

/// The value of a graph parameter: as it was written, and read as the type of the parameter.
struct ParameterValue {
  Json written;
  Argument value;

  friend bool operator==(const ParameterValue& a, const ParameterValue& b) { return a.written == b.written; }
};

/// The values of all parameters of a graph, by name.
using ParameterValues = std::map<std::string, ParameterValue>;

}  // namespace dini
