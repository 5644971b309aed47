#include <future>
#include <set>

#include "tests/server/fixture.h"

using namespace dini;
using namespace dini::support;

TEST_CASE("The model comes as GLB by default, with its tag, times and name") {
  const Running server;
  const auto answer = post(server.port(), "/v1/evaluate", toy_body({{"bytes", 5}}));
  REQUIRE(answer);
  CHECK(answer->status == 200);
  CHECK(answer->body == "ggggg");
  CHECK(answer->header("content-type") == "model/gltf-binary");
  CHECK(answer->header("cache-control") == "no-cache");
  CHECK(answer->header("content-disposition") == "inline; filename=\"model.glb\"");
  CHECK(answer->header("etag").starts_with("\"toy-"));
  CHECK(answer->header("server-timing").find("evaluate;dur=1.500") != std::string::npos);
  CHECK_FALSE(answer->header("x-request-id").empty());
}

TEST_CASE("Accept chooses the model, the report, or both in one answer") {
  const Running server;
  const std::string body = toy_body({{"bytes", 3}});
  const auto report = post(server.port(), "/v1/evaluate", body, "Accept: application/json\r\n");
  REQUIRE(report);
  CHECK(report->json()["model"]["bytes"] == 3);
  CHECK(report->header("etag").starts_with("W/\"toy-"));
  CHECK(report->json()["etag"] == post(server.port(), "/v1/evaluate", body)->header("etag"));

  const auto both = post(server.port(), "/v1/evaluate", body, "Accept: text/plain, multipart/form-data;q=0.9\r\n");
  REQUIRE(both);
  const std::string type = both->header("content-type");
  REQUIRE(type.starts_with("multipart/form-data; boundary="));
  const std::string boundary = "--" + type.substr(30);
  CHECK(both->body.starts_with(boundary + "\r\nContent-Disposition: form-data; name=\"report\"\r\n"));
  CHECK(both->body.find("name=\"model\"; filename=\"model.glb\"\r\nContent-Type: model/gltf-binary\r\n\r\nggg\r\n") !=
        std::string::npos);
  CHECK(both->body.ends_with("\r\n" + boundary + "--\r\n"));
  CHECK(post(server.port(), "/v1/evaluate", body, "Accept: multipart/form-data\r\n")->body == both->body);

  CHECK(post(server.port(), "/v1/evaluate", body, "Accept: model/obj\r\n")->status == 406);
  CHECK(post(server.port(), "/v1/evaluate", body, "Accept: */*\r\n")->body == "ggg");
}

TEST_CASE("A client that has the result gets 304 and nothing is evaluated") {
  const Running server;
  const std::string body = toy_body({{"bytes", 6}});
  const std::string tag = post(server.port(), "/v1/evaluate", body)->header("etag");
  const std::size_t before = toy::counters().started;
  for (const std::string& known : {tag, "\"other\", " + tag, "W/" + tag}) {
    const auto answer = post(server.port(), "/v1/evaluate", body, "If-None-Match: " + known + "\r\n");
    REQUIRE(answer);
    CHECK(answer->status == 304);
    CHECK(answer->body.empty());
    CHECK(answer->header("etag") == tag);
  }
  CHECK(post(server.port(), "/v1/evaluate", body, "If-None-Match: \"other\"\r\n")->status == 200);
  CHECK(toy::counters().started == before);
  // On a POST a star says nothing about a result.
  CHECK(post(server.port(), "/v1/evaluate", body, "If-None-Match: *\r\n")->status == 200);
  CHECK(post(server.port(), "/v1/evaluate", toy_body({{"problem", "check-failed"}}), "If-None-Match: *\r\n")->status ==
        422);
}

TEST_CASE("Everybody gets a report of their own, with a tag of its own, though the result is shared") {
  const Running server;
  const std::string accept = "Accept: application/json\r\n";
  const auto body = [](const std::string& id, int milliseconds) {
    const Json out = {{"type", "toy"}, {"inputs", {{"bytes", 77}, {"milliseconds", milliseconds}}}};
    return Json{{"graph", {{"format", 1}, {"nodes", {{"out", out}, {id, {{"type", "toy"}}}}}}}}.dump();
  };
  const std::size_t before = toy::counters().started;
  auto first =
      std::async(std::launch::async, [&] { return post(server.port(), "/v1/evaluate", body("first", 300), accept); });
  REQUIRE(eventually([&] { return toy::counters().started > before; }));
  const auto second = post(server.port(), "/v1/evaluate", body("second", 300), accept);
  const auto third = post(server.port(), "/v1/evaluate", body("third", 0), accept);
  const auto answer = first.get();
  REQUIRE((answer && second && third));
  CHECK(toy::counters().started == before + 1);
  CHECK(answer->json()["nodes"].contains("first"));
  CHECK(second->json()["nodes"].contains("second"));
  CHECK(third->json()["nodes"].contains("third"));
  CHECK(second->json()["nodes"].size() == 2);
  CHECK(second->json()["etag"] == third->json()["etag"]);
  CHECK(second->header("etag") != third->header("etag"));
  const std::string tag = third->header("etag");
  CHECK(post(server.port(), "/v1/evaluate", body("third", 0), accept + "If-None-Match: " + tag + "\r\n")->status ==
        304);
  CHECK(post(server.port(), "/v1/evaluate", body("fourth", 0), accept + "If-None-Match: " + tag + "\r\n")->status ==
        200);
}

TEST_CASE("Every error has the same form") {
  const Running server;
  const std::vector<std::pair<std::optional<Answer>, int>> answers = {
      {get(server.port(), "/nowhere"), 404},
      {get(server.port(), "/v1/evaluate"), 405},
      {post(server.port(), "/healthz", "{}"), 405},
      {post(server.port(), "/v1/evaluate", "{"), 400},
      {post(server.port(), "/v1/evaluate", "[]"), 422},
      {post(server.port(), "/v1/evaluate", toy_body({{"invalid", "out-of-range"}})), 422},
      {post(server.port(), "/v1/evaluate", toy_body({{"problem", "degenerate"}})), 422},
      {post(server.port(), "/v1/evaluate", toy_body({{"throws", true}})), 500},
      {ask(server.port(), "nonsense\r\n\r\n"), 400},
      {ask(server.port(), "POST /v1/validate HTTP/1.1\r\nHost: localhost\r\n\r\n"), 411},
  };
  for (const auto& [answer, status] : answers) {
    REQUIRE(answer);
    CAPTURE(answer->body);
    CHECK(answer->status == status);
    CHECK(answer->header("content-type") == "application/problem+json");
    CHECK(answer->header("x-content-type-options") == "nosniff");
    CHECK(answer->header("content-security-policy").find("frame-ancestors 'none'") != std::string::npos);
    const Json problem = answer->json();
    CHECK(problem["status"] == status);
    CHECK(problem["instance"] == answer->header("x-request-id"));
    CHECK(problem["type"] == "/problems/" + problem["errors"][0]["code"].get<std::string>());
    CHECK_FALSE(problem["title"].get<std::string>().empty());
    CHECK(problem["detail"].get<std::string>().size() <= 200);
    CHECK(answer->body.find("secret") == std::string::npos);
  }
  CHECK(get(server.port(), "/v1/evaluate")->header("allow") == "POST, OPTIONS");
  CHECK(post(server.port(), "/healthz", "{}")->header("allow") == "GET, HEAD, OPTIONS");
}

TEST_CASE("The title of a problem fits its code") {
  const Running server;
  const auto title = [](const std::optional<Answer>& answer) { return answer->json()["title"]; };
  CHECK(title(get(server.port(), "/version?nothing=1")) == "Unknown member");
  CHECK(title(post(server.port(), "/v1/evaluate", toy_body({{"invalid", "out-of-range"}}))) == "Out of range");
  CHECK(title(get(server.port(), "/nowhere")) == "There is nothing here");
  CHECK(title(get(server.port(), "/problems/nothing")) == "There is nothing here");
}

TEST_CASE("A body is read strictly and every mistake is listed") {
  const Running server;
  const auto answer = post(server.port(), "/v1/evaluate",
                           R"({"grahp":{},"quality":"best","deadline_ms":0,"output":7,"parameters":[],"a/b~":1})");
  REQUIRE(answer);
  CHECK(answer->status == 422);
  std::map<std::string, std::string> codes;
  const Json problem = answer->json();
  for (const Json& error : problem["errors"]) codes[error["pointer"]] = error["code"];
  CHECK(codes == std::map<std::string, std::string>{{"/grahp", "unknown-member"},
                                                    {"/a~1b~0", "unknown-member"},
                                                    {"/graph", "required-input-missing"},
                                                    {"/parameters", "type-mismatch"},
                                                    {"/output", "type-mismatch"},
                                                    {"/quality", "not-in-choices"},
                                                    {"/deadline_ms", "out-of-range"}});
  CHECK(answer->body.find("did you mean \\\"graph\\\"?") != std::string::npos);
}

TEST_CASE("Large models arrive whole") {
  const Running server;
  const auto answer = post(server.port(), "/v1/evaluate", toy_body({{"bytes", 20'000'000}}));
  REQUIRE(answer);
  CHECK(answer->body == std::string(20'000'000, 'g'));
}

TEST_CASE("A preview comes beside the model or instead of it") {
  const Running server;
  Json body = Json::parse(toy_body({{"bytes", 3}}));
  body["preview"] = {"ring"};
  const std::string alone = body.dump();
  const auto glb = post(server.port(), "/v1/evaluate", alone);
  REQUIRE(glb);
  CHECK(glb->body == "ppp");
  CHECK(glb->header("content-disposition") == "inline; filename=\"preview.glb\"");
  const std::string tag = glb->header("etag");
  CHECK(post(server.port(), "/v1/evaluate", alone, "If-None-Match: " + tag + "\r\n")->status == 304);
  const std::string parts = "Accept: multipart/form-data\r\n";
  const auto without_model = post(server.port(), "/v1/evaluate", alone, parts);
  CHECK(without_model->body.find("name=\"model\"") == std::string::npos);
  CHECK(without_model->body.find("name=\"preview\"; filename=\"preview.glb\"\r\nContent-Type: "
                                 "model/gltf-binary\r\n\r\nppp\r\n--") != std::string::npos);

  body["output"] = "out";
  const auto both = post(server.port(), "/v1/evaluate", body.dump(), parts);
  REQUIRE(both);
  const std::size_t report = both->body.find("name=\"report\""), model = both->body.find("\r\n\r\nggg\r\n"),
                    preview = both->body.find("\r\n\r\nppp\r\n");
  CHECK(report < model);
  CHECK(model < preview);
  CHECK(preview != std::string::npos);
  CHECK(post(server.port(), "/v1/evaluate", body.dump())->body == "ggg");
  CHECK(post(server.port(), "/v1/evaluate", body.dump())->header("etag") != tag);
}

TEST_CASE("Requests that differ in their preview or their budget are told apart") {
  const Running server;
  std::set<std::string> tags;
  for (const Json& more : {Json::object(), Json{{"preview", {"a"}}}, Json{{"preview", {"a", "b"}}},
                           Json{{"triangle_budget", 500}}, Json{{"triangle_budget", 501}}}) {
    Json body = Json::parse(toy_body({{"bytes", 3}}));
    body.update(more);
    for (int again = 0; again < 2; ++again) {
      const auto answer = post(server.port(), "/v1/evaluate", body.dump());
      REQUIRE(answer);
      CHECK(answer->status == 200);
      tags.insert(answer->header("etag"));
    }
  }
  CHECK(tags.size() == 5);
}

TEST_CASE("A preview and a budget of the wrong type are refused") {
  const Running server;
  for (const auto& [name, wrong] : std::vector<std::pair<std::string, Json>>{{"preview", "ring"},
                                                                             {"preview", {1, 2}},
                                                                             {"preview", {{"ring", true}}},
                                                                             {"preview", {1, "ring"}},
                                                                             {"triangle_budget", 1.5},
                                                                             {"triangle_budget", "many"},
                                                                             {"triangle_budget", nullptr}}) {
    CAPTURE(name, wrong);
    Json body = Json::parse(toy_body({{"bytes", 3}}));
    body[name] = wrong;
    const auto answer = post(server.port(), "/v1/evaluate", body.dump());
    REQUIRE(answer);
    CHECK(answer->status == 422);
    CHECK(answer->json()["errors"][0]["code"] == "type-mismatch");
    CHECK(answer->json()["errors"][0]["pointer"] == "/" + name);
  }
}

TEST_CASE("A drag that never rests shows frames when it asks for what runs to be finished") {
  auto settings = quick_settings();
  settings.compute_queue = 4;
  const Running server(settings);
  const std::size_t before = toy::counters().started;
  std::vector<std::unique_ptr<Client>> drag;
  for (int i = 0; i < 30; ++i) {
    drag.push_back(std::make_unique<Client>(server.port()));
    drag.back()->send(post_text("/v1/evaluate", toy_body({{"milliseconds", 100 + i}, {"bytes", 100 + i}}),
                                "Supersede-Key: slider\r\nSupersede: after-current\r\n"));
    REQUIRE(eventually([&] { return i > 0 || toy::counters().started > before; }));
  }
  int shown = 0, replaced = 0;
  for (auto& client : drag) {
    const auto answer = client->receive();
    REQUIRE(answer);
    shown += answer->status == 200 ? 1 : 0;
    replaced += answer->code() == "superseded" ? 1 : 0;
  }
  CHECK(shown >= 2);
  CHECK(shown + replaced == 30);
  CHECK(post(server.port(), "/v1/evaluate", toy_body({}), "Supersede: later\r\n")->code() == "not-in-choices");
}
