// The commands that the pages of documentation show, run as they stand there.

#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <sstream>
#include <unistd.h>

#include "tests/cli/program.h"

using namespace dini;
using namespace dini::support;

namespace {

const std::filesystem::path root = DINI_SOURCE_DIR;

/// The words of every `dini ... examples/... ` between backticks, or on a line of its own.
std::vector<std::vector<std::string>> commands_of(const std::string& page) {
  static const std::regex command("(?:`|\n)dini ((?:eval|inspect|validate) examples/[^`\n#]*)");
  std::vector<std::vector<std::string>> commands;
  for (std::sregex_iterator found(page.begin(), page.end(), command), end; found != end; ++found) {
    std::istringstream text((*found)[1]);
    std::vector<std::string> words = {DINI_PROGRAM};
    for (std::string word; text >> word;) words.push_back(word);
    commands.push_back(std::move(words));
  }
  return commands;
}

std::string text_of(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  REQUIRE(file);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

/// The same in a folder of its own: what is read is in the project, and what is written goes there.
void move_files(std::vector<std::string>& words, const std::filesystem::path& folder) {
  for (std::size_t place = 1; place < words.size(); ++place) {
    const std::string& before = words[place - 1];
    if (before == "-o" || before == "--out" || before == "--report") words[place] = (folder / words[place]).string();
    if (words[place].starts_with("examples/")) words[place] = (root / words[place]).string();
  }
}

}  // namespace

TEST_CASE("Every command on an example that a page shows ends with 0") {
  const auto folder = std::filesystem::temp_directory_path() / ("dini-commands-" + std::to_string(::getpid()));
  std::filesystem::create_directory(folder);
  std::size_t count = 0;
  for (const char* page : {"README.md", "docs/gallery.md", "docs/paper.md", "docs/import.md"}) {
    for (std::vector<std::string>& words : commands_of(text_of(root / page))) {
      move_files(words, folder);
      std::string line;
      for (const std::string& word : words) line += word + " ";
      CAPTURE(page, line);
      const Outcome outcome = Program(words, "").wait();
      CHECK(outcome.code == 0);
      CHECK(outcome.err.empty());
      ++count;
    }
  }
  std::filesystem::remove_all(folder);
  CHECK(count >= 15);
}
