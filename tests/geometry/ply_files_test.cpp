// PLY files as programs write them, and what is left out of them.

#include <catch2/catch.hpp>

#include "geometry/ply_reader.h"
#include "tests/support/import_bytes.h"
#include "tests/support/read_file.h"

using namespace dini;
using namespace dini::support;

namespace {

/// An ascii PLY of a triangle; `properties` follow x, y and z, and `values` stand in their columns.
std::string triangle_with(const std::vector<std::string>& properties, const std::array<std::string, 3>& values) {
  std::string text = "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n";
  for (const std::string& property : properties) text += "property " + property + "\n";
  text += "element face 1\nproperty list uchar int vertex_indices\nend_header\n";
  return text + "0 0 0 " + values[0] + "\n1 0 0 " + values[1] + "\n0 1 0 " + values[2] + "\n3 0 1 2\n";
}

/// An ascii PLY of four corners, then `elements` with their `rows`.
std::string corners_with(const std::string& elements, const std::string& rows) {
  return "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n" + elements +
         "end_header\n0 0 0\n1 0 0\n0 1 0\n1 1 0\n" + rows;
}

std::vector<std::string> named(const std::string& type, const std::vector<std::string>& names) {
  std::vector<std::string> properties;
  for (const std::string& name : names) properties.push_back(type + " " + name);
  return properties;
}

std::string replaced_everywhere(std::string text, const std::string& from, const std::string& to) {
  for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size())) {
    text.replace(at, from.size(), to);
  }
  return text;
}

const std::string face_list = "property list uchar int vertex_indices\n";

}  // namespace

TEST_CASE("A PLY may begin with a byte order mark, in capital letters, and with any ends of lines") {
  const std::string plain = triangle_with({}, {"", "", ""});
  std::string capitals = plain;
  for (char& c : capitals) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  for (const std::string& text :
       {"\xEF\xBB\xBF" + plain, capitals, replaced_everywhere(plain, "\n", "\r\n"),
        replaced_everywhere(plain, "\n", "\r"), replaced_everywhere(plain, "ply\n", "ply \n"), plain + "\n\n"}) {
    CAPTURE(text);
    const ReadFile file(read_ply(text, {}));
    CHECK(file.positions() == triangle_places);
    CHECK(file.warnings.empty());
  }
}

TEST_CASE("Data that begin with the byte of a line feed are not taken for the end of the header") {
  for (const std::string end : {"\n", "\r", "\r\n"}) {
    Bytes bytes;
    bytes.text = replaced_everywhere(
        "ply\nformat binary_little_endian 1.0\nelement vertex 3\nproperty uchar x\nproperty uchar y\nproperty uchar z\n"
        "element face 1\nproperty list uchar uchar vertex_index\nend_header\n",
        "\n", end);
    for (const std::uint32_t value : {10, 0, 0, 11, 0, 0, 10, 13, 0, 3, 0, 1, 2}) bytes.u8(value);
    CHECK(ReadFile(read_ply(bytes.text, {})).positions() == PlaceList{{10, 0, 0}, {11, 0, 0}, {10, 13, 0}});
  }
}

TEST_CASE("Columns that are not used are not even read as numbers, and told of") {
  for (const std::string word : {"nan", "inf", "-nan(ind)", "1.#QNAN", "255.0", "1e-400", "1e400", "none"}) {
    CAPTURE(word);
    for (const std::string type : {"float", "uchar", "double"}) {
      const ReadFile file(read_ply(triangle_with({type + " Quality"}, {word, "0.5", word}), {}));
      CHECK(file.positions() == triangle_places);
      CHECK(file.warnings == Sentences{"1 property of \"vertex\" is left out: \"quality\""});
    }
  }
  const ReadFile file(
      read_ply(triangle_with(named("float", {"a1", "a2", "a3", "nx"}), {"1 2 3 4", "5 6 7 8", "9 0 1 2"}), {}));
  CHECK(file.warnings == Sentences{"4 properties of \"vertex\" are left out: \"a1\", \"a2\", \"a3\" and others"});
}

TEST_CASE("Normals, texture coordinates and colors that are not finite are replaced and counted") {
  const ReadFile file(read_ply(triangle_with(named("float", {"nx", "ny", "nz", "s", "t", "red", "green", "blue"}),
                                             {"nan nan nan 0 nan 1 0 0", "0 0 0 1 1 inf 0 0", "0 0 -2 0 1 0 1 0"}),
                               {}));
  CHECK(length(file.mesh.normals[0] - Vector{0, 0, 1}) < 1e-12);
  CHECK(length(file.mesh.normals[1] - Vector{0, 0, 1}) < 1e-12);
  CHECK(file.mesh.normals[2] == Vector{0, 0, -1});
  CHECK(file.mesh.uvs == std::vector<std::array<double, 2>>{{0, 0}, {1, 0}, {0, 0}});
  CHECK(file.mesh.colors == ColorList{{1, 0, 0, 1}, {1, 1, 1, 1}, {0, 1, 0, 1}});
  CHECK(file.warnings == Sentences{"1 texture coordinate is not finite or beyond 1e18 and becomes 0",
                                   "1 color is not finite and becomes white",
                                   "2 normals are zero or not finite and are computed"});
}

TEST_CASE("Faces that cannot be drawn are left out, and the others are read") {
  const std::string faces = "element face 3\n" + face_list;
  const ReadFile few(read_ply(corners_with(faces, "2 0 1\n3 0 1 2\n0\n"), {}));
  CHECK(few.positions() == triangle_places);
  CHECK(few.warnings == Sentences{"2 faces have fewer than three corners and are left out, the first at line 14"});
  const ReadFile repeated(read_ply(corners_with(faces, "3 0 0 1\n3 0 1 2\n4 0 1 1 3\n"), {}));
  CHECK(repeated.mesh.triangles == std::vector<std::array<std::uint32_t, 3>>{{0, 1, 2}, {0, 1, 3}});
  CHECK(repeated.warnings == Sentences{"2 triangles use a vertex twice and are left out"});
  // Scanners write the holes of their grids as vertices that are none.
  const std::string holes =
      replaced_everywhere(corners_with(faces, "3 0 1 2\n3 1 2 3\n4 0 1 2 3\n"), "1 1 0", "nan nan nan");
  const ReadFile rest(read_ply(holes, {}));
  CHECK(rest.positions() == triangle_places);
  CHECK(rest.warnings ==
        Sentences{"2 faces use a vertex that is not finite or beyond 1e18 and are left out, the first at line 15"});
  CHECK(refusal(read_ply, replaced_everywhere(holes, "1 0 0", "inf 0 0")) ==
        "invalid: the file has no triangles; 3 faces use a vertex that is not finite or beyond 1e18 and are left out, "
        "the first at line 14");
  CHECK(refusal(read_ply, corners_with("", "")) == "invalid: the file has no triangles");
}

TEST_CASE("Strips of triangles turn over with each triangle, begin again at -1, and stand beside faces") {
  const std::string strips = "element tristrips 1\nproperty list int int vertex_indices\n";
  const ReadFile file(read_ply(corners_with(strips, "4 0 1 2 3\n"), {}));
  CHECK(file.mesh.triangles == std::vector<std::array<std::uint32_t, 3>>{{0, 1, 2}, {2, 1, 3}});
  CHECK(length(file.mesh.normals[3] - Vector{0, 0, 1}) < 1e-12);
  CHECK(file.warnings.empty());
  const ReadFile several(read_ply(corners_with(strips, "12 0 1 2 -1 -1 1 3 2 2 1 -1 0\n"), {}));
  CHECK(several.mesh.triangles == std::vector<std::array<std::uint32_t, 3>>{{0, 1, 2}, {1, 3, 2}});
  CHECK(several.warnings == Sentences{"1 face has fewer than three corners and is left out, the first at line 14"});
  const ReadFile both(read_ply(corners_with("element face 1\n" + face_list + strips, "3 0 1 3\n3 0 3 2\n"), {}));
  CHECK(both.mesh.triangles == std::vector<std::array<std::uint32_t, 3>>{{0, 1, 3}, {0, 3, 2}});
  CHECK(refusal(read_ply, corners_with(strips, "4 0 1 2 4\n")) == "invalid: line 14: a face uses vertex 4 of 4");
  CHECK(refusal(read_ply, corners_with(strips, "4 0 1 2 -2\n")) == "invalid: line 14: a face uses vertex -2 of 4");
  CHECK(refusal(read_ply, corners_with(strips, "6 0 1 2 0 1 2\n"), {4, 3}).starts_with("too large: "));
}

TEST_CASE("Colors are found by all their names and on all their scales") {
  struct Scale {
    std::string type;
    std::array<std::string, 3> rows;
    float first_red;
  };
  const std::vector<std::vector<std::string>> all_names = {{"red", "green", "blue"},
                                                           {"r", "g", "b"},
                                                           {"diffuse_red", "diffuse_green", "diffuse_blue"},
                                                           {"Red", "GREEN", "bLue"}};
  for (const auto& names : all_names) {
    for (const auto& [type, rows, first_red] :
         std::vector<Scale>{{"uchar", {"255 0 0", "0 255.0 0", "0 0 255"}, 1},
                            {"uchar", {"1 0 0", "0 1 0", "0 0 1"}, 1 / 255.0f / 12.92f},
                            {"char", {"-1 0 0", "0 -1 0", "0 0 -1"}, 1},
                            {"ushort", {"65535 0 0", "0 65535 0", "0 0 65535"}, 1},
                            {"ushort", {"255 0 0", "0 255 0", "0 0 255"}, 1},
                            {"short", {"32767 0 0", "0 32767 0", "0 0 32767"}, 1},
                            {"int", {"255 0 0", "0 255 0", "0 0 255"}, 1},
                            {"uint", {"2 0 0", "0 2 0", "0 0 2"}, 2 / 255.0f / 12.92f},
                            {"float", {"1 0 0", "0 1 0", "0 0 1"}, 1},
                            {"float", {"1.001 0 0", "0 1 0", "0 0 1"}, 1},
                            {"float", {"255 0 0", "0 255 0", "0 0 255"}, 1},
                            {"double", {"3 0 0", "0 3 0", "0 0 3"}, 3 / 255.0f / 12.92f},
                            {"double", {"65535 0 0", "0 65535 0", "0 0 65535"}, 1}}) {
      CAPTURE(names, type, rows);
      const ReadFile file(read_ply(triangle_with(named(type, names), rows), {}));
      REQUIRE(file.mesh.colors.size() == 3);
      CHECK(file.mesh.colors[0][0] == Approx(first_red));
      CHECK(file.mesh.colors[1][0] == 0);
      CHECK(file.mesh.colors[0][3] == 1);
      CHECK(file.warnings.empty());
    }
  }
  const ReadFile half(read_ply(
      triangle_with({"float red", "float green", "float blue", "uchar alpha"}, {"1 0 0 51", "0 1 0 0", "0 0 1 255"}),
      {}));
  CHECK(half.mesh.colors[0][3] == Approx(0.2));
  CHECK(half.mesh.colors[1][3] == 0);
}

TEST_CASE("The first of two colors is taken, and parts of groups are left out") {
  const ReadFile file(read_ply(
      triangle_with({"uchar red", "uchar green", "uchar blue", "uchar r", "float nx", "uchar alpha", "float u"},
                    {"255 0 0 7 1 255 0", "255 0 0 7 1 255 0", "255 0 0 7 1 0 0"}),
      {}));
  CHECK(file.mesh.colors == ColorList{{1, 0, 0, 1}, {1, 0, 0, 1}, {1, 0, 0, 0}});
  CHECK(file.mesh.uvs.empty());
  CHECK(file.warnings == Sentences{"3 properties of \"vertex\" are left out: \"r\", \"nx\", \"u\""});
}

TEST_CASE("The colors of faces split the vertices between them, unless the vertices have colors") {
  const std::string faces =
      "element face 2\n" + face_list + "property uchar red\nproperty uchar green\nproperty uchar blue\n";
  const ReadFile file(read_ply(corners_with(faces, "3 0 1 2 255 0 0\n3 1 3 2 0 0 255\n"), {}));
  CHECK(file.positions() == PlaceList{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}});
  CHECK(file.mesh.triangles == std::vector<std::array<std::uint32_t, 3>>{{0, 1, 2}, {4, 3, 5}});
  const std::array<float, 4> red = {1, 0, 0, 1}, blue = {0, 0, 1, 1};
  CHECK(file.mesh.colors == ColorList{red, red, red, blue, blue, blue});
  CHECK(file.warnings.empty());
  const ReadFile same(read_ply(corners_with(faces, "3 0 1 2 9 9 9\n3 1 3 2 9 9 9\n"), {}));
  CHECK(same.mesh.positions.size() == 4);
  CHECK(refusal(read_ply, corners_with(faces, "3 0 1 2 9 9 9\n3 1 3 2 8 8 8\n"), {5, 9}).starts_with("too large: "));
  std::string painted = triangle_with(named("uchar", {"red", "green", "blue"}), {"0 255 0", "0 255 0", "0 255 0"});
  painted = replaced_everywhere(replaced_everywhere(painted, "vertex_indices\n",
                                                    "vertex_indices\nproperty uchar red\nproperty uchar green\n"
                                                    "property uchar blue\n"),
                                "3 0 1 2", "3 0 1 2 255 0 0");
  const ReadFile kept(read_ply(painted, {}));
  CHECK(kept.mesh.colors[0] == std::array<float, 4>{0, 1, 0, 1});
  CHECK(kept.warnings == Sentences{"3 properties of \"face\" are left out: \"red\", \"green\", \"blue\""});
}

TEST_CASE("Other elements, other properties of faces, and what stands behind the end are told of") {
  const ReadFile file(
      read_ply(corners_with("element edge 2\nproperty int vertex1\nproperty int vertex2\nelement face 1\n" + face_list +
                                "property list uchar float texcoord\n",
                            "0 1\n1 2\n3 0 1 2 6 0 0 1 0 0 nan\nmore and more\n"),
               {}));
  CHECK(file.positions() == triangle_places);
  CHECK(file.warnings == Sentences{"2 of the element \"edge\" are left out",
                                   "1 property of \"face\" is left out: \"texcoord\"",
                                   "14 bytes behind the last element are left out"});
}

TEST_CASE("A row that does not fit the header is found, and many rows may stand in one line") {
  const std::string faces = "element face 1\n" + face_list;
  const std::string good = corners_with(faces, "3 0 1 2\n");
  const ReadFile in_one_line(read_ply(replaced_everywhere(good, "\n1 0 0\n0 1 0\n", " 1 0 0 0 1 0 "), {}));
  CHECK(in_one_line.positions() == triangle_places);
  CHECK(ReadFile(read_ply(replaced_everywhere(good, "3 0 1 2\n", "3\n0\n1 2\n"), {})).positions() == triangle_places);
  for (const std::string& bad :
       {replaced_everywhere(good, "1 0 0\n", "1 0 0 255\n"), replaced_everywhere(good, "1 0 0\n", "1 0\n")}) {
    const std::string said = refusal(read_ply, bad);
    CAPTURE(bad, said);
    CHECK(said.starts_with("invalid: line "));
    CHECK(said.find("has not the values that the header names") != std::string::npos);
  }
  CHECK(refusal(read_ply, replaced_everywhere(good, "0 1 0\n", "0 x 0\n")) ==
        "invalid: line 12: the data end, or \"y\" is no number");
  CHECK(refusal(read_ply, replaced_everywhere(good, "3 0 1 2", "3 0 1 1.5")) ==
        "invalid: line 14: a face uses vertex 1.5 of 4");
  CHECK(refusal(read_ply, replaced_everywhere(good, "3 0 1 2", "2.5 0 1 2"))
            .starts_with("invalid: line 14: the length of "));
}

TEST_CASE("Vertices that no face uses do not count against the limit") {
  const std::string text = corners_with("element face 1\n" + face_list, "3 0 1 2\n");
  CHECK(refusal(read_ply, text, {3, 1}).empty());
  CHECK(refusal(read_ply, text, {2, 1}) == "too large: the file has more than 2 vertices, which is the limit");
}
