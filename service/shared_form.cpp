#include "service/shared_form.h"

#include "service/engine.h"

namespace dini {
namespace {

Json json_of(const Warning& warning) {
  Json json = {{"code", warning.code}, {"detail", warning.detail}, {"port", warning.port}};
  if (warning.place) json["place"] = {warning.place->axis, warning.place->index};
  return json;
}

Warning warning_of(const Json& json) {
  Warning warning{json.at("code").get<std::string>(), json.at("detail").get<std::string>(),
                  json.at("port").get<std::string>()};
  if (json.contains("place")) {
    warning.place = {json["place"].at(0).get<std::size_t>(), json["place"].at(1).get<std::size_t>()};
  }
  return warning;
}

Json json_of(const File& file) {
  Json json = {{"media_type", file.media_type}, {"extension", file.extension}, {"sha256", to_hex(file.sha256)},
               {"vertices", file.vertices},     {"triangles", file.triangles}, {"position_error", file.position_error}};
  if (const auto& errors = file.attribute_errors) json["errors"] = {errors->normal, errors->uv, errors->color};
  return json;
}

}  // namespace

std::string shared_form(const NodeResult& result) {
  const SharedFile file = (*std::get<SharedColumn<SharedFile>>(result.columns.at(0)))[0];
  Json head = {{"file", json_of(*file)}, {"warnings", Json::array()}};
  for (const auto& said : result.warnings) {
    Json node = {{"fingerprint", to_hex(said->fingerprint)}, {"warnings", Json::array()}};
    for (const Warning& warning : said->warnings) node["warnings"].push_back(json_of(warning));
    head["warnings"].push_back(std::move(node));
  }
  return dump(head) + "\n" + *file->bytes;
}

std::optional<NodeResult> read_shared_form(std::string_view form) try {
  const auto end = form.find('\n');
  if (end == std::string_view::npos) return std::nullopt;
  const Json head = Json::parse(form.substr(0, end));
  const Json& told = head.at("file");
  const auto sha256 = digest_from_hex(told.at("sha256").get<std::string>());
  if (!sha256) return std::nullopt;
  File file{.media_type = told.at("media_type").get<std::string>(),
            .extension = told.at("extension").get<std::string>(),
            .bytes = share(std::string(form.substr(end + 1))),
            .sha256 = *sha256,
            .vertices = told.at("vertices").get<std::size_t>(),
            .triangles = told.at("triangles").get<std::size_t>(),
            .position_error = told.at("position_error").get<double>()};
  if (told.contains("errors")) {
    const Json& errors = told["errors"];
    file.attribute_errors = {errors.at(0).get<double>(), errors.at(1).get<double>(), errors.at(2).get<double>()};
  }
  NodeResult result;
  Column<SharedFile> files(1);
  files.set(0, std::make_shared<const File>(std::move(file)));
  result.columns.emplace_back(std::make_shared<const Column<SharedFile>>(std::move(files)));
  for (const Json& node : head.at("warnings")) {
    const auto fingerprint = digest_from_hex(node.at("fingerprint").get<std::string>());
    if (!fingerprint) return std::nullopt;
    NodeWarnings said{*fingerprint, {}};
    for (const Json& warning : node.at("warnings")) said.warnings.push_back(warning_of(warning));
    result.warnings.push_back(std::make_shared<const NodeWarnings>(std::move(said)));
  }
  return result;
} catch (const Json::exception&) {
  return std::nullopt;
}

}  // namespace dini
