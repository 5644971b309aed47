// Mesh files through a real socket and the real engine.

#include "tests/server/fixture.h"
#include "tests/support/import_bytes.h"

using namespace dini;
using namespace dini::support;

namespace {

std::optional<Answer> upload(int port, std::string_view bytes) {
  return ask(port,
             "POST /v1/assets HTTP/1.1\r\nHost: localhost\r\nContent-Type: application/octet-stream\r\n"
             "Content-Length: " +
                 std::to_string(bytes.size()) + "\r\n\r\n" + std::string(bytes));
}

Json graph_with(const std::string& asset) {
  return {{"format", 1},
          {"nodes",
           {{"file", {{"type", "import"}, {"inputs", {{"asset", asset}}}}},
            {"out", {{"type", "export"}, {"inputs", {{"model", {{"from", "file"}}}}}}}}}};
}

std::string body_with(const std::string& asset) { return Json{{"graph", graph_with(asset)}}.dump(); }

}  // namespace

TEST_CASE("A file of every format is uploaded, named by its hash, and evaluated") {
  const RunningReal server;
  for (const auto& [bytes, format] : std::vector<std::pair<std::string, std::string>>{{std::string(quad_obj), "obj"},
                                                                                      {std::string(quad_ply), "ply"},
                                                                                      {std::string(quad_stl), "stl"},
                                                                                      {quad_glb(), "glb"}}) {
    CAPTURE(format);
    CHECK(post(server.port(), "/v1/evaluate", body_with(std::string(64, '0')))->code() == "unknown-asset");
    const auto uploaded = upload(server.port(), bytes);
    REQUIRE(uploaded);
    REQUIRE(uploaded->status == 201);
    CHECK(uploaded->json()["format"] == format);
    CHECK(uploaded->json()["triangles"] == 2);
    const std::string hash = uploaded->json()["sha256"];
    const auto model = post(server.port(), "/v1/evaluate", body_with(hash));
    REQUIRE(model);
    CHECK(model->status == 200);
    CHECK(model->body.starts_with("glTF"));
    const auto again =
        post(server.port(), "/v1/evaluate", body_with(hash), "If-None-Match: " + model->header("etag") + "\r\n");
    CHECK(again->status == 304);
    // A GLB lies level in the file, where y is up, and so does the square in the graph, where z is.
    const Json seen =
        post(server.port(), "/v1/inspect", Json{{"graph", graph_with(hash)}, {"node", "file"}}.dump())->json();
    CHECK(seen["values"][0]["bounds"] == Json::parse("[[0,0,0],[1,1,0]]"));
  }
}

TEST_CASE("What of a file is left out is told by the upload and by the report of a graph that uses it") {
  const RunningReal server;
  const auto plain = upload(server.port(), quad_obj);
  REQUIRE(plain);
  CHECK(plain->json()["warnings"] == Json::array());
  const auto uploaded = upload(server.port(), "\xEF\xBB\xBFv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 1 2\n");
  REQUIRE(uploaded);
  REQUIRE(uploaded->status == 201);
  const std::string sentence = "1 face has fewer than three corners and is left out, the first at line 5";
  CHECK(uploaded->json()["warnings"] == Json{sentence});
  const auto report =
      post(server.port(), "/v1/evaluate", body_with(uploaded->json()["sha256"]), "Accept: application/json\r\n");
  REQUIRE(report);
  CHECK(report->json()["warnings"] ==
        Json::array({{{"code", "left-out"}, {"node", "file"}, {"port", "asset"}, {"detail", sentence}}}));
}

TEST_CASE("A format is told by its content, behind a byte order mark or not") {
  const RunningReal server;
  const std::string mark = "\xEF\xBB\xBF";
  CHECK(upload(server.port(), mark + std::string(quad_ply))->json()["format"] == "ply");
  CHECK(upload(server.port(), mark + std::string(quad_obj))->json()["format"] == "obj");
  CHECK(upload(server.port(), "PLY \r\n" + std::string(quad_ply.substr(4)))->json()["format"] == "ply");
  for (const auto& [bytes, said] : std::vector<std::pair<std::string, std::string>>{
           {mark + "{\"asset\":{}}", "it looks like JSON"},
           {std::string("\xFF\xFEv\0 \0", 6), "it is text in UTF-16; save it as ASCII or UTF-8"}}) {
    const auto answer = upload(server.port(), bytes);
    CHECK(answer->status == 422);
    CHECK(answer->json()["errors"][0]["detail"].get<std::string>().find(said) != std::string::npos);
  }
}

TEST_CASE("A file that takes too long to read is left at the deadline, and the server goes on") {
  dini::Limits limits;
  limits.interactive_milliseconds = 100;  // more than a small file takes, also on a busy machine with sanitizers
  auto settings = quick_settings();
  settings.body_deadline = std::chrono::seconds(5);
  const RunningReal server(settings, limits);
  std::string text;
  while (text.size() < (std::size_t{15} << 20)) text += "v 0.123456789 0.25 1e-7\n";
  const auto answer = upload(server.port(), text);
  REQUIRE(answer);
  CHECK(answer->status == 504);
  CHECK(answer->code() == "deadline");
  // A busy machine may need more than that for a small one too, but not every time.
  CHECK(eventually([&] { return upload(server.port(), quad_obj)->status == 201; }));
}

TEST_CASE("A graph that names a file that is not there blames the node") {
  const RunningReal server;
  const auto answer = post(server.port(), "/v1/evaluate", body_with("shell"));
  REQUIRE(answer);
  CHECK(answer->status == 422);
  const Json error = answer->json()["errors"][0];
  CHECK(error["code"] == "unknown-asset");
  CHECK(error["node"] == "file");
  CHECK(error["port"] == "asset");
  CHECK(error["pointer"] == "/graph/nodes/file/inputs/asset");
  CHECK(answer->json()["blocked"] == Json::array({"out"}));
}

TEST_CASE("Hostile files are refused, and the server stays as it was") {
  const RunningReal server;
  const std::string huge_ply =
      "ply\nformat binary_little_endian 1.0\nelement vertex 4000000000\nproperty float x\nproperty float y\n"
      "property float z\nend_header\n";
  Json draco = quad_document(), far = quad_document();
  draco["extensionsRequired"] = {"KHR_draco_mesh_compression"};
  far["buffers"][0]["uri"] = "file:///etc/passwd";
  const long before = resident_kib();
  for (const std::string& bytes :
       {std::string(), std::string(64, '\0'), std::string("{\"asset\":{}}"), std::string("hello"), huge_ply,
        std::string("solid\nfacet\nvertex 0 0\n"), std::string(80, 'x') + "\xff\xff\xff\x7f", quad_glb().substr(0, 61),
        glb_of(draco.dump(), quad_binary()), glb_of(far.dump(), quad_binary()),
        glb_of(std::string(1 << 20, '['), "")}) {
    const auto answer = upload(server.port(), bytes);
    REQUIRE(answer);
    CHECK(answer->status == 422);
    CHECK(answer->code() == "invalid-asset");
  }
  CHECK(resident_kib() - before < 64 * 1024);
  CHECK(get(server.port(), "/healthz")->status == 200);
}

TEST_CASE("Uploaded files make room for later ones, the least used first") {
  dini::Limits limits;
  limits.asset_store_bytes = 5'000;
  const RunningReal server(quick_settings(), limits);
  const auto file = [](int n) { return "# " + std::to_string(n) + "\n" + std::string(quad_obj); };
  std::vector<std::string> hashes;
  for (int n = 0; n < 20; ++n) {
    hashes.push_back(upload(server.port(), file(n))->json()["sha256"]);
    CHECK(post(server.port(), "/v1/inspect", Json{{"graph", graph_with(hashes[0])}, {"node", "file"}}.dump())->status ==
          200);
  }
  CHECK(post(server.port(), "/v1/evaluate", body_with(hashes[1]))->code() == "unknown-asset");
  CHECK(post(server.port(), "/v1/evaluate", body_with(hashes[19]))->status == 200);
}

TEST_CASE("The example with a mesh is served with its file") {
  auto settings = quick_settings();
  settings.examples = DINI_EXAMPLES;
  const RunningReal server(settings);
  const Json graph = get(server.port(), "/v1/examples/fig12_imported_mesh")->json();
  REQUIRE(graph.is_object());
  CHECK(post(server.port(), "/v1/evaluate", Json{{"graph", graph}}.dump())->status == 200);
  CHECK(post(server.port(), "/v1/evaluate", body_with("vase.obj"))->status == 200);
}
