#include <catch2/catch.hpp>
#include <sstream>

#include "tests/layers/source_tree.h"

using namespace dini;
using namespace dini::support;

namespace {

/// A text without what indents its lines, and without empty ones.
std::string unindented(const std::string& text) {
  std::istringstream lines(text);
  std::string line, result;
  while (std::getline(lines, line)) {
    const std::size_t start = line.find_first_not_of(' ');
    if (start != std::string::npos) result += line.substr(start) + "\n";
  }
  return result;
}

/// The blocks of a page between ```cpp and ```.
std::vector<std::string> code_blocks(const std::string& page) {
  const std::string open = "```cpp\n", close = "```";
  std::vector<std::string> blocks;
  for (std::size_t at = page.find(open); at != std::string::npos; at = page.find(open, at)) {
    at += open.size();
    const std::size_t end = page.find(close, at);
    blocks.push_back(page.substr(at, end - at));
    at = end;
  }
  return blocks;
}

TEST_CASE("The node that newcomers are shown is one of the program's, word by word") {
  std::string page, nodes;
  for (const SourceFile& file : read_source_files(DINI_SOURCE_DIR, "")) {
    if (file.path == "CONTRIBUTING.md") page = file.text;
    if (file.path.starts_with("nodes/")) nodes += unindented(file.text);
  }
  const std::vector<std::string> blocks = code_blocks(page);
  CHECK(blocks.size() >= 2);
  for (const std::string& block : blocks) {
    CAPTURE(block);
    CHECK(nodes.find(unindented(block)) != std::string::npos);
  }
}

}  // namespace
