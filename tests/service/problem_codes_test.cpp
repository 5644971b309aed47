// The table of problem codes, held against the words in the sources.

#include "service/problem_codes.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <map>
#include <regex>
#include <set>

#include "tests/layers/source_tree.h"

using namespace dini;
using namespace dini::support;

namespace {

/// Words with hyphens that are something else: values and names of headers, and of a member of OpenAPI.
const std::set<std::string> other_words = {"no-store",       "no-cache",      "keep-alive",       "same-origin",
                                           "cross-origin",   "if-range",      "content-encoding", "transfer-encoding",
                                           "content-length", "no-referrer",   "x-problem-codes",  "require-corp",
                                           "respond-async",  "after-current", "cross-site"};

std::vector<std::string> matches(const std::string& text, const std::regex& pattern) {
  std::vector<std::string> words;
  for (std::sregex_iterator match(text.begin(), text.end(), pattern), end; match != end; ++match) {
    words.push_back((*match)[1].str());
  }
  return words;
}

/// Every word that the C++ sources of the program use as a code, or that looks like one, with a file that does so.
std::map<std::string, std::string> words_in_sources() {
  // A literal of words with hyphens; and a literal of one word where a problem is made.
  static const std::regex hyphenated(R"(\"([a-z]+(?:-[a-z]+)+)\")");
  static const std::regex made(
      R"((?:\bcode = |\b(?:Problem|Failure|FileError|FileNote|LiteralProblem|Warning|problem|warn)\s*[({]+\s*|return \{)\"([a-z]+)\")");
  std::map<std::string, std::string> words;
  for (const auto* folder :
       {"geometry", "graph", "gltf", "formats", "golden", "nodes", "service", "jobs", "server", "cli"}) {
    for (const SourceFile& file : read_source_files(DINI_SOURCE_DIR, folder)) {
      if (!file.path.ends_with(".cpp") && !file.path.ends_with(".h")) continue;
      if (file.path == "service/problem_codes.cpp" || file.path == "server/operation.cpp") continue;
      for (const std::regex& pattern : {hyphenated, made}) {
        for (const std::string& word : matches(file.text, pattern)) words.emplace(word, file.path);
      }
    }
  }
  return words;
}

}  // namespace

// One test for both: reading the sources with sanitizers takes long.
TEST_CASE("Every code that the sources use is in the table of problem codes, and no other") {
  const auto words = words_in_sources();
  CHECK(words.contains("type-mismatch"));
  CHECK(words.contains("degenerate"));
  CHECK(words.contains("busy"));
  for (const auto& [word, path] : words) {
    CAPTURE(word, path);
    const bool known = find_problem_code(word) != nullptr || other_words.contains(word);
    CHECK(known);
  }
  for (const ProblemCode& known : problem_codes()) {
    CAPTURE(known.code);
    CHECK(words.contains(std::string(known.code)));
  }
}

TEST_CASE("Every code stands once in the table, with one sentence, and a status where it is an answer") {
  std::set<std::string_view> seen;
  for (const ProblemCode& known : problem_codes()) {
    CAPTURE(known.code);
    CHECK(seen.insert(known.code).second);
    CHECK(known.meaning.ends_with('.'));
    const bool never_answered = known.kind == ProblemKind::warning || known.kind == ProblemKind::program;
    CHECK((known.status == 0) == never_answered);
    const bool is_failure = known.status == 0 || (known.status >= 400 && known.status < 600);
    CHECK(is_failure);
  }
  CHECK(find_problem_code("no-such-code") == nullptr);
}
