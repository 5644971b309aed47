// Fits and derivatives over a running server.

#include "service/requests/description.h"
#include "tests/server/fixture.h"

using namespace dini;
using namespace dini::support;

namespace {

Json finished(int port, const std::string& address) {
  REQUIRE(eventually([&] {
    const std::string state = get(port, address)->json().value("state", "");
    return state != "queued" && state != "running";
  }));
  return get(port, address)->json();
}

Json fit_of(const Json& more) {
  Json body = {{"graph", example_graph()}, {"vary", {{"reach", Json::array()}}}};
  body.update(more);
  return body;
}

/// 0, 1/8, 2/8 ... as the amounts of the example have it when its reach is 7/8.
Json amounts() {
  Json values = Json::array();
  for (int i = 0; i < 8; ++i) values.push_back(i / 8.0);
  return values;
}

}  // namespace

TEST_CASE("A fit is a job whose result is what was found") {
  const RunningReal server;
  const std::string body = fit_of({{"targets", {{"amounts", amounts()}}}}).dump();
  const auto begun = post(server.port(), "/v1/fit", body);
  REQUIRE(begun);
  CAPTURE(begun->body);
  REQUIRE(begun->status == 202);
  CHECK(begun->json()["kind"] == "fit");
  const Json job = finished(server.port(), begun->json()["address"]);
  CAPTURE(job.dump(1));
  REQUIRE(job["state"] == "succeeded");
  CHECK(job["progress"] == 1);
  const Json found = get(server.port(), job["result"])->json();
  CHECK(found["parameters"]["reach"].get<double>() == Approx(0.875).epsilon(1e-8));
  CHECK(found["outcome"] == "converged");
}

TEST_CASE("A fit that cannot begin is refused before it becomes a job") {
  const RunningReal server;
  const auto refused = [&](const Json& body) {
    const auto answer = post(server.port(), "/v1/fit", body.dump());
    REQUIRE(answer);
    CAPTURE(answer->body);
    CHECK(answer->status == 422);
    const Json error = answer->json()["errors"][0];
    return error["code"].get<std::string>() + " " + error.value("pointer", "");
  };
  CHECK(refused(fit_of({{"targets", {{"none", 1}}}})) == "unknown-node /targets/none");
  CHECK(refused(fit_of({{"vary", {{"rech", Json::array()}}}, {"minimize", {"amounts"}}})) ==
        "unknown-parameter /vary/rech");
  CHECK(refused(fit_of({{"target_mesh", "nothing.ply"}})) == "unknown-asset /target_mesh");
  CHECK(refused({{"graph", example_graph()}}) == "required-input-missing /vary");
}

TEST_CASE("A wrong body of a fit or of derivatives is refused with the member that is wrong") {
  const RunningReal server;
  const auto refused = [&](const char* path, const Json& body) {
    const auto answer = post(server.port(), path, body.dump());
    REQUIRE(answer);
    CAPTURE(body.dump(), answer->status, answer->body);
    CHECK(answer->status >= 400);
    CHECK(answer->status < 500);
    const Json error = answer->json()["errors"][0];
    return error.value("pointer", "none") + " " + error["code"].get<std::string>();
  };
  const auto fit = [&](const Json& more) { return refused("/v1/fit", fit_of(more)); };
  const Json targets = {{"amounts", amounts()}};
  CHECK(fit({{"targets", Json::array()}}) == "/targets type-mismatch");
  CHECK(fit({{"targets", {{"amounts", nullptr}}}}) == "/targets/amounts type-mismatch");
  CHECK(fit({{"targets", {{"amounts", {{1, 2, {3}}}}}}}) == "/targets/amounts type-mismatch");
  CHECK(fit({{"targets", targets}, {"vary", Json::array()}}) == "/vary type-mismatch");
  CHECK(fit({{"targets", targets}, {"vary", "reach"}}) == "/vary type-mismatch");
  CHECK(fit({{"targets", targets}, {"vary", {{"reach", {1, 2, 3}}}}}) == "/vary/reach type-mismatch");
  CHECK(fit({{"targets", targets}, {"vary", {{"reach", {"a", "b"}}}}}) == "/vary/reach type-mismatch");
  CHECK(fit({{"targets", targets}, {"vary", {{"reach", {1, 1}}}}}) == "/vary/reach out-of-range");
  CHECK(fit({{"targets", targets}, {"parameters", {{"reach", "x"}}}}) == "/parameters/reach type-mismatch");
  CHECK(fit({{"targets", targets}, {"parameters", {{"reach", 1e9}}}}) == "/parameters/reach out-of-range");
  CHECK(fit({{"targets", targets}, {"parameters", {{"rech", 1}}}}) == "/parameters/rech unknown-parameter");
  CHECK(fit({{"targets", targets}, {"parameters", 3}}) == "/parameters type-mismatch");
  CHECK(fit({{"minimize", {1}}}) == "/minimize type-mismatch");
  CHECK(fit({{"minimize", {"skin"}}, {"starts", 0}}) == "/starts out-of-range");
  CHECK(fit({{"minimize", {"skin"}}, {"evaluations", 1.5}}) == "/evaluations type-mismatch");
  CHECK(fit({{"minimize", {"nothing"}}}) == "/minimize/0 unknown-node");
  CHECK(fit({{"minimize", Json(std::vector<std::string>(300, "amounts"))}}) == "/minimize limit-exceeded");
  CHECK(fit({{"target_mesh", 1}}) == "/target_mesh type-mismatch");
  CHECK(fit({{"mesh", "skin"}, {"targets", targets}}) == "/mesh required-input-missing");
  CHECK(refused("/v1/fit", Json::array()).ends_with("type-mismatch"));
  CHECK(refused("/v1/fit", {{"vary", {{"reach", Json::array()}}}}) == "/graph required-input-missing");
  const auto gradient = [&](Json body) {
    body["graph"] = example_graph();
    return refused("/v1/gradient", body);
  };
  CHECK(gradient({{"of", "skin"}}) == "/of type-mismatch");
  CHECK(gradient({{"of", {1}}}) == "/of type-mismatch");
  CHECK(gradient({{"of", {"skin.x"}}}) == "/of/0 unknown-port");
  CHECK(gradient({{"of", Json(std::vector<std::string>(300, "skin"))}}) == "/of limit-exceeded");
  CHECK(gradient({{"by", {"x"}}}) == "/by/0 unknown-parameter");
  CHECK(gradient({{"by", {{"reach", 1}}}}) == "/by type-mismatch");
  CHECK(gradient({{"parameters", {{"reach", 1e9}}}}) == "/parameters/reach out-of-range");
}

TEST_CASE("A fit that runs tells the best so far, and can be canceled") {
  const RunningReal server;
  // The best of nothing to choose from: it goes on for as many evaluations as it may.
  Json body = fit_of({{"minimize", {"size.area"}}, {"starts", 100}, {"evaluations", 1000000}});
  body["graph"]["nodes"]["size"] = {{"type", "measure"}, {"inputs", {{"model", {{"from", "skin"}}}}}};
  body["graph"]["nodes"]["skin"]["inputs"]["segments"] = 512;
  const auto begun = post(server.port(), "/v1/fit", body.dump());
  REQUIRE(begun);
  REQUIRE(begun->status == 202);
  const std::string address = begun->json()["address"];
  REQUIRE(eventually([&] { return get(server.port(), address)->json().contains("best"); }));
  CHECK(get(server.port(), address)->json()["best"]["parameters"].contains("reach"));
  REQUIRE(post(server.port(), address + "/cancel", "")->status == 200);
  CHECK(finished(server.port(), address)["state"] == "canceled");
}

TEST_CASE("Derivatives come as numbers or as a model in their colors") {
  const RunningReal server;
  const std::string body = Json{{"graph", example_graph()}, {"of", {"amounts", "skin"}}, {"by", {"reach"}}}.dump();
  const auto numbers = post(server.port(), "/v1/gradient", body);
  REQUIRE(numbers);
  CAPTURE(numbers->body.substr(0, 400));
  REQUIRE(numbers->status == 200);
  const Json by = numbers->json()["of"]["amounts"]["by"]["reach"];
  for (std::size_t i = 0; i < 8; ++i) {
    CHECK(by["values"][i].get<double>() == Approx(static_cast<double>(i) / 7).margin(1e-9));
  }
  const auto model = post(server.port(), "/v1/gradient", body, "Accept: model/gltf-binary\r\n");
  REQUIRE(model);
  CHECK(model->status == 200);
  CHECK(model->body.starts_with("glTF"));
}
