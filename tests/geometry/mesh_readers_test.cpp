#include <algorithm>
#include <catch2/catch.hpp>

#include "geometry/obj_reader.h"
#include "geometry/ply_reader.h"
#include "geometry/polygon.h"
#include "geometry/validate.h"
#include "tests/support/damage.h"
#include "tests/support/import_bytes.h"

using namespace dini;
using namespace dini::support;

namespace {

Mesh mesh_of(const ImportResult& result) {
  if (!result) FAIL(result.error().detail);
  const Mesh& mesh = result->mesh;
  CHECK_FALSE(mesh_defect(mesh));
  return mesh;
}

/// quad_ply in binary.
std::string binary_ply(bool big_endian) {
  std::string text(quad_ply.substr(0, quad_ply.find("end_header\n") + 11));
  text.replace(text.find("ascii"), 5, big_endian ? "binary_big_endian" : "binary_little_endian");
  const auto put = [&](Bytes bytes) {
    if (big_endian) std::reverse(bytes.text.begin(), bytes.text.end());
    text += bytes.text;
  };
  const std::vector<std::vector<float>> rows = {{0, 0, 0, 0, 0, 255, 0, 0},
                                                {1, 0, 0, 1, 0, 0, 255, 0},
                                                {1, 1, 0, 1, 1, 0, 0, 255},
                                                {0, 1, 0, 0, 1, 255, 255, 255}};
  for (const auto& row : rows) {
    for (std::size_t k = 0; k < 5; ++k) put(Bytes().f32(row[k]));
    for (std::size_t k = 5; k < 8; ++k) put(Bytes().u8(static_cast<std::uint32_t>(row[k])));
  }
  put(Bytes().u8(4));
  for (const std::uint32_t index : {0, 1, 2, 3}) put(Bytes().u32(index));
  return text;
}

void check_square_of_ply(const Mesh& mesh) {
  REQUIRE(mesh.positions.size() == 4);
  CHECK(mesh.triangles == std::vector<std::array<std::uint32_t, 3>>{{0, 1, 2}, {0, 2, 3}});
  CHECK(mesh.positions[2] == Point{1, 1, 0});
  CHECK(mesh.uvs == std::vector<std::array<double, 2>>{{0, 1}, {1, 1}, {1, 0}, {0, 0}});
  CHECK(mesh.colors[1] == std::array<float, 4>{0, 1, 0, 1});
  CHECK(length(mesh.normals[0] - Vector{0, 0, 1}) < 1e-12);
}

double area(const std::vector<Vector>& corners, const std::vector<std::array<std::uint32_t, 3>>& triangles) {
  double sum = 0;
  for (const auto& [a, b, c] : triangles) sum += length(cross(corners[b] - corners[a], corners[c] - corners[a])) / 2;
  return sum;
}

}  // namespace

TEST_CASE("An OBJ keeps its texture coordinates, colors and normals, and splits vertices along seams") {
  const Mesh mesh = mesh_of(read_obj(quad_obj, {}));
  REQUIRE(mesh.positions.size() == 5);
  CHECK(mesh.triangles.size() == 2);
  CHECK(mesh.positions[0] == mesh.positions[3]);
  CHECK(mesh.uvs[0] == std::array<double, 2>{0, 1});
  CHECK(mesh.uvs[3] == std::array<double, 2>{0.25, 0.75});
  CHECK(mesh.colors[1] == std::array<float, 4>{0, 1, 0, 1});
  CHECK(mesh.normals[4] == Vector{0, 0, 1});
}

TEST_CASE("An OBJ may come with other line ends, comments, continued lines, and parts that are not read") {
  const Mesh mesh = mesh_of(
      read_obj("mtllib /etc/passwd\r\no thing # name\r\nv +0 0 0 1.0\rv 1e0 0 \\\n 0\nv 0 1 0 # last\n\nusemtl x\n"
               "s off\nl 1 2\nf 1 2 3 1\nf 1// 2// 3//\n",
               {}));
  CHECK(mesh.positions.size() == 3);
  CHECK(mesh.uvs.empty());
  CHECK(mesh.colors.empty());
  CHECK(length(mesh.normals[0] - Vector{0, 0, 1}) < 1e-12);
}

TEST_CASE("Colors of files are those of pictures and become linear") {
  const Mesh mesh = mesh_of(read_obj("v 0 0 0 0.5 2 -1\nv 1 0 0\nv 0 1 0\nf 1 2 3", {}));
  CHECK(mesh.colors[0][0] == Approx(0.21404114));
  CHECK(mesh.colors[0][1] == 1);
  CHECK(mesh.colors[0][2] == 0);
  CHECK(mesh.colors[1] == std::array<float, 4>{1, 1, 1, 1});
}

TEST_CASE("A PLY reads the same as text and as bytes of either order") {
  check_square_of_ply(mesh_of(read_ply(quad_ply, {})));
  check_square_of_ply(mesh_of(read_ply(binary_ply(false), {})));
  check_square_of_ply(mesh_of(read_ply(binary_ply(true), {})));
}

TEST_CASE("Every polygon becomes triangles of the same area, also where it is concave") {
  PolygonCutter cutter;
  std::vector<Vector> comb;
  for (int i = 0; i < 20; ++i) comb.push_back({1.0 * i, 0, i % 2 == 0 ? 0.0 : 3.0});
  for (int i = 19; i >= 0; --i) comb.push_back({1.0 * i, 0, i % 2 == 0 ? -1.0 : 2.0});
  std::vector<std::array<std::uint32_t, 3>> triangles;
  cutter.cut(comb, triangles);
  CHECK(triangles.size() == comb.size() - 2);
  CHECK(area(comb, triangles) == Approx(19));
  const std::vector<Vector> arrow = {{0, 0, 5}, {2, 1, 5}, {0, 2, 5}, {1, 1, 5}};
  triangles.clear();
  cutter.cut(arrow, triangles);
  CHECK(triangles.size() == 2);
  CHECK(area(arrow, triangles) == Approx(1));
  const std::vector<Vector> nothing(7, Vector{1, 1, 1});
  triangles.clear();
  cutter.cut(nothing, triangles);
  CHECK(triangles.size() == 5);
}

TEST_CASE("A file that is cut short at any byte is refused or a smaller good one") {
  for (std::size_t size = 0; size < quad_obj.size(); ++size) refusal(read_obj, quad_obj.substr(0, size));
  for (std::size_t size = 0; size + 2 < quad_ply.size(); ++size) {
    CAPTURE(size);
    CHECK_FALSE(refusal(read_ply, quad_ply.substr(0, size)).empty());
  }
  const std::string binary = binary_ply(false);
  for (std::size_t size = 0; size < binary.size(); ++size) {
    CAPTURE(size);
    CHECK_FALSE(refusal(read_ply, binary.substr(0, size)).empty());
  }
}

TEST_CASE("A PLY with any byte changed is read or refused, and nothing worse") {
  const std::string good = binary_ply(true);
  for (std::size_t at = 0; at < good.size(); ++at) {
    for (const char change : {'\0', '\x7f', '\xff', '9'}) {
      std::string bytes = good;
      bytes[at] = change;
      refusal(read_ply, bytes);
    }
  }
}

TEST_CASE("Text files with damage of any kind are read or refused, and nothing worse") {
  const std::string obj =
      std::string(quad_obj) + "vn 1.#QNAN 0 0\nf 1/1/2 2//1 \\\n 3/3\nf 1 2\nl 1 2\nusemtl a\\\nv 0 0 0 1 1 1 .5\n";
  const std::string ply =
      std::string(quad_ply.substr(0, quad_ply.find("element face"))) +
      "element face 2\nproperty uchar red\nproperty uchar green\nproperty uchar blue\n"
      "property list uchar int vertex_index\nelement tristrips 1\nproperty list int int vertex_index\n"
      "end_header\n" +
      std::string(
          quad_ply.substr(quad_ply.find("0 0 0 0 0"), quad_ply.find("4 0 1 2 3") - quad_ply.find("0 0 0 0 0"))) +
      "1 2 3 3 0 1 2\n4 5 6 3 0 2 3\n6 0 1 2 -1 3 2\n";
  REQUIRE(refusal(read_obj, obj).empty());
  REQUIRE(refusal(read_ply, ply).empty());
  std::mt19937 random(7);
  for (int i = 0; i < 3000; ++i) {
    check_is_read_or_refused(read_obj, damaged(obj, random));
    check_is_read_or_refused(read_ply, damaged(ply, random));
    check_is_read_or_refused(read_ply, damaged(binary_ply(i % 2 == 0), random));
  }
}

TEST_CASE("OBJ files that are wrong are refused with their line") {
  const std::string corners = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  for (const auto& [text, line] :
       std::vector<std::pair<std::string, std::string>>{{"v 0 0\n", "line 1"},
                                                        {"v 0 0 x\n", "line 1"},
                                                        {"v 0 0 1,5\n", "line 1"},
                                                        {"v 0 0 0x10\n", "line 1"},
                                                        {"v 0 0 0 0 0 0 0 0 0\n", "line 1"},
                                                        {corners + "f 1 2 4\n", "line 4"},
                                                        {corners + "f 1 2 0\n", "line 4"},
                                                        {corners + "f 1 2 -4\n", "line 4"},
                                                        {corners + "f 1 2 99999999999999999999\n", "line 4"},
                                                        {corners + "f 1 2 -9223372036854775808\n", "line 4"},
                                                        {corners + "f 1/1 2/1 3/1\n", "line 4"},
                                                        {corners + "f 1//1 2//1 3//1\n", "line 4"},
                                                        {corners + "f a b c\n", "line 4"}}) {
    CAPTURE(text);
    CHECK(refusal(read_obj, text).starts_with("invalid: " + line + ": "));
  }
  CHECK(refusal(read_obj, corners) == "invalid: the file has no triangles");
  CHECK(refusal(read_obj, corners + "f 1 1 2\n") ==
        "invalid: the file has no triangles; 1 triangle uses a vertex twice and is left out");
}

TEST_CASE("PLY files that are wrong are refused") {
  const auto changed = [](const std::string& from, const std::string& to) {
    std::string text(quad_ply);
    REQUIRE(text.find(from) != std::string::npos);
    return text.replace(text.find(from), from.size(), to);
  };
  for (const std::string& text : {changed("element vertex 4", "element vertex 400000000000"),
                                  changed("element vertex 4", "element vertex -1"),
                                  changed("element vertex 4", "element vertex 18446744073709551616"),
                                  changed("element face 1", "element face 9"),
                                  changed("element face 1\n", "element ghost 1000000000\nelement face 1\n"),
                                  changed("format ascii 1.0\n", ""),
                                  changed("ascii", "utf8"),
                                  changed("1.0", "2.0"),
                                  changed("property float z\n", ""),
                                  changed("uchar int vertex_indices", "float int vertex_indices"),
                                  changed("uchar int vertex_indices", "uchar float vertex_indices"),
                                  changed("vertex_indices", "corners"),
                                  changed("property float x", "property nothing x"),
                                  changed("end_header\n", ""),
                                  changed("4 0 1 2 3", "4 0 1 2 4"),
                                  changed("4 0 1 2 3", "4 0 1 2 -1"),
                                  changed("4 0 1 2 3", "-4 0 1 2 3"),
                                  changed("4 0 1 2 3", "2 0 1"),
                                  changed("4 0 1 2 3", "4000000000 0 1 2 3"),
                                  changed("4 0 1 2 3", "4 0 1 2 x"),
                                  changed("1 1 0 1 1", "nan 1 0 1 1"),
                                  changed("1 1 0 1 1", "1e400 1 0 1 1"),
                                  changed("comment a square", "command a square"),
                                  std::string("ply\n") + std::string(100'000, 'x')}) {
    CAPTURE(text.substr(0, 600));
    CHECK(refusal(read_ply, text).starts_with("invalid: "));
  }
}

TEST_CASE("One face that is the whole file is refused before it is held") {
  std::string face = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf";
  for (int i = 0; i < 300'000; ++i) face += " 1 2 3";
  CHECK(refusal(read_obj, face, {100, 1000}) == "too large: the file has more than 1000 triangles, which is the limit");
}

TEST_CASE("What is over a limit is refused as too large") {
  CHECK(refusal(read_obj, quad_obj, {5, 2}).empty());
  CHECK(refusal(read_obj, quad_obj, {4, 2}) == "too large: the file has more than 4 vertices, which is the limit");
  CHECK(refusal(read_obj, quad_obj, {5, 1}) == "too large: the file has more than 1 triangles, which is the limit");
  CHECK(refusal(read_ply, quad_ply, {3, 2}).starts_with("too large: "));
  CHECK(refusal(read_ply, quad_ply, {4, 1}).starts_with("too large: "));
}

TEST_CASE("A reader stops within the file when it is told to") {
  // All of them are broken at their end, which nobody who stops gets to see.
  std::string lines, face = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf", joined = "f", ply(quad_ply);
  for (int i = 0; i < 500'000; ++i) {
    lines += "v 0 0 0\n";
    face += " 1 2 3";
    joined += " \\\n";
  }
  lines += "v x\n";
  face += " 9\n";
  joined += "x\n";
  ply.replace(ply.find("element face 1"), 14, "element face 200002");
  for (int i = 0; i < 200'000; ++i) ply += "3 0 1 2\n";
  ply += "3 0 1 9\n";
  for (const auto& [read, text] :
       std::vector<std::pair<ImportResult (*)(std::string_view, const ImportLimits&, const Cancel&), std::string>>{
           {read_obj, lines}, {read_obj, face}, {read_obj, joined}, {read_ply, ply}}) {
    CAPTURE(text.substr(0, 40));
    Cancel told;
    told.stop(StopReason::superseded);
    CHECK(refusal(read, text, {}, told) == "stopped");
    // Soon after it began: each takes many times as long.
    CHECK(refusal(read, text, {}, Cancel(Cancel::Clock::now() + std::chrono::milliseconds(2))) == "stopped");
    CHECK(refusal(read, text).starts_with("invalid: "));
  }
}

TEST_CASE("What is gathered from a file is not finished once the work is to stop") {
  Cancel told;
  told.stop(StopReason::deadline);
  CHECK(refusal(read_obj, quad_obj, {}, told) == "stopped");
  CHECK(refusal(read_ply, quad_ply, {}, told) == "stopped");
}
