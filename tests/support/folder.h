#pragma once

#include <filesystem>
#include <fstream>
#include <string>
#include <unistd.h>

namespace dini::support {

/// A folder that is gone at the end. Two at a time have different names.
class Folder {
 public:
  explicit Folder(const std::string& name = "")
      : path_(std::filesystem::temp_directory_path() / ("dini-test-" + std::to_string(::getpid()) + name)) {
    std::filesystem::remove_all(path_);
    std::filesystem::create_directories(path_);
  }
  ~Folder() { std::filesystem::remove_all(path_); }

  const std::filesystem::path& path() const { return path_; }
  void write(const std::string& name, const std::string& bytes) const {
    std::filesystem::create_directories((path_ / name).parent_path());
    std::ofstream(path_ / name, std::ios::binary) << bytes;
  }
  std::string read(const std::string& name) const {
    std::ifstream file(path_ / name, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
  }

 private:
  std::filesystem::path path_;
};

}  // namespace dini::support
