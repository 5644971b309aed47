#include <catch2/catch.hpp>

#include "geometry/stl_reader.h"
#include "geometry/validate.h"
#include "tests/support/damage.h"
#include "tests/support/import_bytes.h"

using namespace dini;
using namespace dini::support;

namespace {

using CornerList = std::vector<std::array<float, 3>>;

/// The square_corners from (0, 0, 0) to (1, 1, 0), three corners for each triangle.
const CornerList square_corners = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 0, -0.0f}, {1, 1, 0}, {0, 1, 0}};

std::string binary_stl(const CornerList& corners, const std::string& header = "made by hand", std::uint32_t color = 0) {
  Bytes bytes;
  bytes.text = header;
  bytes.text.resize(80, ' ');
  bytes.u32(static_cast<std::uint32_t>(corners.size() / 3));
  for (std::size_t i = 0; i < corners.size(); i += 3) {
    bytes.f32s({0, 0, 0});
    for (std::size_t k = 0; k < 3; ++k) bytes.f32s({corners[i + k][0], corners[i + k][1], corners[i + k][2]});
    bytes.u16(color);
  }
  return bytes.text;
}

const std::string text_stl(quad_stl);

void check_is_square(const ImportResult& result) {
  if (!result) FAIL(result.error().detail);
  const Mesh& mesh = result->mesh;
  CHECK(result->format == MeshFormat::stl);
  CHECK(result->warnings.empty());
  CHECK_FALSE(mesh_defect(mesh));
  REQUIRE(mesh.positions.size() == 4);
  CHECK(mesh.triangles == std::vector<std::array<std::uint32_t, 3>>{{0, 1, 2}, {0, 2, 3}});
  CHECK(mesh.positions[2] == Point{1, 1, 0});
  for (std::size_t i = 0; i < 4; ++i) CHECK(length(mesh.normals[i] - Vector{0, 0, 1}) < 1e-12);
}

std::vector<std::string> warnings_of(const std::string& bytes) {
  const ImportResult result = read_stl(bytes, {});
  if (!result) return {result.error().detail};
  return result->warnings;
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  REQUIRE(text.find(from) != std::string::npos);
  return text.replace(text.find(from), from.size(), to);
}

}  // namespace

TEST_CASE("An STL is read from bytes and from text, and its triangles hold together") {
  check_is_square(read_stl(binary_stl(square_corners), {}));
  check_is_square(read_stl(binary_stl(square_corners, "solid, although it is none"), {}));
  check_is_square(read_stl(text_stl, {}));
  check_is_square(read_stl("\xEF\xBB\xBF" + text_stl, {}));
  check_is_square(read_stl(replaced(text_stl, "endsolid a square\n", ""), {}));
}

TEST_CASE("An STL is known by its length or its first word") {
  CHECK(begins_like_stl(binary_stl(square_corners)));
  CHECK(begins_like_stl(text_stl));
  CHECK(begins_like_stl("  SOLID"));
  CHECK_FALSE(begins_like_stl("solids"));
  CHECK_FALSE(begins_like_stl(quad_obj));
  CHECK_FALSE(begins_like_stl(binary_stl(square_corners) + "x"));
  CHECK(stl_size_hint(binary_stl(square_corners) + "x") ==
        "a binary STL of 2 triangles would have 184 bytes, this file has 185");
  CHECK_FALSE(stl_size_hint("solid"));
}

TEST_CASE("What an STL has and a mesh has not is a warning with a count") {
  CHECK(warnings_of(binary_stl(square_corners, "x", 0x8001)) ==
        std::vector<std::string>{"2 triangles have colors or other attributes that are left out"});
  CHECK(warnings_of(binary_stl(square_corners, "solid") + "abc") ==
        std::vector<std::string>{"3 bytes behind the last triangle are left out"});
  CornerList bad = square_corners;
  bad.insert(bad.end(), {{NAN, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 0, 0}, {1, 0, 0}, {0, 1, 0}});
  bad.insert(bad.end(), {{2e18f, 0, 0}, {1, 0, 0}, {0, 1, 0}});
  CHECK(warnings_of(binary_stl(bad)) ==
        std::vector<std::string>{
            "2 faces use a vertex that is not finite or beyond 1e18 and are left out, the first at byte 184",
            "1 triangle uses a vertex twice and is left out"});
  CHECK(warnings_of(replaced(text_stl, "1 1 -0", "1 inf 0")) ==
        std::vector<std::string>{
            "1 face uses a vertex that is not finite or beyond 1e18 and is left out, the first at line 15"});
}

TEST_CASE("STL files that are wrong are refused with the place") {
  const std::string whole = binary_stl(square_corners, "solid");
  CHECK(refusal(read_stl, whole.substr(0, 183)) ==
        "invalid: it is cut short: 2 triangles need 184 bytes, the file has 183");
  CHECK(refusal(read_stl, binary_stl({})) == "invalid: the file has no triangles");
  std::string huge = whole;
  huge.replace(80, 4, "\xff\xff\xff\xff");
  CHECK(refusal(read_stl, huge) ==
        "invalid: it is cut short: 4294967295 triangles need 214748364834 bytes, the file has 184");
  for (const auto& [from, to, message] : std::vector<std::array<std::string, 3>>{
           {"vertex 0 0 0", "vertex 0 0", "line 4: a vertex has fewer than three numbers"},
           {"vertex 0 0 0", "vertex 0 0 0 0", "line 4: a vertex has more than three numbers"},
           {"vertex 0 0 0", "vertex 0 0 1,5", "line 4: \"1,5\" is no number"},
           {"vertex 0 0 0\n", "", "line 7: a facet ends that has no three vertices"},
           {"vertex 0 0 0\n", "vertex 0 0 0\nvertex 0 0 0\n", "line 7: a facet has more than three vertices"},
           {"  endfacet\n", "", "line 8: a facet begins within a facet"},
           {"  facet normal 0 0 1\n", "", "line 3: a vertex stands outside of a facet"},
           {"endloop", "endlop", "line 7: \"endlop\" is no word of an STL"},
           {"endfacet\nendsolid a square\n", "", "line 14: the file ends within a facet"}}) {
    CAPTURE(from, to);
    CHECK(refusal(read_stl, replaced(text_stl, from, to)) == "invalid: " + message);
  }
  CHECK(refusal(read_stl, "solid\nendsolid\n") == "invalid: the file has no triangles");
}

TEST_CASE("An STL over a limit is too large, and one that is to stop stops") {
  CHECK(refusal(read_stl, binary_stl(square_corners), {4, 2}).empty());
  CHECK(refusal(read_stl, binary_stl(square_corners), {4, 1}).starts_with("too large: "));
  CHECK(refusal(read_stl, binary_stl(square_corners), {3, 2}).starts_with("too large: "));
  CHECK(refusal(read_stl, text_stl, {4, 1}).starts_with("too large: "));
  CHECK(refusal(read_stl, text_stl, {3, 2}).starts_with("too large: "));
  Cancel told;
  told.stop(StopReason::superseded);
  std::string long_text = text_stl;
  for (int i = 0; i < 20'000; ++i) long_text += "\n";
  CHECK(refusal(read_stl, long_text, {}, told) == "stopped");
  CHECK(refusal(read_stl, binary_stl(square_corners), {}, told) == "stopped");
}

TEST_CASE("STL files with damage of any kind are read or refused, and nothing worse") {
  std::mt19937 random(11);
  const std::string binary = binary_stl(square_corners, "solid", 7);
  for (int i = 0; i < 3000; ++i) {
    check_is_read_or_refused(read_stl, damaged(text_stl, random));
    check_is_read_or_refused(read_stl, damaged(binary, random));
  }
  for (std::size_t size = 0; size < binary.size(); ++size)
    CHECK_FALSE(refusal(read_stl, binary.substr(0, size)).empty());
}
