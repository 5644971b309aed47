#include "cli/assets.h"

#include <algorithm>
#include <filesystem>
#include <set>

#include "cli/documents.h"
#include "cli/folders.h"
#include "cli/problems.h"
#include "server/examples.h"

namespace dini::cli {
namespace {

/// Without reading all of what is too large anyway.
Result<std::string> read_bounded(const std::string& path, std::size_t most) {
  std::error_code error;
  const auto size = std::filesystem::file_size(path, error);
  if (!error && size > most) {
    return Problem{.code = "limit-exceeded",
                   .detail = path + ": the file has " + std::to_string(size) + " bytes, at most " +
                             std::to_string(most) + " are accepted"};
  }
  return read_input(path, most);
}

/// Whether a document has a node that is given a file.
bool names_files(const Json& document) {
  const auto nodes = document.is_object() ? document.find("nodes") : document.end();
  if (nodes == document.end() || !nodes->is_object()) return false;
  return std::ranges::any_of(*nodes, [](const Json& node) {
    const auto inputs = node.find("inputs");  // of what is no object there is none
    return inputs != node.end() && inputs->contains("asset");
  });
}

}  // namespace

void Assets::add_option(CLI::App& command) {
  command
      .add_option(
          "--asset", words_,
          "A mesh file (OBJ, PLY, STL or GLB) that the graph names, as name=file, or name=- for standard input; may be "
          "repeated")
      ->allow_extra_args(false);
}

Problems Assets::give_to(const Engine& engine, const std::vector<const Json*>& documents, const Cancel& cancel) const {
  const bool are_named = std::ranges::any_of(documents, [](const Json* document) { return names_files(*document); });
  const std::filesystem::path examples = are_named ? find_examples("") : std::filesystem::path();
  if (!examples.empty()) {
    if (Problems problems = server::load_assets(examples / "assets", engine); !problems.empty()) return problems;
  }
  std::set<std::string> names;
  for (const std::string& word : words_) {
    const auto equals = word.find('=');
    if (equals == std::string::npos || equals == 0 || equals + 1 == word.size()) {
      return {usage_problem("--asset takes name=file, not '" + word + "'")};
    }
    const std::string name = word.substr(0, equals), path = word.substr(equals + 1);
    if (!names.insert(name).second) {
      return {usage_problem("--asset gives the name '" + name + "' twice")};
    }
    const auto bytes = read_bounded(path, engine.limits().asset_bytes);
    if (!bytes) return bytes.problems();
    if (const auto added = engine.add_asset(*bytes, name, cancel); !added) {
      Problems problems = added.problems();
      problems.front().detail = path + ": " + problems.front().detail;
      return problems;
    }
  }
  return {};
}

std::vector<std::string> Assets::paths() const {
  std::vector<std::string> paths;
  for (const std::string& word : words_) {
    const auto equals = word.find('=');
    if (equals != std::string::npos) paths.push_back(word.substr(equals + 1));
  }
  return paths;
}

}  // namespace dini::cli
