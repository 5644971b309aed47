#include <catch2/catch.hpp>
#include <limits>

#include "geometry/json.h"
#include "geometry/primitives.h"
#include "gltf/glb_container.h"
#include "gltf/glb_groups.h"

using namespace dini;

namespace {

Json json_of(const EncodeResult<std::string>& encoded) {
  REQUIRE(encoded);
  const auto chunks = split_glb(*encoded);
  REQUIRE(chunks);
  return Json::parse(chunks->json);
}

Part points_part(std::initializer_list<Point> points) {
  Column<Point> column(points.size());
  std::size_t i = 0;
  for (const Point& point : points) column.set(i++, point);
  return {"", std::make_shared<const Column<Point>>(std::move(column)), {1, 0, 0, 1}};
}

Part mesh_part() {
  return {"", std::make_shared<const Mesh>(sphere_mesh({0, 0, 0}, 1, 12, 6, Cancel())), {0, 1, 0, 1}};
}

std::vector<GlbGroup> sample() {
  return {{"b",
           {{"id", "b"}},
           {{"mesh", {{"output", "mesh"}}, {mesh_part(), points_part({{1, 2, 3}, {4, 5, 6}})}},
            {"nothing", {{"output", "nothing"}}, {points_part({Point::at_infinity()})}}}},
          {"a", {{"id", "a"}}, {}}};
}

}  // namespace

TEST_CASE("Groups are nodes with a child for everything that can be drawn") {
  const Json json = json_of(encode_groups(sample(), {}, Cancel()));
  const Json& nodes = json["nodes"];
  REQUIRE(nodes.size() == 4);
  CHECK(nodes[0]["children"] == Json({1, 3}));
  CHECK(nodes[1]["name"] == "b");
  CHECK(nodes[1]["extras"] == Json({{"id", "b"}}));
  CHECK(nodes[1]["children"] == Json::array({2}));
  CHECK(nodes[2]["extras"] == Json({{"output", "mesh"}}));
  CHECK(nodes[3]["extras"] == Json({{"id", "a"}, {"drawable", false}}));
  CHECK_FALSE(nodes[3].contains("children"));
  REQUIRE(json["meshes"].size() == 1);
  REQUIRE(json["meshes"][0]["primitives"].size() == 2);
  CHECK(json["meshes"][0]["primitives"][0]["extensions"].contains("KHR_draco_mesh_compression"));
  CHECK(json["meshes"][0]["primitives"][1]["mode"] == 0);
}

TEST_CASE("The same groups give the same bytes, and nothing to draw is a file too") {
  CHECK(*encode_groups(sample(), {}, Cancel()) == *encode_groups(sample(), {}, Cancel()));
  const Json json = json_of(encode_groups({{"a", {{"id", "a"}}, {}}}, {}, Cancel()));
  CHECK(json["nodes"].size() == 2);
  CHECK(json["nodes"][1]["extras"]["drawable"] == false);
  CHECK_FALSE(json.contains("meshes"));
  CHECK_FALSE(json.contains("buffers"));
}

TEST_CASE("An error names the group, and a stopped one says so") {
  auto broken = std::make_shared<Mesh>(*std::get<SharedMesh>(mesh_part().shape));
  broken->positions.set(0, {std::numeric_limits<double>::quiet_NaN(), 0, 0});
  std::vector<GlbGroup> groups = sample();
  groups[1].children.push_back({"mesh", Json::object(), {{"", SharedMesh(broken), {1, 1, 1, 1}}}});
  const auto refused = encode_groups(groups, {}, Cancel());
  REQUIRE_FALSE(refused);
  CHECK(refused.error().part == "a");
  const Cancel cancel;
  cancel.stop(StopReason::superseded);
  CHECK(encode_groups(sample(), {}, cancel).error().code == EncodeError::Code::canceled);
}
