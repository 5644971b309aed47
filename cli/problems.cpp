#include "cli/problems.h"

#include <system_error>
#include <utility>

namespace dini::cli {

Problem usage_problem(std::string detail) { return {.code = "usage", .detail = std::move(detail)}; }

Problem io_problem(const std::string& path, int error) {
  return {.code = "io", .detail = path + ": " + std::generic_category().message(error)};
}

}  // namespace dini::cli
