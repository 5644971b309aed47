#include "server/examples.h"

#include <vector>

#include "server/files.h"
#include "server/text.h"

namespace dini::server {
namespace {

Problem bad_example(const std::filesystem::path& path, const std::string& why) {
  return {.code = "bad-example", .detail = path.string() + ": " + why};
}

/// The first thing that is wrong with a document, in words; empty when nothing is.
std::string first_error(const Engine& engine, const Json& graph) {
  const Result<Json> verdict = engine.validate(*engine.read(graph), Json::object(), {});
  if (!verdict) return verdict.problems().front().detail;
  if (verdict->value("valid", false)) return {};
  const Json errors = verdict->value("errors", Json::array());
  return errors.empty() ? "the graph is not valid" : errors.front().value("detail", "the graph is not valid");
}

std::string picture_name(const std::string& id) { return id + ".png"; }

/// Where the pictures of the examples in a folder are; the path of no folder where there are none.
std::filesystem::path picture_folder(const std::filesystem::path& examples) {
  std::error_code error;
  const auto absolute = std::filesystem::absolute(examples, error).lexically_normal();
  for (const auto* place : {"images", "../docs/images/examples"}) {
    auto folder = absolute / place;
    if (std::filesystem::is_directory(folder, error)) return folder;
  }
  return {};
}

}  // namespace

Problems load_assets(const std::filesystem::path& folder, const Engine& engine) {
  std::error_code error;
  if (!std::filesystem::is_directory(folder, error)) return {};
  std::filesystem::directory_iterator entry(folder, error);
  for (; !error && entry != std::filesystem::directory_iterator(); entry.increment(error)) {
    const std::filesystem::path& path = entry->path();
    auto bytes = read_file(path);
    if (!bytes) return bytes.problems();
    const auto added = engine.add_asset(*bytes, path.filename().string(), {});
    if (!added) return {bad_example(path, added.problems().front().detail)};
  }
  if (error) return {bad_example(folder, error.message())};
  return {};
}

Result<Examples> Examples::load(const std::filesystem::path& folder, const Engine& engine) {
  if (Problems problems = load_assets(folder / "assets", engine); !problems.empty()) return problems;
  Examples examples;
  const std::filesystem::path pictures = picture_folder(folder);
  std::error_code error;
  std::filesystem::directory_iterator entry(folder, error);
  for (; !error && entry != std::filesystem::directory_iterator(); entry.increment(error)) {
    const std::filesystem::path& path = entry->path();
    if (path.extension() != ".json") continue;
    auto text = read_file(path);
    if (!text) return text.problems();
    auto graph = parse_json(*text, engine.limits());
    if (!graph) return bad_example(path, graph.problems().front().detail);
    if (const std::string wrong = first_error(engine, *graph); !wrong.empty()) return bad_example(path, wrong);
    const std::string id = path.stem().string();
    examples.graphs_.emplace(id, OrderedJson::parse(*text));
    const auto picture = pictures / picture_name(id);
    std::error_code missing;
    if (pictures.empty() || !std::filesystem::is_regular_file(picture, missing)) continue;
    auto png = read_file(picture);
    if (!png) return png.problems();
    examples.pictures_.emplace(picture_name(id), static_answer(*std::move(png)));
  }
  if (error) return bad_example(folder, error.message());
  return examples;
}

Examples::OrderedJson Examples::list() const {
  OrderedJson list = OrderedJson::array();
  for (const auto& [id, graph] : graphs_) {
    OrderedJson example = {{"id", id}, {"title", id}, {"graph", graph}};
    const OrderedJson meta = graph.value("meta", OrderedJson::object());
    for (const auto* member : {"title", "description", "figure"}) {
      if (meta.contains(member)) example[member] = meta.at(member);
    }
    if (picture(picture_name(id)) != nullptr) example["image"] = "images/examples/" + picture_name(id);
    list.push_back(std::move(example));
  }
  return {{"examples", std::move(list)}};
}

const Examples::OrderedJson* Examples::find(std::string_view id) const {
  const auto found = graphs_.find(id);
  return found != graphs_.end() ? &found->second : nullptr;
}

const StaticAnswer* Examples::picture(std::string_view name) const {
  const auto found = pictures_.find(name);
  return found != pictures_.end() ? &found->second : nullptr;
}

}  // namespace dini::server
