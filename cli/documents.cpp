#include "cli/documents.h"

#include <cerrno>
#include <cstdio>
#include <fstream>
#include <iostream>
#include <iterator>
#include <system_error>
#include <unistd.h>

#include "server/files.h"

namespace dini::cli {
namespace {

Problem io_problem(const std::string& path, int error) {
  return {.code = "io",
          .detail = (path == "-" ? "standard stream" : path) + ": " + std::generic_category().message(error)};
}

}  // namespace

Result<std::string> read_input(const std::string& path) {
  if (path != "-") return server::read_file(path);
  std::string text{std::istreambuf_iterator<char>(std::cin), std::istreambuf_iterator<char>()};
  if (std::cin.bad()) return io_problem(path, EIO);
  return text;
}

Problems write_output(const std::string& path, std::string_view bytes) {
  if (path == "-") {
    std::cout.write(bytes.data(), static_cast<std::streamsize>(bytes.size())).flush();
    return std::cout ? Problems{} : Problems{io_problem(path, EIO)};
  }
  const std::string unfinished = path + "." + std::to_string(::getpid()) + ".part";
  errno = 0;
  std::ofstream file(unfinished, std::ios::binary);
  file.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  file.close();
  if (!file || std::rename(unfinished.c_str(), path.c_str()) != 0) {
    const int error = errno != 0 ? errno : EIO;
    std::remove(unfinished.c_str());
    return {io_problem(path, error)};
  }
  return {};
}

Result<Json> read_graph(const std::string& path, const Limits& limits) {
  const auto text = read_input(path);
  if (!text) return text.problems();
  return parse_json(*text, limits);
}

Result<Json> read_settings(const std::vector<std::string>& words, const Limits& limits) {
  Json parameters = Json::object();
  for (const std::string& word : words) {
    const auto equals = word.find('=');
    if (equals == std::string::npos || equals == 0) {
      return Problem{.code = "usage", .detail = "--set takes name=value, not '" + word + "'"};
    }
    const std::string text = word.substr(equals + 1);
    const auto value = parse_json(text, limits);
    parameters[word.substr(0, equals)] = value ? *value : Json(text);
  }
  return parameters;
}

}  // namespace dini::cli
