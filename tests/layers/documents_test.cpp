// What the pages of documentation say about the tree of files, held against it.

#include <algorithm>
#include <catch2/catch.hpp>
#include <filesystem>
#include <map>
#include <regex>

#include "tests/layers/include_rules.h"
#include "tests/layers/source_tree.h"

using namespace dini;
using namespace dini::support;

namespace {

const std::filesystem::path root = DINI_SOURCE_DIR;

/// The pages by their path; those of decisions tell of their time, and name what has gone since.
std::vector<SourceFile> pages(bool with_decisions) {
  std::vector<SourceFile> found;
  for (SourceFile& file : read_source_files(root, "")) {
    const bool decision = file.path.starts_with("docs/decisions/") && !file.path.ends_with("README.md");
    if (file.path.ends_with(".md") && (with_decisions || !decision)) found.push_back(std::move(file));
  }
  return found;
}

std::vector<std::string> matches(const std::string& text, const char* pattern) {
  const std::regex expression(pattern);
  std::vector<std::string> found;
  for (std::sregex_iterator match(text.begin(), text.end(), expression), end; match != end; ++match) {
    found.push_back((*match)[1]);
  }
  return found;
}

/// A file, a folder, or a header and its source by their common name.
bool is_in_tree(const std::string& path) {
  return std::filesystem::exists(root / path) || std::filesystem::exists(root / (path + ".h")) ||
         std::filesystem::exists(root / (path + ".cpp"));
}

/// The layers that the diagram of a page draws, each with those that its arrows lead to.
std::map<std::string, std::vector<std::string>> arrows(const std::string& page) {
  const std::size_t begin = page.find("```mermaid"), end = page.find("```", begin + 3);
  std::map<std::string, std::vector<std::string>> drawn;
  static const std::regex line("\n  ([a-z]+)(\\[[^\\]]*\\])?( --> ([a-z]+))?");
  const std::string diagram = page.substr(begin, end - begin);
  for (std::sregex_iterator match(diagram.begin(), diagram.end(), line), none; match != none; ++match) {
    std::vector<std::string>& below = drawn[(*match)[1]];
    if ((*match)[4].matched) below.push_back((*match)[4]);
  }
  return drawn;
}

bool may_include(const std::string& layer, const std::string& other) {
  const auto rules = layer_rules();
  return std::any_of(rules.begin(), rules.end(), [&](const LayerRule& rule) {
    return rule.layer == layer &&
           std::find(rule.may_include.begin(), rule.may_include.end(), other + "/") != rule.may_include.end();
  });
}

}  // namespace

TEST_CASE("The diagram of the architecture has every layer, and no arrow that the rules forbid") {
  const std::vector<SourceFile> all = pages(false);
  const auto page =
      std::find_if(all.begin(), all.end(), [](const SourceFile& file) { return file.path == "docs/architecture.md"; });
  REQUIRE(page != all.end());
  const auto drawn = arrows(page->text);
  for (const LayerRule& rule : layer_rules()) {
    CAPTURE(rule.layer);
    CHECK(drawn.contains(std::string(rule.layer)));
  }
  for (const auto& [layer, below] : drawn) {
    for (const std::string& other : below) {
      CAPTURE(layer, other);
      CHECK(may_include(layer, other));
    }
  }
}

TEST_CASE("Every file and folder that a page names is there") {
  for (const SourceFile& page : pages(false)) {
    if (page.path == "CHANGELOG.md") continue;
    const char* path =
        "`((?:algebra|geometry|gltf|graph|golden|nodes|service|jobs|server|cli|tests|bench|scripts|cmake|docs|"
        "examples|web)/[A-Za-z0-9_./-]*)`";
    for (const std::string& name : matches(page.text, path)) {
      CAPTURE(page.path, name);
      // Built, and so not in the tree.
      CHECK((name.starts_with("web/dist") || is_in_tree(name)));
    }
  }
}

TEST_CASE("Every link of a page to a file leads to one") {
  for (const SourceFile& page : pages(true)) {
    for (const std::string& link : matches(page.text, "\\]\\(([^)#:]+)(?:#[^)]*)?\\)")) {
      CAPTURE(page.path, link);
      CHECK(std::filesystem::exists(root / std::filesystem::path(page.path).parent_path() / link));
    }
  }
}

TEST_CASE("Every decision is listed with its number and its title") {
  std::string list;
  std::vector<SourceFile> records;
  for (SourceFile& file : read_source_files(root, "docs/decisions")) {
    if (file.path.ends_with("README.md")) {
      list = file.text;
    } else {
      records.push_back(std::move(file));
    }
  }
  CHECK(records.size() > 20);
  for (const SourceFile& record : records) {
    const std::string name = record.path.substr(record.path.rfind('/') + 1);
    const std::string number = std::to_string(std::stoi(name.substr(0, 4)));
    const std::string title = record.text.substr(0, record.text.find('\n'));
    CAPTURE(name, title);
    REQUIRE(title.starts_with("# " + number + ". "));
    CHECK(list.find("\n" + number + ". [" + title.substr(title.find(". ") + 2) + "](" + name + ")") !=
          std::string::npos);
  }
}
