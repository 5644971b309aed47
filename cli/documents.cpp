#include "cli/documents.h"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <system_error>
#include <unistd.h>

namespace dini::cli {
namespace {

namespace fs = std::filesystem;

/// Far more than any graph within the limits has.
constexpr std::size_t most_bytes = std::size_t{64} << 20;

std::string shown(const std::string& path) { return path == "-" ? "standard stream" : path; }

Problem io_problem(const std::string& path, int error) {
  return {.code = "io", .detail = path + ": " + std::generic_category().message(error)};
}

/// What stands in the way of a file, as far as a look at the path tells.
int error_of(const std::string& path) {
  std::error_code ignored;
  if (fs::is_directory(path, ignored)) return EISDIR;
  const fs::path folder = fs::path(path).parent_path();
  if (folder.empty() || fs::is_directory(folder, ignored)) return 0;
  return fs::exists(folder, ignored) ? ENOTDIR : ENOENT;
}

bool same_file(const std::string& a, const std::string& b) {
  std::error_code error;
  if (fs::equivalent(a, b, error) && !error) return fs::is_regular_file(a, error);
  return fs::weakly_canonical(a, error) == fs::weakly_canonical(b, error) && !fs::exists(a, error);
}

Result<std::string> read_stream(std::istream& stream, const std::string& name, std::size_t most) {
  std::string text, piece(std::size_t{1} << 16, '\0');
  while (stream.read(piece.data(), static_cast<std::streamsize>(piece.size())), stream.gcount() > 0) {
    text.append(piece, 0, static_cast<std::size_t>(stream.gcount()));
    if (text.size() > most) {
      return Problem{.code = "limit-exceeded",
                     .detail = name + ": there are more than " + std::to_string(most >> 20) + " MiB"};
    }
  }
  if (stream.bad()) return io_problem(name, EIO);
  return text;
}

}  // namespace

Result<std::string> read_file(const std::string& path, std::size_t most) {
  std::error_code ignored;
  if (fs::is_directory(path, ignored)) return io_problem(path, EISDIR);
  errno = 0;
  std::ifstream file(path, std::ios::binary);
  if (!file) return io_problem(path, errno != 0 ? errno : EIO);
  return read_stream(file, path, most);
}

Result<std::string> read_input(const std::string& path) {
  return path == "-" ? read_stream(std::cin, shown(path), most_bytes) : read_file(path, most_bytes);
}

Problems write_output(const std::string& path, std::string_view bytes) {
  if (path == "-") {
    std::cout.write(bytes.data(), static_cast<std::streamsize>(bytes.size())).flush();
    return std::cout ? Problems{} : Problems{io_problem(shown(path), EIO)};
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

Problems unwritable(const std::vector<OutputPath>& outputs, const std::vector<std::string>& inputs) {
  std::vector<OutputPath> before;
  for (const OutputPath& output : outputs) {
    if (!output.path) continue;
    const std::string& path = *output.path;
    if (path.empty()) return {{.code = "usage", .detail = output.option + " needs a file, or - for standard output"}};
    const auto same = [&](const OutputPath& other) {
      return *other.path == path || (path != "-" && *other.path != "-" && same_file(*other.path, path));
    };
    if (const auto twice = std::ranges::find_if(before, same); twice != before.end()) {
      const std::string what = path == "-" ? "standard output" : path;
      return {
          {.code = "usage", .detail = what + " would be written twice, by " + twice->option + " and " + output.option}};
    }
    before.push_back(output);
    if (path == "-") continue;
    if (const int error = error_of(path); error != 0) return {io_problem(path, error)};
    for (const std::string& input : inputs) {
      if (input != "-" && same_file(path, input)) {
        return {{.code = "usage", .detail = output.option + " would write over " + path + ", which is read"}};
      }
    }
  }
  return {};
}

Result<Json> read_graph(const std::string& path, const Limits& limits) {
  const auto text = read_input(path);
  if (!text) return text.problems();
  Result<Json> graph = parse_json(*text, limits);
  if (graph) return graph;
  Problems problems = graph.problems();
  for (Problem& problem : problems) problem.detail = shown(path) + ": " + problem.detail;
  return problems;
}

Result<Json> read_settings(const std::vector<std::string>& words, const Limits& limits) {
  Json parameters = Json::object();
  for (const std::string& word : words) {
    const auto equals = word.find('=');
    if (equals == std::string::npos || equals == 0) {
      return Problem{.code = "usage", .detail = "--set takes name=value, not '" + word + "'"};
    }
    if (parameters.contains(word.substr(0, equals))) {
      return Problem{.code = "usage", .detail = "--set gives '" + word.substr(0, equals) + "' twice"};
    }
    const std::string text = word.substr(equals + 1);
    const auto value = parse_json(text, limits);
    parameters[word.substr(0, equals)] = value ? *value : Json(text);
  }
  return parameters;
}

}  // namespace dini::cli
