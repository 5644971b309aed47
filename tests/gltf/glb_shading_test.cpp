// ColorList and normals of GLB files by the glTF 2.0 specification.

#include "geometry/json.h"
#include "tests/support/glb_parts.h"

using namespace dini;

namespace {

using namespace support;
using json = dini::Json;

GlbParts triangle_with_material(const json& material) {
  GlbParts parts = triangle_parts();
  parts.document["materials"] = {material};
  parts.document["meshes"][0]["primitives"][0]["material"] = 0;
  return parts;
}

TEST_CASE("Alpha counts under BLEND, is compared under MASK, and does not count otherwise") {
  struct Case {
    json material;
    float vertex_alpha, alpha;
  };
  const auto material = [](const char* mode, double alpha, json cutoff) {
    json made = {{"pbrMetallicRoughness", {{"baseColorFactor", {0.5, 0.25, 1, alpha}}}}};
    if (*mode != 0) made["alphaMode"] = mode;
    if (!cutoff.is_null()) made["alphaCutoff"] = cutoff;
    return made;
  };
  for (const auto& [made, vertex_alpha, alpha] : std::vector<Case>{{material("", 0.3, {}), 1, 1},
                                                                   {material("", 0.3, 0.9), 0, 1},
                                                                   {material("OPAQUE", 0, {}), 0.5f, 1},
                                                                   {material("MASK", 0.3, 0.2), 1, 1},
                                                                   {material("MASK", 0.3, {}), 1, 0},
                                                                   {material("MASK", 0.5, {}), 1, 1},
                                                                   {material("MASK", 1, {}), 0.25f, 0},
                                                                   {material("MASK", 1, 2), 1, 0},
                                                                   {material("MASK", 0, 0), 0, 1},
                                                                   {material("BLEND", 0.5, {}), 0.5f, 0.25f}}) {
    CAPTURE(made.dump(), vertex_alpha);
    GlbParts parts = triangle_with_material(made);
    parts.document["meshes"][0]["primitives"][0]["attributes"]["COLOR_0"] = parts.accessor(
        "VEC4", gltf_f32, 3, Bytes().f32s({1, 1, 1, vertex_alpha, 1, 1, 1, vertex_alpha, 1, 1, 1, vertex_alpha}));
    const ReadFile file = read(parts);
    CHECK(file.mesh.colors == ColorList(3, {0.5f, 0.25f, 1, alpha}));
    CHECK(file.warnings.size() == (alpha == 0 ? 1 : 0));
  }
  CHECK(read(triangle_with_material(material("MASK", 0.1, {}))).warnings ==
        Sentences{"3 vertices lie below the alpha cutoff of their material and become transparent"});
  // White and opaque is no color at all.
  CHECK(read(triangle_with_material({{"pbrMetallicRoughness", {{"baseColorFactor", {1, 1, 1, 0.5}}}}}))
            .mesh.colors.empty());
  CHECK(refusal_of(triangle_with_material({{"alphaMode", "GLASS"}})).find("alphaMode") != std::string::npos);
  const json older = {{"extensions", {{"KHR_materials_pbrSpecularGlossiness", {{"diffuseFactor", {0.5, 0, 0, 1}}}}}}};
  CHECK(read(triangle_with_material(older)).mesh.colors == ColorList(3, {0.5f, 0, 0, 1}));
}

/// The corners of a unit cube, and its twelve triangles facing outward.
const std::vector<float> cube = {0, 0, 0, 0, 0, 1, 0, 1, 0, 0, 1, 1, 1, 0, 0, 1, 0, 1, 1, 1, 0, 1, 1, 1};
const std::vector<std::uint32_t> cube_triangles = {0, 1, 3, 0, 3, 2, 4, 6, 7, 4, 7, 5, 0, 4, 5, 0, 5, 1,
                                                   2, 3, 7, 2, 7, 6, 0, 2, 6, 0, 6, 4, 1, 5, 7, 1, 7, 3};

GlbParts cube_parts() {
  GlbParts parts;
  const std::size_t positions = parts.positions(cube);
  parts.primitive({{"POSITION", positions}})["indices"] =
      parts.accessor("SCALAR", gltf_u8, 36, bytes_of(cube_triangles));
  return parts;
}

/// Every normal is that of the planes of the triangles around its vertex.
void check_flat(const Mesh& mesh) {
  for (const auto& [a, b, c] : mesh.triangles) {
    const Vector p = to_vector(mesh.positions[a]);
    const Vector plane = normalized(cross(to_vector(mesh.positions[b]) - p, to_vector(mesh.positions[c]) - p));
    for (const std::uint32_t vertex : {a, b, c}) CHECK(length(mesh.normals[vertex] - plane) < 2e-6);
  }
}

TEST_CASE("A primitive without normals comes out flat, its neighbors with normals as they are") {
  const ReadFile alone = read(cube_parts());
  CHECK(alone.mesh.positions.size() == 24);
  CHECK(alone.mesh.triangles.size() == 12);
  CHECK(alone.warnings.empty());
  check_flat(alone.mesh);
  GlbParts both = cube_parts();
  const std::size_t positions = both.positions(flat_triangle);
  both.primitive({{"POSITION", positions}, {"NORMAL", both.positions({1, 0, 0, 0, 1, 0, 0, 0, 2})}});
  both.document["nodes"][0]["scale"] = {-1, 2, 1};  // it mirrors
  const ReadFile file = read(both);
  REQUIRE(file.mesh.positions.size() == 27);
  CHECK(file.mesh.normals[24] == Vector{-1, 0, 0});
  CHECK(file.mesh.normals[25] == Vector{0, 1, 0});
  Mesh flat = file.mesh;
  flat.triangles.resize(12);
  check_flat(flat);
}

TEST_CASE("Where flat normals need more vertices than the limit, they are smooth, and that is told") {
  const ImportResult result = read_glb_mesh(cube_parts().glb(), {23, 12});
  const ReadFile file(result);
  CHECK(file.mesh.positions.size() == 8);
  CHECK(length(file.mesh.normals[7] - normalized(Vector{1, 1, 1})) < 1e-12);
  CHECK(file.warnings == Sentences{"12 triangles without normals get smooth ones, since flat ones need more vertices "
                                   "than the limit"});
}

}  // namespace
