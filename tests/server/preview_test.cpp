// Previews, budgets and fixes through a real socket and the real engine.

#include "tests/server/fixture.h"
#include "tests/support/documents.h"

using namespace dini;
using namespace dini::support;

namespace {

const Json tube_graph = document({{"ring", make("circle", {{"radius", 2}})},
                                  {"tau", make("point_pair", {{"split", 0.5}})},
                                  {"skin", make("tube", {{"shape", from("ring")}, {"radius", 0.1}})},
                                  {"out", make("export", {{"model", from("skin")}})},
                                  {"loose", make("boost", {{"shape", from("skin")}})}});

std::string body_with(const Json& more) {
  Json body = {{"graph", tube_graph}};
  body.update(more);
  return body.dump();
}

/// The content of a named part of a multipart answer; empty when there is none.
std::string part_of(const Answer& answer, const std::string& name) {
  const std::size_t head = answer.body.find("name=\"" + name + "\"");
  if (head == std::string::npos) return "";
  const std::size_t begin = answer.body.find("\r\n\r\n", head) + 4;
  const std::string type = answer.header("content-type");
  return answer.body.substr(begin, answer.body.find("\r\n--" + type.substr(type.find('=') + 1), begin) - begin);
}

}  // namespace

TEST_CASE("A model, its report and a preview come in one answer, each as it comes alone") {
  const RunningReal server;
  const auto both = post(server.port(), "/v1/evaluate", body_with({{"output", "out"}, {"preview", {"ring", "tau"}}}),
                         "Accept: multipart/form-data\r\n");
  REQUIRE(both);
  REQUIRE(both->status == 200);
  const auto model = post(server.port(), "/v1/evaluate", body_with({{"output", "out"}}));
  const auto preview = post(server.port(), "/v1/evaluate", body_with({{"preview", {"tau", "ring"}}}));
  CHECK(part_of(*both, "model") == model->body);
  CHECK(part_of(*both, "preview") == preview->body);
  const Json report = Json::parse(part_of(*both, "report"));
  CHECK(report["preview"]["nodes"] == Json({"ring", "tau"}));
  CHECK(report["preview"]["bytes"] == preview->body.size());
  CHECK(report["milliseconds"].contains("preview"));
  REQUIRE(report["warnings"].size() == 1);
  CHECK(report["warnings"][0]["node"] == "loose");
  const auto again = post(server.port(), "/v1/evaluate", body_with({{"preview", {"tau", "ring"}}}),
                          "If-None-Match: " + preview->header("etag") + "\r\n");
  CHECK(again->status == 304);
}

TEST_CASE("Runs of nodes are counted and timed by their types") {
  const RunningReal server;
  for (int i = 0; i < 2; ++i)
    REQUIRE(post(server.port(), "/v1/evaluate", body_with({{"output", "out"}}))->status == 200);
  const std::string metrics = get(server.port(), "/metrics")->body;
  for (const std::string type : {"circle", "tube", "export"}) {
    CHECK(metrics.find("\ndini_node_runs_total{type=\"" + type + "\"} 1\n") != std::string::npos);
    CHECK(metrics.find("\ndini_node_seconds_total{type=\"" + type + "\"} ") != std::string::npos);
  }
  const std::string told = "# TYPE dini_node_runs_total counter\n";
  CHECK(metrics.find(told) != std::string::npos);
  CHECK(metrics.find(told) == metrics.rfind(told));
}

TEST_CASE("Wrong previews and budgets are problems at their place, and their limits have names") {
  const RunningReal server;
  const auto refused = [&](const Json& more) {
    const auto answer = post(server.port(), "/v1/evaluate", body_with(more));
    REQUIRE(answer);
    CHECK(answer->status == 422);
    return answer->json()["errors"][0];
  };
  CHECK(refused({{"preview", {"ring", "rong"}}})["pointer"] == "/preview/1");
  CHECK(refused({{"preview", {"ring.circel"}}})["detail"].get<std::string>().find("\"circle\"") != std::string::npos);
  CHECK(refused({{"preview", {"loose"}}})["pointer"] == "/graph/nodes/loose/inputs/generator");
  CHECK(refused({{"preview", std::vector<std::string>(10'000, "ring")}})["code"] == "limit-exceeded");
  CHECK(refused({{"triangle_budget", 500}})["pointer"] == "/triangle_budget");
  CHECK(refused({{"triangle_budget", 99}, {"quality", "draft"}})["fix"][0]["value"] == 100);
  const Json limits = get(server.port(), "/version")->json()["limits"];
  for (const char* name : {"previews", "preview_elements", "preview_points"}) CHECK(limits[name] > 0);
}

TEST_CASE("Only nodes behind the ones to blame are blocked") {
  const RunningReal server;
  Json broken = tube_graph;
  broken["nodes"]["ring"]["inputs"]["radius"] = -1;
  broken["nodes"]["lost"] = make("translate", {{"shape", from("loose")}});
  const auto answer = post(server.port(), "/v1/evaluate", Json{{"graph", broken}}.dump());
  REQUIRE(answer->status == 422);
  CHECK(answer->json()["errors"].size() == 1);
  CHECK(answer->json()["blocked"] == Json({"out", "skin"}));
}

TEST_CASE("Validation tells every wire it can, and fixes") {
  const RunningReal server;
  Json broken = tube_graph;
  broken["nodes"]["ring"]["inputs"]["radius"] = -1;
  const Json verdict = post(server.port(), "/v1/validate", Json{{"graph", broken}}.dump())->json();
  CHECK(verdict["valid"] == false);
  CHECK(verdict["errors"].size() == 2);
  for (const Json& error : verdict["errors"]) CHECK((error["node"] == "loose" || error["fix"][0]["value"] == 0));
  CHECK(verdict["wires"]["ring.circle"]["type"] == "circle");
  CHECK(verdict["wires"]["skin.mesh"]["type"] == "mesh");
  CHECK(verdict["wires"]["loose.shape"]["type"] == "mesh");
}

TEST_CASE("The catalogue tells handles and what singular inputs do") {
  const RunningReal server;
  const Json catalogue = get(server.port(), "/v1/nodes")->json();
  for (const Json& node : catalogue["nodes"]) {
    if (node["id"] != "circle") continue;
    CHECK(node["inputs"][0]["handle"] == Json({{"kind", "position"}}));
    CHECK(node["inputs"][1]["handle"] == Json({{"kind", "direction"}, {"at", "center"}}));
    CHECK(node["degenerate"].size() == 2);
  }
}
