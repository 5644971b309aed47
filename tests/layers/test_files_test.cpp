// The habits of the tests themselves: see CONTRIBUTING.md, "Add a test".

#include <catch2/catch.hpp>
#include <cctype>
#include <regex>
#include <set>
#include <sstream>

#include "tests/layers/source_tree.h"

using namespace dini;
using namespace dini::support;

namespace {

/// The titles of the test cases of a file.
std::vector<std::string> titles_of(const std::string& text) {
  static const std::regex title("\nTEST_CASE\\(\\s*\"((?:[^\"\\\\]|\\\\.)*)");
  std::vector<std::string> titles;
  for (std::sregex_iterator found(text.begin(), text.end(), title), end; found != end; ++found) {
    titles.push_back((*found)[1]);
  }
  return titles;
}

/// A sentence begins with a capital letter, has a few words, and its period is left out. A semicolon would make two
/// tests of it in CMake, neither of which exists, and so both would pass.
bool is_sentence(const std::string& title) {
  std::istringstream words(title);
  std::size_t count = 0;
  for (std::string word; words >> word;) ++count;
  return count >= 3 && std::isupper(static_cast<unsigned char>(title.front())) != 0 && !title.ends_with('.') &&
         title.find(';') == std::string::npos;
}

std::vector<SourceFile> test_sources() {
  std::vector<SourceFile> sources = read_source_files(DINI_SOURCE_DIR, "tests");
  std::erase_if(sources,
                [](const SourceFile& file) { return !file.path.ends_with(".cpp") && !file.path.ends_with(".h"); });
  return sources;
}

}  // namespace

TEST_CASE("Files with test cases, and no others, end in _test.cpp") {
  for (const SourceFile& file : test_sources()) {
    CAPTURE(file.path);
    CHECK(file.path.ends_with("_test.cpp") == !titles_of(file.text).empty());
  }
}

TEST_CASE("Every file with test cases is built into a test program") {
  std::set<std::string> built;
  for (const SourceFile& file : read_source_files(DINI_SOURCE_DIR, "tests")) {
    if (!file.path.ends_with("CMakeLists.txt")) continue;
    const std::string folder = file.path.substr(0, file.path.rfind('/') + 1);
    std::istringstream words(file.text);
    for (std::string word; words >> word;) built.insert(folder + word);
  }
  for (const SourceFile& file : test_sources()) {
    CAPTURE(file.path);
    if (file.path.ends_with("_test.cpp")) CHECK(built.contains(file.path));
  }
}

TEST_CASE("Titles of test cases are sentences") {
  for (const SourceFile& file : test_sources()) {
    for (const std::string& title : titles_of(file.text)) {
      CAPTURE(file.path, title);
      CHECK(is_sentence(title));
    }
  }
  CHECK_FALSE(is_sentence("a boost fixes its own point"));
  CHECK_FALSE(is_sentence("A boost fixes its own point."));
  CHECK_FALSE(is_sentence("Boosts"));
  CHECK_FALSE(is_sentence("A boost fixes its own point; it moves others"));
}

TEST_CASE("Files with test cases use the namespaces of the program and open none of them") {
  for (const SourceFile& file : test_sources()) {
    // Its functions have the names of the C library's, which would be found outside.
    if (!file.path.ends_with("_test.cpp") || file.path == "tests/algebra/elementary_test.cpp") continue;
    CAPTURE(file.path);
    CHECK(file.text.find("\nusing namespace dini") != std::string::npos);
    CHECK(file.text.find("\nnamespace dini") == std::string::npos);
  }
}

TEST_CASE("What several tests share is never in a namespace that is called test") {
  static const std::regex opened("\nnamespace dini::test");
  for (const SourceFile& file : test_sources()) {
    CAPTURE(file.path);
    CHECK_FALSE(std::regex_search(file.text, opened));
  }
}

TEST_CASE("Tests wait for states and not for times") {
  // Put together here, so that this file does not find itself. The toy engine takes time on purpose.
  const std::string words[] = {std::string("sleep") + "_for", std::string("sleep") + "_until",
                               std::string("u") + "sleep("};
  for (const SourceFile& file : test_sources()) {
    if (file.path == "tests/support/eventually.h" || file.path == "tests/support/toy_engine.cpp") continue;
    CAPTURE(file.path);
    for (const std::string& word : words) CHECK(file.text.find(word) == std::string::npos);
  }
}
