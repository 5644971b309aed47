// Every graph in examples/, as it is served, and at the ends of what it lets people change.

#include <catch2/catch.hpp>
#include <random>

#include "gltf/glb_container.h"
#include "gltf/glb_reader.h"
#include "service/version.h"
#include "tests/support/example_engine.h"
#include "tests/support/requests.h"

using namespace dini;
using namespace dini::support;

namespace {

const Engine& engine() {
  static const std::unique_ptr<Engine> one = example_engine();
  return *one;
}

/// The ends of a graph parameter's range, or all its words.
std::vector<Json> extremes(const Json& parameter) {
  if (parameter["type"] == "choice") return parameter["choices"].get<std::vector<Json>>();
  if (parameter["type"] == "boolean") return {true, false};
  return {parameter["min"], parameter["max"]};
}

/// A value that is not the default.
Json another(const Json& parameter) {
  const std::vector<Json> values = extremes(parameter);
  return values[1] == parameter["default"] ? values[0] : values[1];
}

/// Every combination of the ends of some parameters.
std::vector<Json> corners(const Json& parameters) {
  std::vector<Json> settings = {Json::object()};
  for (const auto& [name, parameter] : parameters.items()) {
    std::vector<Json> longer;
    for (const Json& setting : settings) {
      for (const Json& value : extremes(parameter)) {
        longer.push_back(setting);
        longer.back()[name] = value;
      }
    }
    settings = std::move(longer);
  }
  return settings;
}

/// One of a thousand places along each slider, or one of the words.
Json random_setting(const Json& parameters, std::mt19937& random) {
  Json setting = Json::object();
  for (const auto& [name, parameter] : parameters.items()) {
    const std::vector<Json> ends = extremes(parameter);
    if (!ends.front().is_number()) {
      setting[name] = ends[random() % ends.size()];
    } else if (parameter["type"] == "integer") {
      const auto least = ends[0].get<std::int64_t>(), most = ends[1].get<std::int64_t>();
      setting[name] = least + static_cast<std::int64_t>(random()) % (most - least + 1);
    } else {
      const double share = static_cast<double>(random() % 1001) / 1000;
      setting[name] = (1 - share) * ends[0].get<double>() + share * ends[1].get<double>();
    }
  }
  return setting;
}

std::string tag(const Engine& asked, const Asked& request) {
  const auto prepared = prepared_for(asked, request);
  require_none(prepared ? Problems{} : prepared.problems());
  return (*prepared)->model_tag;
}

Json extras_of(const std::string& file) {
  const std::optional<GlbChunks> chunks = split_glb(file);
  REQUIRE(chunks);
  return Json::parse(chunks->json)["asset"]["extras"];
}

}  // namespace

TEST_CASE("Every example is titled, has parameters with labels and bounds, and is valid") {
  const std::map<std::string, Json> all = examples();
  CHECK(all.size() >= 6);
  for (const auto& [id, graph] : all) {
    CAPTURE(id);
    CHECK_FALSE(graph["meta"]["title"].get<std::string>().empty());
    CHECK(graph["meta"]["description"].get<std::string>().ends_with('.'));
    REQUIRE_FALSE(graph["parameters"].empty());
    for (const auto& [name, parameter] : graph["parameters"].items()) {
      CAPTURE(name);
      CHECK(parameter.contains("label"));
      CHECK(parameter["description"].get<std::string>().ends_with('.'));
      CHECK((parameter["type"] == "choice" || (parameter.contains("min") && parameter.contains("max"))));
    }
    const Json verdict = *engine().validate(*engine().read(graph), Json::object(), Cancel());
    CHECK(verdict["valid"] == true);
    CHECK(verdict["errors"] == Json::array());
    CHECK(verdict["blocked"] == Json::array());
    CHECK(verdict["cost"]["vertices"] > 1000);
    if (!graph.contains("ui")) continue;  // the page lays it out
    for (const auto& [node, entry] : graph["nodes"].items()) CHECK(graph["ui"]["nodes"].contains(node));
  }
}

TEST_CASE("Every example is drawn, the draft no finer than the final answer, without warnings") {
  for (const auto& [id, graph] : examples()) {
    CAPTURE(id);
    std::size_t triangles[2] = {0, 0};
    for (const Quality quality : {Quality::draft, Quality::final}) {
      const Result<Answered> answer =
          answered(engine(), {.graph = graph, .parameters = Json::object(), .output = "", .quality = quality});
      require_none(answer ? Problems{} : answer.problems());
      CHECK(answer->report()["warnings"] == Json::array());
      CHECK(answer->report()["model"]["bytes"] == answer->glb->size());
      triangles[quality == Quality::final] = answer->report()["model"]["triangles"];
      CHECK(read_glb(*answer->glb));
    }
    CHECK(triangles[0] > 1000);
    CHECK(triangles[0] <= triangles[1]);
  }
}

TEST_CASE("Every parameter of every example works at its bounds and says so beyond them") {
  for (const auto& [id, graph] : examples()) {
    for (const auto& [name, parameter] : graph["parameters"].items()) {
      for (const Json& value : extremes(parameter)) {
        CAPTURE(id, name, value);
        const Result<Answered> answer = answered(
            engine(), {.graph = graph, .parameters = {{name, value}}, .output = "", .quality = Quality::draft});
        require_none(answer ? Problems{} : answer.problems());
      }
      const Json beyond = parameter.contains("max") ? Json(parameter["max"].get<double>() + 1) : Json("none of them");
      const auto refused = prepared_for(
          engine(), {.graph = graph, .parameters = {{name, beyond}}, .output = "", .quality = Quality::draft});
      CAPTURE(id, name);
      REQUIRE_FALSE(refused);
      CHECK(refused.problems().front().pointer == "/parameters/" + name);
    }
  }
}

TEST_CASE("Every example works with its sliders at every combination of ends, and at thirty settings between them") {
  for (const auto& [id, graph] : examples()) {
    std::vector<Json> settings = corners(graph["parameters"]);
    std::mt19937 random(2017);
    for (int k = 0; k < 30; ++k) settings.push_back(random_setting(graph["parameters"], random));
    for (const Json& setting : settings) {
      CAPTURE(id, setting.dump());
      Asked request{.graph = graph, .parameters = setting, .output = "", .quality = Quality::draft};
      request.triangle_budget = 2000;
      const Result<Answered> answer = answered(engine(), request);
      require_none(answer ? Problems{} : answer.problems());
      CHECK(answer->report()["model"]["triangles"] > 0);
    }
  }
}

TEST_CASE("An entity tag is the same for the same request and another for any other parameter") {
  const std::unique_ptr<Engine> other_owner = example_engine();
  const Engine& other = *other_owner;
  for (const auto& [id, graph] : examples()) {
    CAPTURE(id);
    const Asked request{.graph = graph, .parameters = Json::object(), .output = "", .quality = Quality::final};
    const std::string usual = tag(engine(), request);
    CHECK(usual.size() == 66);
    CHECK(usual == tag(engine(), request));
    CHECK(usual == tag(other, request));
    Json moved = graph;
    moved["$schema"] = "/schema/graph-1.json";
    moved["ui"] = {{"nodes", Json::object()}};
    moved["meta"]["title"] = "Another title";
    CHECK(usual == tag(other, {.graph = moved, .parameters = Json::object(), .output = "", .quality = Quality::final}));
    CHECK(usual != tag(other, {.graph = graph, .parameters = Json::object(), .output = "", .quality = Quality::draft}));
    for (const auto& [name, parameter] : graph["parameters"].items()) {
      CAPTURE(name);
      const Json value = another(parameter);
      CHECK(usual !=
            tag(engine(), {.graph = graph, .parameters = {{name, value}}, .output = "", .quality = Quality::final}));
      CHECK(
          usual ==
          tag(engine(),
              {.graph = graph, .parameters = {{name, parameter["default"]}}, .output = "", .quality = Quality::final}));
    }
  }
}

TEST_CASE("Where its schema is, its title and its drawing are in no tag of a report") {
  const Json graph = examples().at("fig11_patch");
  Json moved = graph;
  moved["$schema"] = "/schema/graph-1.json";
  moved["ui"] = {{"nodes", Json::object()}};
  moved["meta"]["title"] = "Another title";
  const auto report_tag = [](const Json& document) {
    const auto prepared = prepared_for(engine(), {.graph = document});
    require_none(prepared ? Problems{} : prepared.problems());
    return (*prepared)->report_tag;
  };
  CHECK(report_tag(moved) == report_tag(graph));
  moved["parameters"]["strength"]["label"] = "Another label";
  CHECK(report_tag(moved) != report_tag(graph));
}

TEST_CASE("Every parameter of every example changes the file, and the file tells its value") {
  for (const auto& [id, graph] : examples()) {
    const std::string usual =
        file_of(engine(), {.graph = graph, .parameters = Json::object(), .output = "", .quality = Quality::draft});
    for (const auto& [name, parameter] : graph["parameters"].items()) {
      CAPTURE(id, name);
      const Json value = another(parameter);
      const std::string changed =
          file_of(engine(), {.graph = graph, .parameters = {{name, value}}, .output = "", .quality = Quality::draft});
      // A choice may lead to the same points: both rules agree where the generators are simple.
      const bool moves = split_glb(changed)->binary != split_glb(usual)->binary;
      CHECK((moves || parameter["type"] == "choice"));
      CHECK(extras_of(changed)["parameters"][name] == value);
      CHECK(extras_of(usual)["parameters"][name] == parameter["default"]);
      CHECK(extras_of(changed)["fingerprint"] != extras_of(usual)["fingerprint"]);
      CHECK(extras_of(usual)["engine"] == engine_version);
    }
  }
}

TEST_CASE("The boosted ring of figure 4 lies on its horn torus within the announced bound") {
  const Json graph = examples().at("fig04_boosted_ring");
  for (const double height : {0.5, 1.5}) {
    const Result<Answered> answer = answered(
        engine(), {.graph = graph, .parameters = {{"height", height}}, .output = "", .quality = Quality::final});
    require_none(answer ? Problems{} : answer.problems());
    const double bound = answer->report()["model"]["position_error"];
    CHECK(bound < 1e-3);
    const std::optional<Scene> scene = read_glb(*answer->glb);
    REQUIRE(scene);
    const SharedMesh mesh = std::get<SharedMesh>(scene->parts.at(0).shape);
    const double a = (1 + height * height) / 2;
    for (std::size_t i = 0; i < mesh->positions.size(); ++i) {
      const Point p = mesh->positions[i];
      const double off = std::hypot(std::hypot(p.x, p.y) - a, p.z - height) - a;
      REQUIRE(std::abs(off) <= std::sqrt(3.0) * bound);
    }
  }
}
