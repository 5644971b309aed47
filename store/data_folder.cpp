#include "store/data_folder.h"

#include <cerrno>
#include <fcntl.h>
#include <sys/file.h>
#include <system_error>
#include <unistd.h>
#include <utility>

namespace dini::store {

Problem io_problem(const std::filesystem::path& path, const std::string& why) {
  return {.code = "io", .detail = path.string() + ": " + why};
}

Result<DataFolder> DataFolder::hold(const std::filesystem::path& path) {
  std::error_code error;
  std::filesystem::create_directories(path, error);
  if (error) return io_problem(path, "the data folder cannot be made: " + error.message());
  const int handle = ::open(path.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (handle < 0)
    return io_problem(path, "the data folder cannot be opened: " + std::generic_category().message(errno));
  if (::flock(handle, LOCK_EX | LOCK_NB) != 0) {
    const int reason = errno;
    ::close(handle);
    return io_problem(path, reason == EWOULDBLOCK
                                ? "another process has this data folder open; give another one with --data"
                                : "the data folder cannot be locked: " + std::generic_category().message(reason));
  }
  return DataFolder(path, handle);
}

DataFolder::DataFolder(DataFolder&& other) noexcept
    : path_(std::move(other.path_)), handle_(std::exchange(other.handle_, -1)) {}

DataFolder::~DataFolder() {
  if (handle_ >= 0) ::close(handle_);
}

std::filesystem::path database_file(const std::filesystem::path& folder) { return folder / "dini.db"; }

std::optional<std::filesystem::path> trace_of_use(const std::filesystem::path& folder) {
  const std::filesystem::path begun = database_file(folder).concat(".new");
  std::error_code error;
  for (std::filesystem::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error)) {
    const std::string name = entry->path().filename().string();
    const bool of_system = name.starts_with('.') || name == "lost+found";
    if (!of_system && !name.starts_with(begun.filename().string())) return entry->path();
  }
  return std::nullopt;
}

}  // namespace dini::store
