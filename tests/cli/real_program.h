#pragma once

// The program as it is installed, over the real engine, in a folder of its own.

#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "geometry/json.h"
#include "tests/cli/program.h"

namespace dini::support {

inline Outcome run(const std::vector<std::string>& words, const std::string& input = "") {
  std::vector<std::string> all = {DINI_PROGRAM};
  all.insert(all.end(), words.begin(), words.end());
  return Program(all, input).wait();
}

inline std::string contents(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  REQUIRE(file);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

inline Json json_in(const std::filesystem::path& path) { return Json::parse(contents(path)); }

inline bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

inline std::filesystem::path example(const std::string& id) {
  return std::filesystem::path(DINI_EXAMPLES) / (id + ".json");
}

}  // namespace dini::support
