// Each limit of graphs, evaluations and files, set so low that an ordinary request meets it.

#include <map>

#include "service/limit_table.h"
#include "tests/server/fixture.h"
#include "tests/support/documents.h"
#include "tests/support/import_bytes.h"

using namespace dini;
using namespace dini::support;

namespace {

/// A row of balls, their middle measured, beside a ball alone.
Json balls() {
  Json graph =
      document({{"k", make("range", {{"from", 0}, {"to", 9}, {"count", 12}})},
                {"offset", make("vector", {{"x", from("k")}})},
                {"origin", make("point")},
                {"place", make("translate", {{"shape", from("origin")}, {"vector", from("offset")}})},
                {"row", make("sphere_mesh", {{"center", from("place")}, {"radius", {{"parameter", "radius"}}}})},
                {"rings", make("circle", {{"center", from("place")}})},
                {"size", make("measure", {{"model", from("row")}})},
                {"out", make("export", {{"model", from("row")}})}});
  graph["parameters"] = {{"radius", {{"type", "number"}, {"default", 1}}}};
  return graph;
}

/// What came of a request: the code of its problem, or what else is said.
using Said = std::function<std::string(int port)>;

Said asking(const std::string& path, Json more = Json::object()) {
  return [path, more](int port) {
    Json body = {{"graph", balls()}};
    body.update(more);
    const auto answer = post(port, path, body.dump());
    REQUIRE(answer);
    return answer->status == 200 ? "done" : answer->code();
  };
}

/// How a sweep over two radii ends.
std::string swept(int port) {
  const auto answer =
      post(port, "/v1/sweeps", Json{{"graph", balls()}, {"list", {{{"radius", 1}}, {{"radius", 2}}}}}.dump());
  REQUIRE(answer);
  if (answer->status != 200) return answer->code();
  const Json last = answer->lines().back();
  return last["status"] == "succeeded" ? "done" : last["errors"][0]["code"].get<std::string>();
}

/// Whether the second of two evaluations knew what the first one made.
std::string repeated(int port) {
  const auto evaluate = [&](const char* quality) {
    const auto answer = post(port, "/v1/evaluate", Json{{"graph", balls()}, {"quality", quality}}.dump(),
                             "Accept: application/json\r\n");
    REQUIRE(answer->status == 200);
    return answer->json();
  };
  evaluate("final");
  return evaluate("draft")["nodes"]["place"]["cached"] == true ? "known" : "made again";
}

/// How long a drawing of these nodes is.
Said drawing(const std::string& node) {
  return [node](int port) {
    const auto answer = post(port, "/v1/evaluate", Json{{"graph", balls()}, {"preview", {node}}}.dump());
    REQUIRE(answer->status == 200);
    return std::to_string(answer->body.size());
  };
}

/// What an evaluation says that uses the first of two uploaded files.
std::string uploaded(int port) {
  const auto add = [&](const std::string& bytes) {
    return ask(port, "POST /v1/assets HTTP/1.1\r\nHost: localhost\r\nContent-Type: model/obj\r\nContent-Length: " +
                         std::to_string(bytes.size()) + "\r\n\r\n" + bytes);
  };
  const auto first = add(std::string(quad_obj));
  if (first->status != 201) return first->code();
  REQUIRE(add("# another\n" + std::string(quad_obj))->status == 201);
  const Json graph = document({{"file", make("import", {{"asset", first->json()["sha256"]}})},
                               {"out", make("export", {{"model", from("file")}})}});
  const auto answer = post(port, "/v1/evaluate", Json{{"graph", graph}}.dump());
  return answer->status == 200 ? "done" : answer->code();
}

struct EvaluationRow {
  std::uint64_t value;
  Said said;
  std::string expected;  ///< empty: anything but what is said without the limit
};

std::map<std::string, EvaluationRow> evaluation_rows() {
  const Said evaluated = asking("/v1/evaluate");
  return {
      {"body_bytes", {100, evaluated, "body-too-large"}},
      {"json_depth", {4, evaluated, "not-json"}},
      {"json_values", {10, evaluated, "limit-exceeded"}},
      {"string_bytes", {8, evaluated, "limit-exceeded"}},
      {"nodes", {7, evaluated, "limit-exceeded"}},
      {"links", {6, evaluated, "limit-exceeded"}},
      {"samples", {11, evaluated, "limit-exceeded"}},
      {"vertices", {1000, evaluated, "limit-exceeded"}},
      {"triangles", {1000, evaluated, "limit-exceeded"}},
      {"request_bytes", {1000, evaluated, "limit-exceeded"}},
      {"work", {1000, evaluated, "limit-exceeded"}},
      {"sweep_variants", {1, swept, "limit-exceeded"}},
      {"sweep_work", {1000, swept, "limit-exceeded"}},
      {"sweep_milliseconds", {1, swept, "deadline"}},
      {"interactive_milliseconds", {1, evaluated, "deadline"}},
      {"cache_bytes", {0, repeated, "made again"}},
      {"previews", {1, asking("/v1/evaluate", {{"preview", {"row", "rings"}}}), "limit-exceeded"}},
      {"preview_elements", {1, drawing("rings"), ""}},
      {"preview_points", {1, drawing("place"), ""}},
      {"measures", {1, asking("/v1/evaluate", {{"measures", {"size", "k"}}}), "limit-exceeded"}},
      {"measured_values", {2, asking("/v1/evaluate", {{"measures", {"k"}}}), "limit-exceeded"}},
      {"asset_bytes", {10, uploaded, "body-too-large"}},
      {"asset_vertices", {3, uploaded, "limit-exceeded"}},
      {"asset_triangles", {1, uploaded, "limit-exceeded"}},
      {"asset_store_bytes", {300, uploaded, "unknown-asset"}},
  };
}

}  // namespace

TEST_CASE("Every limit of graphs, evaluations and files is met where it is set, and nowhere else") {
  const auto table = evaluation_rows();
  CHECK(table.size() == evaluation_limits().size());
  const RunningReal usual;
  for (const Limit<Limits>& limit : evaluation_limits()) {
    const std::string name(limit.name);
    CAPTURE(name);
    const auto row = table.find(name);
    REQUIRE(row != table.end());
    const auto& [value, said, expected] = row->second;
    Limits limits;
    limit.set(limits, value);
    const std::string otherwise = said(usual.port());
    const RunningReal server(quick_settings(), limits);
    const std::string told = said(server.port());
    if (!expected.empty()) CHECK(told == expected);
    CHECK(told != otherwise);
  }
}
