#pragma once

#include <string>
#include <vector>

#include "cli/evaluation.h"

namespace dini::cli {

/// One variant of a sweep and what became of it.
struct SweptVariant {
  std::size_t index = 0;
  Json setting = Json::object();
  std::string output = {};  ///< empty for the only one
  std::string file = {};
  Outcome outcome = {};
  bool known = false;  ///< it was finished by an earlier run
};

/// The variants as CSV (RFC 4180): index, the parameters, the output where there are several, the file, the result
/// (`ok` or the code of a problem), bytes, vertices, triangles, the hash, and the measures that were asked for.
std::string table_of(const std::vector<SweptVariant>& variants, const std::vector<std::string>& measures,
                     bool tells_outputs);

}  // namespace dini::cli
