// Problems as JSON: the places that clients are told.

#include "service/problem_json.h"

#include <catch2/catch.hpp>

using namespace dini;

namespace {

const Problem in_document = {
    .code = "unknown-port",
    .detail = "No such input.",
    .node = "ring",
    .port = "radios",
    .pointer = "/nodes/ring/inputs/radios",
    .fix = Json::parse(R"([{"op": "move", "from": "/nodes/ring/inputs/radios", "path": "/nodes/ring/inputs/radius"},
                           {"op": "add", "path": "/nodes/ring/inputs/normal", "value": {"path": "/nodes"}}])")};
const Problem in_request = {.code = "unknown-parameter",
                            .detail = "No such parameter.",
                            .pointer = "/parameters/reahc",
                            .fix = Json::parse(R"([{"op": "remove", "path": "/parameters/reahc"}])"),
                            .in_request = true};

}  // namespace

TEST_CASE("Places in a document are told within the request that brought it") {
  const Json told = to_json({in_document, in_request}, Sent::request);
  CHECK(told[0] == Json::parse(R"({"code": "unknown-port", "detail": "No such input.", "node": "ring", "port": "radios",
      "pointer": "/graph/nodes/ring/inputs/radios",
      "fix": [{"op": "move", "from": "/graph/nodes/ring/inputs/radios", "path": "/graph/nodes/ring/inputs/radius"},
              {"op": "add", "path": "/graph/nodes/ring/inputs/normal", "value": {"path": "/nodes"}}]})"));
  CHECK(told[1] == Json::parse(R"({"code": "unknown-parameter", "detail": "No such parameter.",
      "pointer": "/parameters/reahc", "fix": [{"op": "remove", "path": "/parameters/reahc"}]})"));
}

TEST_CASE("Of a document alone, patches are of the document and there are none of the request") {
  const Json told = to_json({in_document, in_request}, Sent::document);
  CHECK(told[0]["pointer"] == "/nodes/ring/inputs/radios");
  CHECK(told[0]["fix"] == in_document.fix);
  CHECK(told[1]["pointer"] == "/parameters/reahc");
  CHECK_FALSE(told[1].contains("fix"));
}

TEST_CASE("The whole document is a place, and no place is none") {
  const Problem whole = {.code = "type-mismatch", .detail = "No object.", .pointer = ""};
  const Problem nowhere = {.code = "deadline", .detail = "Too late."};
  CHECK(to_json({whole}, Sent::request)[0]["pointer"] == "/graph");
  CHECK(to_json({whole}, Sent::document)[0]["pointer"] == "");
  CHECK_FALSE(to_json({nowhere}, Sent::request)[0].contains("pointer"));
  CHECK_FALSE(to_json({nowhere}, Sent::document)[0].contains("pointer"));
}
