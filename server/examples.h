#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <string_view>

#include "server/static_answer.h"
#include "service/engine.h"

namespace dini::server {

/// Gives the engine every file of a folder under its own name; nothing if there is no such folder. Problems name the
/// file.
Problems load_assets(const std::filesystem::path& folder, const Engine& engine);

/// The built-in graphs, read once and checked by the engine: an example that is wrong keeps the server from starting.
class Examples {
 public:
  /// Members stay in the order of the file: a form shows the parameters as their author arranged them.
  using OrderedJson = nlohmann::ordered_json;

  /// No examples.
  Examples() = default;

  /// Every `<id>.json` of a folder, after the mesh files in its folder `assets`. The picture of each is `<id>.png` in
  /// its folder `images`, as installed, or in `docs/images/examples` beside the folder, as in the source tree; an
  /// example without one is shown without. Problems name the file.
  static Result<Examples> load(const std::filesystem::path& folder, const Engine& engine);

  /// {"examples": [{"id", "title", "description", "figure", "image", "graph"}]}, ordered by id. `image` is the address
  /// of the picture, relative to that of the server; it is missing where there is none.
  OrderedJson list() const;

  /// The document itself, or nothing.
  const OrderedJson* find(std::string_view id) const;

  /// The picture of the given file name, `<id>.png`, or nothing. Held in memory: no request reaches the file system.
  const StaticAnswer* picture(std::string_view name) const;

 private:
  std::map<std::string, OrderedJson, std::less<>> graphs_;
  std::map<std::string, StaticAnswer, std::less<>> pictures_;  ///< by file name
};

}  // namespace dini::server
