// OBJ files as programs write them, and what is left out of them.

#include <catch2/catch.hpp>

#include "geometry/obj_reader.h"
#include "tests/support/import_bytes.h"
#include "tests/support/read_file.h"

using namespace dini;
using namespace dini::support;

namespace {

using Triangles = std::vector<std::array<std::uint32_t, 3>>;

const std::string four_corners = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n";
struct Case {
  std::string text;
  PlaceList positions;
  Triangles triangles;
  Sentences warnings;
};

void check(const Case& expected) {
  CAPTURE(expected.text);
  const ReadFile file(read_obj(expected.text, {}));
  CHECK(file.positions() == expected.positions);
  CHECK(file.mesh.triangles == expected.triangles);
  CHECK(file.warnings == expected.warnings);
}

}  // namespace

TEST_CASE("A byte order mark of an OBJ is no part of its first line, nor of one in its middle") {
  const std::string mark = "\xEF\xBB\xBF";
  for (const std::string& text :
       {mark + four_corners + "f 1 2 3\n", four_corners + mark + "f 1 2 3\n",
        mark + "# a comment\n" + four_corners + "f 1 2 3\n", mark + "\n" + four_corners + "f 1 2 3\n",
        mark + "v 0 0 0\r\n" + mark + "v 1 0 0\r\nv 0 1 0\r\nf 1 2 3"}) {
    check({text, triangle_places, {{0, 1, 2}}, {}});
  }
}

TEST_CASE("A backslash joins lines of numbers, with white space behind it or not, and nothing else") {
  for (const std::string face :
       {"f 1 2 \\\n3\n", "f 1 2\\\n3\n", "f 1 2 \\  \t\n3\n", "f 1 2 \\\r\n3\r\n", "f \\\n1 \\ \n2 \\\n3\n",
        "f 1 2 3 \\\n\n", "f 1 2 3 \\", "f 1 2 3 # C:\\\n", "# part: head\\\nf 1 2 3\n", "#\\\nf 1 2 3\n",
        "o head\\\nf 1 2 3\n", "g C:\\parts\\ \nf 1 2 3\n", "s off \\\nf 1 2 3\n", "mtllib C:\\art\\\nf 1 2 3\n"}) {
    check({four_corners + face, triangle_places, {{0, 1, 2}}, {}});
  }
  check({"v 0 0 \\\n0\nv 1 0 0 # \\\nv 0 1 0\nf 1 2 3\n", triangle_places, {{0, 1, 2}}, {}});
  check({four_corners + "usemtl red\\\nf 1 2 3\n", triangle_places, {{0, 1, 2}}, {"1 use of a material is left out"}});
  // Joined to what is no number.
  CHECK(refusal(read_obj, "v 0 0 0 \\\nv 1 0 0\n") == "invalid: line 1: \"v\" is no number");
}

TEST_CASE("A comment may stand right behind a number, and the number sign of 1.#QNAN begins none") {
  check({"v 0 0 0#1\nv 1 0 0.# a comment\nv 0 1 0 # 2\nvn 1.#QNAN 0 1\nf 1//1 2//1 3//1#\n",
         triangle_places,
         {{0, 1, 2}},
         {"3 normals are zero or not finite and are computed"}});
}

TEST_CASE("What an OBJ has and the mesh has not is counted") {
  const std::string face = "f 1 2 3\n";
  for (const auto& [lines, warnings] : std::vector<std::pair<std::string, Sentences>>{
           {"f 1 2\n", {"1 face has fewer than three corners and is left out, the first at line 6"}},
           {"f\nf 1\n", {"2 faces have fewer than three corners and are left out, the first at line 6"}},
           {"f 1 1 2\n", {"1 triangle uses a vertex twice and is left out"}},
           {"v nan 0 0\nv 0 inf 0\nv 0 0 -1e999\n", {}},
           {"v nan 0 0\nf 1 2 3 -1\nf 2 3 5\n",
            {"2 faces use a vertex that is not finite or beyond 1e18 and are left out, the first at line 7"}},
           {"v 0 0 1e18\nf 1 2 -1\n",
            {"1 face uses a vertex that is not finite or beyond 1e18 and is left out, the first at line 7"}},
           {"l 1 2\nl 2 3\n", {"2 lines (l) are left out"}},
           {"p 1\n", {"1 statement of points (p) is left out"}},
           {"cstype bezier\ndeg 3\ncurv 0 1 1 2 3\nparm u 0 1 \\\n 2\nend\n",
            {"1 free-form curve or surface is left out"}},
           {"usemtl a\nusemtl b\n", {"2 uses of materials are left out"}},
           {"v 0 0 0 0.5\nv 0 0 0 1\n",
            {"1 vertex has a weight or other numbers behind the position, which are left out"}},
           {"vt 0 0 0\nvt 0 0 0.5\n", {"1 third texture coordinate is left out"}},
           {"hello\n\n# v\nworld 1 2\n", {"2 lines are no statement of an OBJ and left out, the first is line 6"}},
           {"o a\ng b c\ns 1\nmtllib a.mtl\nvp 0 1\n", {}}}) {
    check({four_corners + face + lines, triangle_places, {{0, 1, 2}}, warnings});
  }
}

TEST_CASE("An OBJ without a triangle says why") {
  CHECK(refusal(read_obj, four_corners) == "invalid: the file has no triangles");
  CHECK(refusal(read_obj, four_corners + "l 1 2\nf 1 2\n") ==
        "invalid: the file has no triangles; 1 face has fewer than three corners and is left out, the first at line 6; "
        "1 line (l) is left out");
  CHECK(
      refusal(read_obj, four_corners + "v 0 0 1.#INF\nf 1 2 5\n") ==
      "invalid: the file has no triangles; 1 face uses a vertex that is not finite or beyond 1e18 and is left out, the "
      "first at line 6");
}

TEST_CASE("Attributes that are not finite never refuse an OBJ") {
  const ReadFile file(
      read_obj("v 0 0 0 nan 0 0\nv 1 0 0 1 0 0\nv 0 1 1e-400 0 1 0\nvt nan 0\nvt 1 1\nvt 0 1e30\n"
               "vn nan nan nan\nvn 0 0 0\nvn 0 0 -7\nf 1/1/1 2/2/2 3/3/3\n",
               {}));
  CHECK(file.positions() == triangle_places);
  CHECK(file.mesh.colors == std::vector<std::array<float, 4>>{{1, 1, 1, 1}, {1, 0, 0, 1}, {0, 1, 0, 1}});
  CHECK(file.mesh.uvs == std::vector<std::array<double, 2>>{{0, 0}, {1, 0}, {0, 0}});
  CHECK(length(file.mesh.normals[0] - Vector{0, 0, 1}) < 1e-12);
  CHECK(length(file.mesh.normals[1] - Vector{0, 0, 1}) < 1e-12);
  CHECK(file.mesh.normals[2] == Vector{0, 0, -1});
  CHECK(file.warnings == Sentences{"2 texture coordinates are not finite or beyond 1e18 and become 0",
                                   "1 color is not finite and becomes white",
                                   "2 normals are zero or not finite and are computed"});
}

TEST_CASE("The numbers behind a position are a weight, a color, or a color with alpha") {
  const auto first_color = [](const std::string& numbers) {
    return ReadFile(read_obj("v 0 0 0 " + numbers + "\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", {})).mesh.colors;
  };
  CHECK(first_color("1").empty());
  for (const auto& [numbers, color] :
       std::vector<std::pair<std::string, std::array<float, 4>>>{{"1 0 0", {1, 0, 0, 1}},
                                                                 {"1 0 0 0.5", {1, 0, 0, 0.5}},
                                                                 {"1 0 1 0 0.5", {0, 1, 0, 0.5}},
                                                                 {"255 0 0", {1, 0, 0, 1}},
                                                                 {"0 255.0 0 0.5", {0, 1, 0, 0.5}},
                                                                 {"0 0 255 255", {0, 0, 1, 1}},
                                                                 {"0 65535 0", {0, 1, 0, 1}},
                                                                 {"1.5 0 -1", {1, 0, 0, 1}}}) {
    CAPTURE(numbers);
    REQUIRE(first_color(numbers).size() == 3);
    CHECK(first_color(numbers)[0] == color);
    CHECK(first_color(numbers)[1] == std::array<float, 4>{1, 1, 1, 1});
  }
  CHECK(first_color("1 1").empty());
}

TEST_CASE("An index may be written as 3.0, and says which it is when it leads nowhere") {
  check({four_corners + "f 1.0 2.0 3.0\n", triangle_places, {{0, 1, 2}}, {}});
  check({four_corners + "fo 1 2 3\n", triangle_places, {{0, 1, 2}}, {}});
  CHECK(refusal(read_obj, four_corners + "f 1 2 7\n") == "invalid: line 5: \"7\" is none of the 4 vertices before it");
  CHECK(refusal(read_obj, four_corners + "f 1/1 2/1 3/1\n") ==
        "invalid: line 5: \"1\" is none of the 0 texture coordinates before it");
  CHECK(refusal(read_obj, four_corners + "f 1 2 2.5\n") ==
        "invalid: line 5: \"2.5\" is none of the 4 vertices before it");
}
