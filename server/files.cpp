#include "server/files.h"

#include <cerrno>
#include <fstream>
#include <iterator>
#include <system_error>

namespace dini::server {

Result<std::string> read_file(const std::filesystem::path& path) {
  std::error_code error;
  errno = 0;
  std::ifstream file(path, std::ios::binary);
  // Opening a folder works; reading from it throws.
  if (std::filesystem::is_directory(path, error)) errno = EISDIR;
  if (errno != 0 || !file.is_open())
    return Problem{.code = "io", .detail = path.string() + ": " + std::generic_category().message(errno)};
  std::string bytes{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  if (file.bad()) return Problem{.code = "io", .detail = path.string() + ": cannot be read"};
  return bytes;
}

}  // namespace dini::server
