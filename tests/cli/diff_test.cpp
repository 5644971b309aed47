// `dini diff`: graphs by what they mean, models by their shape.

#include "tests/cli/graph_folder.h"
#include "tests/cli/real_program.h"
#include "tests/support/documents.h"
#include "tests/support/import_bytes.h"

using namespace dini;
using namespace dini::support;

namespace {

Json ball_of(double radius) {
  Json graph = document({{"ball", make("sphere_mesh", {{"radius", radius}, {"segments", 16}, {"rings", 8}})},
                         {"out", make("export", {{"model", from("ball")}})}});
  graph["parameters"] = {{"reach", {{"type", "number"}, {"default", 1}}}};
  return graph;
}

struct ModelFolder : GraphFolder {
  std::string model(const std::string& name, const Json& json) const {
    REQUIRE(run({"eval", graph("graph.json", json), "-o", at(name)}).code == 0);
    return at(name);
  }
};

}  // namespace

TEST_CASE("Graphs differ by nodes, inputs and parameters, and not by layout, order and what the page remembers") {
  const ModelFolder files;
  const std::string before = files.graph("a.json", ball_of(1));
  Json moved = ball_of(1);
  moved["ui"] = {{"nodes", {{"ball", {{"x", 4}}}}}};
  files.write("b.json", moved.dump(4));
  const Outcome same = run({"diff", before, files.at("b.json")});
  CHECK(same.code == 0);
  CHECK(same.out.empty());

  Json after = ball_of(2);
  after["nodes"]["ball"]["inputs"].erase("rings");
  after["nodes"]["extra"] = make("circle");
  after["parameters"]["reach"]["default"] = 3;
  const std::string changed = files.graph("c.json", after);
  const Outcome outcome = run({"diff", before, changed});
  CHECK(outcome.code == 1);
  CHECK(outcome.err.empty());
  CHECK(outcome.out ==
        "~ parameter reach.default: 1 -> 3\n"
        "+ extra\n"
        "~ ball.radius: 1 -> 2\n"
        "~ ball.rings: 8 -> default\n");
  CHECK(run({"diff", changed, before}).out.find("- extra\n") != std::string::npos);
  const Json json = Json::parse(run({"diff", before, changed, "--json"}).out);
  CHECK(json["nodes"]["added"] == Json::array({"extra"}));
  CHECK(json["nodes"]["changed"]["ball"]["inputs"]["radius"]["to"] == 2);
}

TEST_CASE("Models differ by shape, and not by bytes") {
  const ModelFolder files;
  const std::string one = files.model("one.glb", ball_of(1)), larger = files.model("larger.glb", ball_of(1.01));
  Json renamed = ball_of(1);
  renamed["nodes"]["sphere"] = renamed["nodes"]["ball"];
  renamed["nodes"].erase("ball");
  renamed["nodes"]["out"]["inputs"]["model"] = from("sphere");
  const std::string same = files.model("same.glb", renamed);
  CHECK(contents(one) != contents(same));
  CHECK(run({"diff", one, one}).code == 0);
  const Outcome alike = run({"diff", one, same});
  CAPTURE(alike.out, alike.err);
  CHECK(alike.code == 0);
  CHECK(Json::parse(run({"diff", one, same, "--json"}).out)["same_bytes"] == false);
  const Outcome other = run({"diff", one, larger});
  CHECK(other.code == 1);
  CHECK(has(other.out, "largest x: 1.0"));
  CHECK(run({"diff", one, larger, "--tolerance", "0.1"}).code == 0);
}

TEST_CASE("Models of other programs are compared too, and what of them is not is told") {
  const ModelFolder files;
  const std::string packed = files.model("packed.glb", ball_of(1)), larger = files.model("larger.glb", ball_of(1.01));
  REQUIRE(run({"eval", files.graph("graph.json", ball_of(1)), "--no-draco", "-o", files.at("plain.glb")}).code == 0);
  const Outcome alike = run({"diff", packed, files.at("plain.glb")});
  CAPTURE(alike.out, alike.err);
  CHECK(alike.code == 0);
  CHECK(run({"diff", files.at("plain.glb"), larger}).code == 1);

  files.write("quad.glb", quad_glb());
  const std::string quad = files.at("quad.glb");
  CHECK(run({"diff", quad, quad}).code == 0);
  Json moved = quad_document();
  moved["nodes"][0]["translation"] = {0, 0.25, 0};
  files.write("moved.glb", glb_of(moved.dump(), quad_binary()));
  const Outcome other = run({"diff", quad, files.at("moved.glb")});
  CHECK(other.code == 1);
  CHECK(has(other.out, "z: 0"));

  Json with_points = quad_document();
  with_points["meshes"][0]["primitives"].push_back({{"attributes", {{"POSITION", 0}}}, {"mode", 0}});
  files.write("points.glb", glb_of(with_points.dump(), quad_binary()));
  const Outcome partly = run({"diff", quad, files.at("points.glb")});
  CHECK(has(partly.err, "points.glb: warning: "));
  CHECK(has(partly.err, "[left-out]"));
  CHECK(Json::parse(run({"diff", quad, files.at("points.glb"), "--json"}).out)["left_out"]["after"].size() == 1);

  // Draco of another writer: refused with a sentence, and by nothing else.
  std::string foreign = contents(packed);
  foreign.replace(foreign.find("\"Dini\""), 6, "\"Anni\"");
  files.write("foreign.glb", foreign);
  const Outcome refused = run({"diff", packed, files.at("foreign.glb")});
  CHECK(refused.code == 3);
  CHECK(has(refused.err, "its meshes are compressed by another program"));
}

TEST_CASE("What cannot be compared is refused with a sentence, and is never the same") {
  const ModelFolder files;
  const std::string graph = files.graph("a.json", ball_of(1)), model = files.model("one.glb", ball_of(1));
  files.write("package.json", "{}");
  files.write("broken.json", "{");
  const std::string bytes = contents(model);
  files.write("short.glb", bytes.substr(0, bytes.size() / 2));
  files.write("empty.glb", "glTF");
  for (const auto& [other, code] : std::vector<std::pair<std::string, int>>{
           {"one.glb", 2}, {"package.json", 3}, {"broken.json", 3}, {"none.json", 6}}) {
    const Outcome outcome = run({"diff", graph, files.at(other)});
    CAPTURE(other, outcome.err);
    CHECK(outcome.code == code);
    CHECK(outcome.out.empty());
    CHECK(has(outcome.err, "error: "));
  }
  for (const char* other : {"short.glb", "empty.glb"}) CHECK(run({"diff", model, files.at(other)}).code == 3);
  std::string damaged = bytes;
  for (std::size_t at = bytes.size() / 2; at < bytes.size(); at += 97) {
    damaged[at] = static_cast<char>(damaged[at] ^ 0x55);
    files.write("damaged.glb", damaged);
    const int code = run({"diff", model, files.at("damaged.glb")}).code;
    CHECK((code == 1 || code == 3));
  }
  CHECK(run({"diff", graph}).code == 2);
  CHECK(run({"diff", "-", "-"}).code == 2);
  CHECK(run({"diff", model, model, "--tolerance", "-1"}).code == 2);
}
