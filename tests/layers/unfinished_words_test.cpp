#include <catch2/catch.hpp>
#include <cctype>
#include <string_view>

#include "tests/layers/source_tree.h"

using namespace dini;
using namespace dini::support;

namespace {

/// True when `word` stands in `text` with no letter, digit or underscore beside it.
bool has_word(std::string_view text, std::string_view word) {
  const auto in_word = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; };
  for (std::size_t at = text.find(word); at != std::string_view::npos; at = text.find(word, at + 1)) {
    const std::size_t end = at + word.size();
    if ((at == 0 || !in_word(text[at - 1])) && (end == text.size() || !in_word(text[end]))) return true;
  }
  return false;
}

TEST_CASE("No file leaves a note about work that is not done") {
  // Put together here, so that this file does not find itself.
  const std::string words[] = {std::string("TO") + "DO", std::string("FIX") + "ME"};
  for (const SourceFile& file : read_source_files(DINI_SOURCE_DIR, "")) {
    for (const std::string& word : words) {
      INFO(file.path << " contains the word " << word);
      CHECK_FALSE(has_word(file.text, word));
    }
  }
}

TEST_CASE("A word is found only when it stands alone") {
  CHECK(has_word("// NOTE: later", "NOTE"));
  CHECK(has_word("NOTE", "NOTE"));
  CHECK_FALSE(has_word("NOTES and MY_NOTE", "NOTE"));
}

}  // namespace
