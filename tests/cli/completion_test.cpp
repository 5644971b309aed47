// What shells complete, asked of a shell itself; and the manual.

#include <catch2/catch.hpp>
#include <iterator>
#include <set>
#include <sstream>

#include "tests/cli/real_program.h"
#include "tests/support/folder.h"

using namespace dini;
using namespace dini::support;

namespace {

std::set<std::string> distinct_words(const std::string& text) {
  std::istringstream stream(text);
  return {std::istream_iterator<std::string>(stream), {}};
}

/// The words that bash offers for the last one of a line.
std::set<std::string> offered(const std::vector<std::string>& line) {
  const Folder folder;
  folder.write("dini.bash", run({"completion", "bash"}).out);
  std::string words;
  for (const std::string& word : line) words += " '" + word + "'";
  const std::string script = "source '" + (folder.path() / "dini.bash").string() + "'; COMP_WORDS=(" + words +
                             "); COMP_CWORD=" + std::to_string(line.size() - 1) + "; _dini; echo \"${COMPREPLY[@]}\"";
  Program bash({"/bin/bash", "-c", script});
  const Outcome outcome = bash.wait();
  CHECK(outcome.code == 0);
  CHECK(outcome.err.empty());
  return distinct_words(outcome.out);
}

/// The commands of `dini --help`.
std::set<std::string> commands() {
  std::istringstream lines(run({"--help"}).out);
  std::set<std::string> names;
  bool listed = false;
  for (std::string line; std::getline(lines, line);) {
    if (line == "Subcommands:") listed = true;
    if (listed && line.starts_with("  ")) names.insert(line.substr(2, line.find(' ', 2) - 2));
  }
  return names;
}

}  // namespace

TEST_CASE("Bash completes commands, options and the words that an option takes, and leaves files to itself") {
  std::set<std::string> expected = commands();
  REQUIRE(expected.size() > 12);
  std::set<std::string> first = offered({"dini", ""});
  CHECK(first.erase("--help") == 1);
  CHECK(first.erase("--version") == 1);
  CHECK(first == expected);
  CHECK(offered({"dini", "ev"}) == std::set<std::string>{"eval"});
  CHECK(offered({"dini", "eval", "--qual"}) == std::set<std::string>{"--quality"});
  CHECK(offered({"dini", "eval", "graph.json", "--quality", ""}) == std::set<std::string>{"draft", "final"});
  CHECK(offered({"dini", "eval", "graph.json", "--quality", "d"}) == std::set<std::string>{"draft"});
  CHECK(offered({"dini", "store", "p"}) == std::set<std::string>{"purge"});
  CHECK(offered({"dini", "eval", "gra"}).empty());
  CHECK(offered({"dini", "nothing", "-"}).empty());
}

TEST_CASE("The completions of every shell and the manual speak of every command") {
  for (const auto* shell : {"bash", "zsh", "fish"}) {
    const std::string script = run({"completion", shell}).out;
    CAPTURE(shell);
    for (const std::string& command : commands()) CHECK(script.find(command) != std::string::npos);
    CHECK(script.find("quality") != std::string::npos);
  }
  const std::string manual = run({"describe", "--manual"}).out;
  CHECK(manual.starts_with(".TH DINI 1"));
  for (const std::string& command : commands()) CHECK(manual.find(".SS \"dini " + command) != std::string::npos);
  const Outcome wrong = run({"completion", "tcsh"});
  CHECK(wrong.code == 2);
  CHECK(wrong.err.find("bash") != std::string::npos);
}
