#include "cli/documents.h"

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <system_error>

#include "cli/problems.h"

namespace dini::cli {
namespace {

namespace fs = std::filesystem;

std::string shown(const std::string& path) { return path == "-" ? "standard stream" : path; }

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

Result<std::string> read_input(const std::string& path, std::size_t most) {
  if (path == "-") return read_stream(std::cin, shown(path), most);
  std::error_code ignored;
  if (fs::is_directory(path, ignored)) return io_problem(path, EISDIR);
  errno = 0;
  std::ifstream file(path, std::ios::binary);
  if (!file) return io_problem(path, errno != 0 ? errno : EIO);
  return read_stream(file, path, most);
}

Problems read_twice(const std::string& graph, std::vector<std::string> files) {
  files.push_back(graph);
  if (std::ranges::count(files, "-") < 2) return {};
  return {usage_problem("standard input (-) can be read once only")};
}

Result<Json> read_settings(const std::vector<std::string>& words, const Limits& limits) {
  Json parameters = Json::object();
  for (const std::string& word : words) {
    const auto equals = word.find('=');
    if (equals == std::string::npos || equals == 0) {
      return usage_problem("--set takes name=value, not '" + word + "'");
    }
    if (parameters.contains(word.substr(0, equals))) {
      return usage_problem("--set gives '" + word.substr(0, equals) + "' twice");
    }
    const std::string text = word.substr(equals + 1);
    const auto value = parse_json(text, limits);
    parameters[word.substr(0, equals)] = value ? *value : Json(text);
  }
  return parameters;
}

}  // namespace dini::cli
