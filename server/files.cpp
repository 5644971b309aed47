#include "server/files.h"

#include <cerrno>
#include <cstring>
#include <fstream>
#include <iterator>

namespace dini::server {

Result<std::string> read_file(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::string bytes{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  if (!file.is_open() || file.bad())
    return Problem{.code = "io", .detail = path.string() + ": " + std::strerror(errno)};
  return bytes;
}

}  // namespace dini::server
