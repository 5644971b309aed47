#include "tests/server/fixture.h"

namespace {

using namespace dini::support;

std::string upload(const std::string& bytes, const std::string& type = "application/octet-stream") {
  return "POST /v1/assets HTTP/1.1\r\nHost: localhost\r\nContent-Type: " + type +
         "\r\nContent-Length: " + std::to_string(bytes.size()) + "\r\n\r\n" + bytes;
}

}  // namespace

TEST_CASE("An uploaded file is answered with its hash, as any of the types of meshes") {
  const Running server;
  for (const std::string type : {"application/octet-stream", "model/gltf-binary", "model/obj", "application/x-ply",
                                 "text/plain; charset=utf-8", "Model/OBJ"}) {
    const auto answer = ask(server.port(), upload("v 0 0 0", type));
    REQUIRE(answer);
    CHECK(answer->status == 201);
    CHECK(answer->json() == dini::Json{{"sha256", std::string(64, 'a')},
                                       {"bytes", 7},
                                       {"format", "obj"},
                                       {"vertices", 3},
                                       {"triangles", 1},
                                       {"warnings", {"1 line (l) is left out"}}});
  }
  for (const std::string type : {"application/json", "multipart/form-data", "application/x-www-form-urlencoded", ""}) {
    CHECK(ask(server.port(), upload("v 0 0 0", type))->code() == "unsupported-media-type");
  }
  CHECK(get(server.port(), "/v1/assets")->status == 405);
}

TEST_CASE("A file that cannot be used is a problem of its own") {
  const Running server;
  const auto answer = ask(server.port(), upload("broken"));
  REQUIRE(answer);
  CHECK(answer->status == 422);
  CHECK(answer->code() == "invalid-asset");
  CHECK(answer->json()["title"] == "The file cannot be used");
  CHECK(ask(server.port(), upload("large"))->code() == "limit-exceeded");
}

TEST_CASE("Files have a limit of their own, and other bodies keep theirs") {
  dini::Limits limits;
  limits.asset_bytes = 3 << 20;
  auto settings = quick_settings();
  settings.body_deadline = std::chrono::seconds(5);
  const Running server(settings, limits);
  CHECK(ask(server.port(), upload(std::string(3 << 20, 'v')))->status == 201);
  CHECK(ask(server.port(), upload(std::string((3 << 20) + 1, 'v')))->status == 413);
  CHECK(post(server.port(), "/v1/evaluate", std::string((1 << 20) + 1, ' '))->status == 413);
  CHECK(post(server.port(), "/v1/assets/x", std::string((1 << 20) + 1, ' '))->status == 404);
  CHECK(get(server.port(), "/version")->json()["limits"]["asset_bytes"] == 3 << 20);
}
