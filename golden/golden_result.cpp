#include "golden/golden_result.h"

#include <cmath>
#include <cstdio>

namespace dini {
namespace {

constexpr int newest_format = 1;
constexpr std::size_t numbers_of_sample = 10;

std::string number(double value, int digits = 9) {
  char text[32];
  std::snprintf(text, sizeof text, "%.*g", digits, value);
  return text;
}

std::string list(std::initializer_list<double> values) {
  std::string text;
  for (const double value : values) text += (text.empty() ? "" : ", ") + number(value);
  return "[" + text + "]";
}

/// A position as exactly as a file has it; of normals and colors less is compared.
std::string written(const Sample& sample) {
  constexpr int of_position = 7, of_others = 3;
  const auto& [position, normal, color] = sample;
  std::string text;
  const auto add = [&](double value, int digits) { text += (text.empty() ? "" : ", ") + number(value, digits); };
  for (const double value : {position.x, position.y, position.z}) add(value, of_position);
  for (const double value : {normal.x, normal.y, normal.z}) add(value, of_others);
  for (const float value : color) add(value, of_others);
  return "[" + text + "]";
}

std::string written(const ModelFacts& facts) {
  std::string text = "{\n      \"sha256\": \"" + facts.sha256 + "\",\n";
  const auto member = [&](const char* name, const std::string& value) {
    text += std::string("      \"") + name + "\": " + value + ",\n";
  };
  member("position_error", number(facts.position_error));
  member("triangles", std::to_string(facts.triangles));
  member("segments", std::to_string(facts.segments));
  member("points", std::to_string(facts.points));
  member("low", list({facts.low.x, facts.low.y, facts.low.z}));
  member("high", list({facts.high.x, facts.high.y, facts.high.z}));
  member("area", number(facts.area));
  member("volume", number(facts.volume));
  member("euler", std::to_string(facts.euler));
  member("closed", facts.closed ? "true" : "false");
  member("edges", number(facts.edges));
  member("spacing", number(facts.spacing));
  text += "      \"samples\": [";
  for (std::size_t i = 0; i < facts.samples.size(); ++i) {
    text += (i > 0 ? ",\n        " : "\n        ") + written(facts.samples[i]);
  }
  return text + (facts.samples.empty() ? "]\n    }" : "\n      ]\n    }");
}

Vector vector_at(const Json& list, std::size_t from = 0) {
  return {list.at(from).get<double>(), list.at(from + 1).get<double>(), list.at(from + 2).get<double>()};
}

Sample sample_of(const Json& list) {
  Sample sample{vector_at(list), vector_at(list, 3)};
  for (std::size_t c = 0; c < sample.color.size(); ++c)
    sample.color[c] = list.at(numbers_of_sample - 4 + c).get<float>();
  return sample;
}

/// Throws what the library throws where something is missing or of another type.
ModelFacts facts_of(const Json& json) {
  ModelFacts facts{.sha256 = json.at("sha256").get<std::string>(),
                   .position_error = json.at("position_error").get<double>(),
                   .triangles = json.at("triangles").get<std::size_t>(),
                   .segments = json.at("segments").get<std::size_t>(),
                   .points = json.at("points").get<std::size_t>(),
                   .low = vector_at(json.at("low")),
                   .high = vector_at(json.at("high")),
                   .area = json.at("area").get<double>(),
                   .volume = json.at("volume").get<double>(),
                   .euler = json.at("euler").get<long long>(),
                   .closed = json.at("closed").get<bool>(),
                   .edges = json.at("edges").get<double>(),
                   .spacing = json.at("spacing").get<double>()};
  for (const Json& sample : json.at("samples")) facts.samples.push_back(sample_of(sample));
  return facts;
}

}  // namespace

std::string write_golden(const GoldenResult& result) {
  std::string text = "{\n  \"golden\": " + std::to_string(newest_format) + ",\n  \"engine\": \"" + result.engine +
                     "\",\n  \"graph\": \"" + result.graph + "\",\n  \"parameters\": " + result.parameters.dump() +
                     ",\n  \"outputs\": {";
  bool first = true;
  for (const auto& [name, facts] : result.outputs) {
    text += (first ? "\n    " : ",\n    ") + Json(name).dump() + ": " + written(facts);
    first = false;
  }
  return text + (first ? "}\n}\n" : "\n  }\n}\n");
}

Result<GoldenResult> read_golden(const std::string& text) {
  const Json json = Json::parse(text, nullptr, false);
  if (json.is_discarded()) return Problem{.code = "not-json", .detail = "the golden result is not JSON"};
  const auto refused = [](std::string detail) { return Problem{.code = "bad-golden", .detail = std::move(detail)}; };
  if (!json.is_object() || !json.contains("golden")) return refused("this is no golden result");
  if (json["golden"] != newest_format) {
    return refused("the golden result has format " + json["golden"].dump() + ", and this version reads format " +
                   std::to_string(newest_format));
  }
  try {
    GoldenResult result{.engine = json.at("engine").get<std::string>(),
                        .graph = json.at("graph").get<std::string>(),
                        .parameters = json.at("parameters"),
                        .outputs = {}};
    for (const auto& [name, facts] : json.at("outputs").items()) result.outputs.emplace(name, facts_of(facts));
    return result;
  } catch (const nlohmann::detail::exception&) {
    return refused("the golden result lacks a part, or has one of another type; --update-golden makes it anew");
  }
}

}  // namespace dini
