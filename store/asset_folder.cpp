#include "store/asset_folder.h"

#include <cerrno>
#include <fcntl.h>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>

#include "store/data_folder.h"

namespace dini::store {
namespace {

constexpr std::string_view unfinished = ".new";

/// An open file, closed at the end.
class Handle {
 public:
  Handle(const std::filesystem::path& path, int flags) : handle_(::open(path.c_str(), flags | O_CLOEXEC, 0644)) {}
  Handle(const Handle&) = delete;
  Handle& operator=(const Handle&) = delete;
  ~Handle() {
    if (handle_ >= 0) ::close(handle_);
  }
  explicit operator bool() const { return handle_ >= 0; }
  int get() const { return handle_; }

 private:
  int handle_;
};

Problem problem_of(int reason) {
  if (reason == ENOSPC || reason == EDQUOT || reason == EFBIG) {
    return {.code = "storage-full", .detail = "There is no room to keep this file: the disk is full."};
  }
  return {.code = "storage-failed",
          .detail = "The file cannot be kept just now: " + std::generic_category().message(reason) + "."};
}

bool write_all(int handle, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(handle, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return false;
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
  return true;
}

/// Zero, or why not.
int write_through(const std::filesystem::path& path, std::string_view bytes) {
  const Handle handle(path, O_WRONLY | O_CREAT | O_TRUNC | O_NOFOLLOW);
  if (!handle || !write_all(handle.get(), bytes) || ::fsync(handle.get()) != 0) return errno;
  return 0;
}

int sync_folder(const std::filesystem::path& path) {
  const Handle handle(path, O_RDONLY | O_DIRECTORY);
  return handle && ::fsync(handle.get()) == 0 ? 0 : errno;
}

bool read_all(int handle, std::string& bytes) {
  for (std::size_t done = 0; done < bytes.size();) {
    const ssize_t read = ::read(handle, bytes.data() + done, bytes.size() - done);
    if (read < 0 && errno == EINTR) continue;
    if (read <= 0) return false;
    done += static_cast<std::size_t>(read);
  }
  return true;
}

}  // namespace

Result<bool> AssetFolder::write(const Digest& sha256, std::string_view bytes) const {
  std::error_code error;
  const bool made = std::filesystem::create_directories(path_, error);
  if (error) return problem_of(error.value());
  const std::filesystem::path target = file(sha256), begun = std::filesystem::path(target).concat(unfinished);
  int reason = made ? sync_folder(path_.parent_path()) : 0;
  if (reason == 0) reason = write_through(begun, bytes);
  if (reason == 0 && ::rename(begun.c_str(), target.c_str()) != 0) reason = errno;
  if (reason != 0) {
    ::unlink(begun.c_str());
    return problem_of(reason);
  }
  if (const int unsure = sync_folder(path_); unsure != 0) return problem_of(unsure);
  return true;
}

SharedBytes AssetFolder::read(const Digest& sha256) const {
  const Handle handle(file(sha256), O_RDONLY | O_NOFOLLOW | O_NONBLOCK);
  struct stat status {};
  if (!handle || ::fstat(handle.get(), &status) != 0 || !S_ISREG(status.st_mode)) return nullptr;
  std::string bytes(static_cast<std::size_t>(status.st_size), '\0');
  if (!read_all(handle.get(), bytes) || dini::sha256(bytes) != sha256) return nullptr;
  return share(std::move(bytes));
}

bool AssetFolder::has(const Digest& sha256) const {
  struct stat status {};
  return ::lstat(file(sha256).c_str(), &status) == 0;
}

void AssetFolder::remove(const Digest& sha256) const { ::unlink(file(sha256).c_str()); }

void AssetFolder::touch(const Digest& sha256) const {
  ::utimensat(AT_FDCWD, file(sha256).c_str(), nullptr, AT_SYMLINK_NOFOLLOW);
}

std::vector<AssetEntry> AssetFolder::entries() const {
  std::vector<AssetEntry> entries;
  std::error_code error;
  for (std::filesystem::directory_iterator entry(path_, error), end; !error && entry != end; entry.increment(error)) {
    const auto digest = digest_from_hex(entry->path().filename().string());
    struct stat status {};
    if (!digest || ::lstat(entry->path().c_str(), &status) != 0) continue;
    const std::int64_t used = std::int64_t{status.st_mtim.tv_sec} * 1'000'000'000 + status.st_mtim.tv_nsec;
    entries.push_back({*digest, static_cast<std::uintmax_t>(status.st_size), used});
  }
  return entries;
}

void AssetFolder::remove_unfinished() const {
  std::error_code error;
  std::vector<std::filesystem::path> left;
  for (std::filesystem::directory_iterator entry(path_, error), end; !error && entry != end; entry.increment(error)) {
    if (entry->path().extension() == unfinished) left.push_back(entry->path());
  }
  for (const std::filesystem::path& path : left) ::unlink(path.c_str());
}

std::string fault_in_assets(const std::filesystem::path& data_folder) {
  const AssetFolder folder(data_folder);
  for (const AssetEntry& entry : folder.entries()) {
    if (folder.read(entry.sha256) == nullptr && folder.has(entry.sha256)) {
      return "assets/" + to_hex(entry.sha256) + " is not what was written; upload the file again or remove it";
    }
  }
  return "";
}

Result<std::size_t> copy_assets(const std::filesystem::path& data_folder, const std::filesystem::path& target) {
  const AssetFolder folder(data_folder);
  const std::vector<AssetEntry> entries = folder.entries();
  if (entries.empty()) return std::size_t{0};
  std::error_code error;
  std::filesystem::create_directories(target, error);
  if (error) return io_problem(target, error.message());
  std::size_t copied = 0;
  std::string damaged;
  for (const AssetEntry& entry : entries) {
    const SharedBytes bytes = folder.read(entry.sha256);
    // What has made room for others since it was listed is missed by nobody.
    if (bytes == nullptr && folder.has(entry.sha256) && damaged.empty()) damaged = to_hex(entry.sha256);
    if (bytes == nullptr) continue;
    if (const int reason = write_through(target / to_hex(entry.sha256), *bytes); reason != 0) {
      return io_problem(target / to_hex(entry.sha256), std::generic_category().message(reason));
    }
    ++copied;
  }
  if (const int reason = sync_folder(target); reason != 0) {
    return io_problem(target, std::generic_category().message(reason));
  }
  if (!damaged.empty()) return io_problem(folder.path() / damaged, "it is not what was written, and is left out");
  return copied;
}

}  // namespace dini::store
