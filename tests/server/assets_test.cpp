#include "tests/server/fixture.h"
#include "tests/support/documents.h"

using namespace dini;
using namespace dini::support;

namespace {

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
  CHECK(answer->json()["title"] == "Invalid asset");
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
  CHECK(post(server.port(), "/v1/assets/x", std::string((1 << 20) + 1, ' '))->status == 405);
  CHECK(get(server.port(), "/version")->json()["limits"]["asset_bytes"] == 3 << 20);
}

TEST_CASE("An uploaded file is told of and given back by its hash, and graphs find it after a restart") {
  const Folder folder;
  auto settings = quick_settings();
  settings.data = folder.path();
  const std::string file = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
  const std::string hash = dini::to_hex(dini::sha256(file));
  const std::string graph =
      document({{"mesh", make("import", {{"asset", hash}})}, {"out", make("export", {{"model", from("mesh")}})}})
          .dump();
  const std::string request = "{\"graph\":" + graph + "}";
  {
    const RunningReal server(settings);
    CHECK(head(server.port(), "/v1/assets/" + hash)->status == 404);
    CHECK(post(server.port(), "/v1/evaluate", request)->code() == "unknown-asset");
    CHECK(ask(server.port(), upload(file))->json()["sha256"] == hash);
    CHECK(post(server.port(), "/v1/evaluate", request)->status == 200);
  }
  const RunningReal server(settings);
  const auto told = head(server.port(), "/v1/assets/" + hash);
  CHECK(told->status == 200);
  CHECK(told->header("content-length") == std::to_string(file.size()));
  CHECK(get(server.port(), "/v1/assets/" + hash)->body == file);
  CHECK(post(server.port(), "/v1/evaluate", request)->status == 200);

  folder.write("assets/" + hash, "v 0 0 0");
  CHECK(get(server.port(), "/v1/assets/" + hash)->status == 404);
  for (const std::string& wrong :
       {std::string(".."), std::string("%2e%2e%2fdini.db"), std::string(64, '0'), std::string(64, 'A'), hash + "0"}) {
    CHECK(get(server.port(), "/v1/assets/" + wrong)->status == 404);
  }
}

TEST_CASE("Without a data folder uploaded files are in memory, and are given back from there") {
  const RunningReal server;
  const std::string file = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
  const std::string address = "/v1/assets/" + ask(server.port(), upload(file))->json()["sha256"].get<std::string>();
  CHECK(head(server.port(), address)->status == 200);
  CHECK(get(server.port(), address)->body == file);
}

TEST_CASE("Files that stored graphs name stay when others have to make room, and what does not fit is told of") {
  const Folder folder;
  auto settings = quick_settings();
  settings.data = folder.path();
  settings.asset_file_bytes = 1 << 16;
  const RunningReal server(settings);
  const auto add = [&](char letter) {
    return ask(server.port(), upload("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n# " + std::string(30'000, letter)));
  };
  const std::string first = add('a')->json()["sha256"];
  const std::string graph =
      document({{"mesh", make("import", {{"asset", first}})}, {"out", make("export", {{"model", from("mesh")}})}})
          .dump();
  REQUIRE(ask(server.port(),
              "PUT /v1/graphs/it HTTP/1.1\r\nHost: localhost\r\nContent-Type: application/json\r\n"
              "If-None-Match: *\r\nContent-Length: " +
                  std::to_string(graph.size()) + "\r\n\r\n" + graph)
              ->status == 201);
  const std::string second = add('b')->json()["sha256"];
  CHECK(add('c')->status == 201);
  CHECK(head(server.port(), "/v1/assets/" + first)->status == 200);
  CHECK(head(server.port(), "/v1/assets/" + second)->status == 404);

  const auto large = ask(server.port(), upload("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n# " + std::string(1 << 16, 'x')));
  CHECK(large->status == 507);
  CHECK(large->code() == "storage-full");
  CHECK(get(server.port(), "/v1/graphs/it/outputs/out.glb")->status == 200);
}
