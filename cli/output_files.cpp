#include "cli/output_files.h"

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <map>
#include <set>
#include <system_error>
#include <unistd.h>

#include "cli/problems.h"

namespace dini::cli {
namespace {

namespace fs = std::filesystem;

/// What stands in the way of a file, as far as a look at the path tells.
int error_of(const std::string& path) {
  std::error_code ignored;
  if (fs::is_directory(path, ignored)) return EISDIR;
  const fs::path folder = fs::path(path).parent_path();
  if (folder.empty() || fs::is_directory(folder, ignored)) return 0;
  return fs::exists(folder, ignored) ? ENOTDIR : ENOENT;
}

/// The same for two ways to write one path.
std::string key_of(const std::string& path) {
  if (path == "-") return path;
  std::error_code error;
  const fs::path whole = fs::weakly_canonical(fs::absolute(path, error), error);
  return error ? path : whole.string();
}

std::string lower(std::string text) {
  std::ranges::transform(text, text.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

Json json_in(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return Json::parse(file, nullptr, false);
}

bool is_of_its_kind(const OutputPath& output) {
  const std::string& path = *output.path;
  const std::string ending = lower(fs::path(path).extension().string());
  switch (output.kind) {
    case OutputKind::any:
      return true;
    case OutputKind::model: {
      if (ending != output.extension) return false;
      std::ifstream file(path, std::ios::binary);
      return file.peek() != '{' || !looks_like_graph(json_in(path));
    }
    case OutputKind::report:
      return json_in(path).contains("succeeded");
    case OutputKind::log:
      return json_in(path).contains("runs");
    case OutputKind::xml: {
      std::ifstream file(path, std::ios::binary);
      return file.peek() == '<';
    }
    case OutputKind::page:
      return ending == ".md";
    case OutputKind::table:
      return ending == ".csv";
  }
  return false;
}

/// Empty files, devices and pipes are always written to.
bool is_in_the_way(const OutputPath& output) {
  std::error_code error;
  if (!fs::is_regular_file(*output.path, error) || fs::file_size(*output.path, error) == 0) return false;
  return !is_of_its_kind(output);
}

}  // namespace

bool looks_like_graph(const Json& json) {
  return json.is_object() && json.contains("format") && json.contains("nodes") && json["nodes"].is_object();
}

Problems unwritable(const std::vector<OutputPath>& outputs, const std::vector<std::string>& inputs) {
  std::map<std::string, std::string> before;
  std::set<std::string> read;
  for (const std::string& input : inputs) read.insert(key_of(input));
  for (const OutputPath& output : outputs) {
    if (!output.path) continue;
    const std::string& path = *output.path;
    const auto refused = [](std::string detail) { return Problems{usage_problem(std::move(detail))}; };
    if (path.empty()) return refused(output.option + " needs a file, or - for standard output");
    const std::string key = key_of(path);
    if (const auto [twice, is_new] = before.emplace(key, output.option); !is_new) {
      return refused((path == "-" ? "standard output" : path) + " would be written twice, by " + twice->second +
                     (twice->second == output.option ? "" : " and " + output.option));
    }
    if (path == "-") continue;
    if (const int error = error_of(path); error != 0) return {io_problem(path, error)};
    std::error_code ignored;
    if (read.contains(key) && (fs::is_regular_file(path, ignored) || !fs::exists(path, ignored))) {
      return refused(output.option + " would write over " + path + ", which is read");
    }
    if (is_in_the_way(output)) {
      return refused(output.option + " would replace " + path + ", which is a file of another kind; move it first");
    }
  }
  return {};
}

Problems make_folders(const std::vector<OutputPath>& outputs) {
  for (const OutputPath& output : outputs) {
    if (!output.path || *output.path == "-") continue;
    const fs::path folder = fs::path(*output.path).parent_path();
    std::error_code error;
    if (!folder.empty()) fs::create_directories(folder, error);
    if (error) return {io_problem(folder.string(), error.value())};
  }
  return {};
}

Problems write_output(const std::string& path, std::string_view bytes) {
  if (path == "-") {
    std::cout.write(bytes.data(), static_cast<std::streamsize>(bytes.size())).flush();
    return std::cout ? Problems{} : Problems{io_problem("standard output", EIO)};
  }
  if (const int error = error_of(path); error != 0) return {io_problem(path, error)};
  std::error_code ignored;
  const bool exists = fs::exists(path, ignored);
  const bool is_file = !exists || fs::is_regular_file(path, ignored);
  // Through links: the file that they mean is replaced, not the link.
  const std::string target = exists && is_file ? fs::canonical(path, ignored).string() : path;
  const std::string unfinished = is_file ? target + "." + std::to_string(::getpid()) + ".part" : target;
  errno = 0;
  std::ofstream file(unfinished, std::ios::binary);
  file.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  file.close();
  if (!file || (is_file && std::rename(unfinished.c_str(), target.c_str()) != 0)) {
    const int error = errno != 0 ? errno : EIO;
    if (is_file) std::remove(unfinished.c_str());
    return {io_problem(path, error)};
  }
  return {};
}

void remove_file(const std::string& path) {
  std::error_code ignored;
  if (path != "-" && fs::is_regular_file(fs::symlink_status(path, ignored))) fs::remove(path, ignored);
}

}  // namespace dini::cli
