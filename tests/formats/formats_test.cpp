// Every format through every face; one of them exists in these tests only.

#include "nodes/formats.h"

#include <catch2/catch.hpp>
#include <set>

#include "gltf/glb_container.h"
#include "gltf/glb_reader.h"
#include "service/version.h"
#include "tests/cli/program.h"
#include "tests/formats/counts_format.h"
#include "tests/server/fixture.h"
#include "tests/support/requests.h"

using namespace dini;
using namespace dini::support;

namespace {

std::unique_ptr<Engine> engine_with_counts() {
  std::vector<FileFormat> formats(all_formats().begin(), all_formats().end());
  formats.push_back(counts_format());
  return make_engine({}, std::move(formats));
}

/// Two boxes of twelve triangles and a ring.
Json graph() {
  return document({{"i", make("range", {{"count", 2}, {"to", 5}})},
                   {"at", make("vector", {{"x", from("i")}})},
                   {"box", make("box_mesh", {{"segments", 1}})},
                   {"boxes", make("translate", {{"shape", from("box")}, {"vector", from("at")}})},
                   {"ring", make("circle", {{"radius", 2}})},
                   {"out", make("export", {{"model", {from("boxes"), from("ring")}}})}});
}

Outcome run(std::vector<std::string> words, const std::string& input = "") {
  words.insert(words.begin(), DINI_WITH_COUNTS);
  return Program(words, input).wait();
}

std::string contents(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

std::string expected_counts() { return "2 meshes, 24 triangles, by " + std::string(engine_version) + "\n"; }

Json extras_of(const Json& gltf) { return gltf["asset"]["extras"]; }

}  // namespace

TEST_CASE("A format that is one line in the table is in the catalogue") {
  const Json formats = engine_with_counts()->catalogue()["formats"];
  REQUIRE(formats.size() == all_formats().size() + 1);
  CHECK(formats[0]["name"] == "glb");
  CHECK(formats.back() == Json{{"name", "counts"},
                               {"media_types", {"text/x-counts"}},
                               {"extension", ".counts"},
                               {"description", "How much there is."}});
}

TEST_CASE("The engine writes each format, and keeps them apart") {
  const std::unique_ptr<Engine> engine = engine_with_counts();
  std::set<std::string> tags, files;
  for (const FileFormat& format : engine->formats()) {
    CAPTURE(format.name);
    const Result<Answered> answer = answered(*engine, {.graph = graph(), .output = "out", .format = format.name});
    require_none(answer ? Problems{} : answer.problems());
    tags.insert(answer->prepared->model_tag);
    files.insert(*answer->glb);
    const File& file = *answer->computed->model;
    CHECK(file.media_type == format.media_types.front());
    CHECK(file.extension == format.extension);
    CHECK(file.sha256 == sha256(*file.bytes));
    CHECK(engine->find(*answer->prepared)->model == answer->computed->model);
    CHECK(answer->report()["model"]["bytes"] == file.bytes->size());
  }
  CHECK(tags.size() == engine->formats().size());
  CHECK(files.size() == engine->formats().size());
  CHECK(files.contains(expected_counts()));
}

TEST_CASE("What a format says about a file is a warning of the export, and what it cannot write a problem") {
  const std::unique_ptr<Engine> engine = engine_with_counts();
  const Result<Answered> answer = answered(*engine, {.graph = graph(), .format = "counts"});
  REQUIRE(answer);
  CHECK(
      answer->report()["warnings"] ==
      Json::array({{{"code", "left-out"}, {"node", "out"}, {"port", "model"}, {"detail", "only meshes are counted"}}}));
  const Json ring = document({{"ring", make("circle")}, {"out", make("export", {{"model", from("ring")}})}});
  const Result<Answered> nothing = answered(*engine, {.graph = ring, .format = "counts"});
  REQUIRE_FALSE(nothing);
  CHECK(nothing.problems().front().code == "nothing-to-export");
  const auto unknown = prepared_for(*engine, {.graph = graph(), .format = "count"});
  REQUIRE_FALSE(unknown);
  CHECK(unknown.problems().front().pointer == "/format");
  CHECK(unknown.problems().front().detail.find("counts") != std::string::npos);
  CHECK_FALSE(prepared_for(*engine, {.graph = graph(), .preview = {"ring"}, .format = "counts"}));
}

TEST_CASE("A file carries the graph when that is asked for, and can be evaluated again from it") {
  const std::unique_ptr<Engine> engine = make_engine();
  for (const char* format : {"glb", "gltf"}) {
    CAPTURE(format);
    const auto gltf_of = [&](bool embed, const Json& asked) {
      const std::string file = file_of(*engine, {.graph = asked, .format = format, .embed_graph = embed});
      const auto chunks = split_glb(file);
      return Json::parse(chunks ? std::string(chunks->json) : file);
    };
    Json titled = graph();
    titled["meta"] = {{"title", "Two boxes"}};
    CHECK(extras_of(gltf_of(true, titled))["document"] == titled);
    CHECK_FALSE(extras_of(gltf_of(false, titled)).contains("document"));
    const Json again = gltf_of(true, extras_of(gltf_of(true, titled))["document"]);
    CHECK(again == gltf_of(true, titled));
    CHECK(extras_of(again)["fingerprint"] == extras_of(gltf_of(false, titled))["fingerprint"]);
  }
}

TEST_CASE("A file is compressed unless the export or the request says not to") {
  const std::unique_ptr<Engine> engine = make_engine();
  const auto is_compressed = [&](const Json& asked, bool draco) {
    const std::string file = file_of(*engine, {.graph = asked, .draco = draco});
    return Json::parse(split_glb(file)->json).contains("extensionsRequired");
  };
  Json plain = graph();
  plain["nodes"]["out"]["inputs"]["draco"] = false;
  CHECK(is_compressed(graph(), true));
  CHECK_FALSE(is_compressed(graph(), false));
  CHECK_FALSE(is_compressed(plain, true));
  CHECK_FALSE(is_compressed(plain, false));
}

TEST_CASE("A model is asked for by the media type of its format") {
  const RunningOver server(engine_with_counts(), quick_settings());
  const std::string body = Json{{"graph", graph()}}.dump();
  const auto answer = post(server.port(), "/v1/evaluate", body, "Accept: text/x-counts\r\n");
  REQUIRE(answer);
  CHECK(answer->status == 200);
  CHECK(answer->header("content-type") == "text/x-counts");
  CHECK(answer->header("content-disposition").find(".counts\"") != std::string::npos);
  CHECK(answer->body == expected_counts());
  const std::string tag = answer->header("etag");
  CHECK(post(server.port(), "/v1/evaluate", body, "Accept: text/x-counts\r\nIf-None-Match: " + tag + "\r\n")->status ==
        304);
  CHECK(post(server.port(), "/v1/evaluate", body, "If-None-Match: " + tag + "\r\n")->status == 200);
  const auto gltf = post(server.port(), "/v1/evaluate", body, "Accept: model/gltf+json\r\n");
  REQUIRE(gltf->status == 200);
  CHECK(gltf->header("content-type") == "model/gltf+json");
  CHECK(gltf->json()["asset"]["version"] == "2.0");
  const auto refused = post(server.port(), "/v1/evaluate", body, "Accept: model/step\r\n");
  CHECK(refused->status == 406);
  CHECK(refused->json()["errors"][0]["detail"].get<std::string>().find("text/x-counts") != std::string::npos);
}

TEST_CASE("A model is asked for by the name of its format") {
  const RunningOver server(engine_with_counts(), quick_settings());
  const std::string body = Json{{"graph", graph()}}.dump();
  const auto stl = post(server.port(), "/v1/evaluate?format=stl", body);
  REQUIRE(stl->status == 200);
  CHECK(stl->header("content-type") == "model/stl");
  CHECK(stl->header("content-disposition").find(".stl\"") != std::string::npos);
  CHECK(stl->body.size() == 84 + 50 * 24);
  CHECK(post(server.port(), "/v1/evaluate?format=stl", body, "Accept: model/gltf-binary\r\n")->body == stl->body);
  CHECK(post(server.port(), "/v1/evaluate", body, "Accept: model/stl\r\n")->body == stl->body);
  // Beside a report it says what the part is in.
  const auto both = post(server.port(), "/v1/evaluate?format=stl", body, "Accept: multipart/form-data\r\n");
  CHECK(both->header("content-type").starts_with("multipart/form-data"));
  CHECK(both->body.find(stl->body) != std::string::npos);
  CHECK(both->body.find("STL holds no curves; not in the file: ring") != std::string::npos);
  const auto wrong = post(server.port(), "/v1/evaluate?format=sdl", body);
  CHECK(wrong->status == 422);
  CHECK(wrong->json()["errors"][0]["detail"].get<std::string>().find("stl") != std::string::npos);
  CHECK(post(server.port(), "/v1/evaluate?formt=stl", body)->code() == "unknown-member");
}

TEST_CASE("The graph is put into the file when a request says so") {
  const RunningOver server(make_engine(), quick_settings());
  const auto answer = post(server.port(), "/v1/evaluate", Json{{"graph", graph()}, {"embed_graph", true}}.dump());
  REQUIRE(answer->status == 200);
  CHECK(extras_of(Json::parse(split_glb(answer->body)->json))["document"] == graph());
}

TEST_CASE("The end of a file's name says the format, and --format says it better") {
  const Folder folder;
  folder.write("graph.json", graph().dump());
  const std::string path = (folder.path() / "graph.json").string();
  const auto to = [&](const std::string& name) { return (folder.path() / name).string(); };
  CHECK(run({"eval", path, "-o", to("a.counts")}).code == 0);
  CHECK(contents(to("a.counts")) == expected_counts());
  CHECK(run({"eval", path, "-o", to("b.COUNTS")}).code == 0);
  CHECK(contents(to("b.COUNTS")) == expected_counts());
  CHECK(run({"eval", path, "-o", to("c.txt"), "--format", "counts"}).code == 0);
  CHECK(contents(to("c.txt")) == expected_counts());
  CHECK(run({"eval", path, "-o", "-", "--format", "counts"}).out == expected_counts());
  CHECK(run({"eval", path, "-o", to("d.gltf")}).code == 0);
  CHECK(Json::parse(contents(to("d.gltf")))["asset"]["version"] == "2.0");
  CHECK(run({"eval", path, "-o", to("e")}).code == 0);
  CHECK(read_glb(contents(to("e"))));
  CHECK(run({"eval", path, "-o", to("g.glb"), "--no-draco"}).code == 0);
  CHECK(contents(to("g.glb")).find("KHR_draco_mesh_compression") == std::string::npos);
  CHECK(run({"eval", path, "-o", to("h.glb"), "--no-draco", "--preview", "ring"}).code == 2);
  CHECK(run({"eval", path, "-o", to("f.glb"), "--embed-graph"}).code == 0);
  CHECK(extras_of(Json::parse(split_glb(contents(to("f.glb")))->json))["document"] == graph());
}

TEST_CASE("An end that is no format is told before anything is done") {
  const Folder folder;
  folder.write("graph.json", graph().dump());
  const std::string path = (folder.path() / "graph.json").string(), report = (folder.path() / "old.json").string();
  for (const std::vector<std::string>& wrong :
       std::vector<std::vector<std::string>>{{"-o", (folder.path() / "x.step").string()},
                                             {"-o", (folder.path() / "x.glb").string(), "--format", "step"},
                                             {"-o", (folder.path() / "x.gltf").string(), "--preview", "ring"}}) {
    folder.write("old.json", R"({"succeeded": true})");
    std::vector<std::string> words = {"eval", path, "--report", report};
    words.insert(words.end(), wrong.begin(), wrong.end());
    const Outcome outcome = run(words);
    CHECK(outcome.code == 2);
    CHECK(
        outcome.err.find(
            ".glb (glb), .gltf (gltf), .obj (obj), .stl (stl), .ply (ply), .3mf (3mf), .svg (svg), .counts (counts)") !=
        std::string::npos);
    CHECK_FALSE(std::filesystem::exists(wrong[1]));
    CHECK_FALSE(std::filesystem::exists(report));  // it is not that of this run
  }
}
