#pragma once

#include <filesystem>
#include <optional>

#include "graph/problem.h"

namespace dini::store {

/// The problem (`io`) with a file or folder, in one line.
Problem io_problem(const std::filesystem::path& path, const std::string& why);

/// A folder that one process holds to write into it. The system lets go of it however the process ends.
class DataFolder {
 public:
  /// Makes the folder where there is none. Problems (`io`): it cannot be made or opened, or another process holds it.
  static Result<DataFolder> hold(const std::filesystem::path& path);

  DataFolder(DataFolder&& other) noexcept;
  DataFolder& operator=(DataFolder&&) = delete;
  ~DataFolder();

  const std::filesystem::path& path() const { return path_; }

 private:
  DataFolder(std::filesystem::path path, int handle) : path_(std::move(path)), handle_(handle) {}

  std::filesystem::path path_;
  int handle_;
};

/// Where the database of a data folder is.
std::filesystem::path database_file(const std::filesystem::path& folder);

/// A file in the folder that is not there when nothing was ever kept in it: then a missing database has been lost.
std::optional<std::filesystem::path> trace_of_use(const std::filesystem::path& folder);

}  // namespace dini::store
