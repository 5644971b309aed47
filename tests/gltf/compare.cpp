#include "tests/gltf/compare.h"

#include <algorithm>
#include <catch2/catch.hpp>

#include "gltf/glb_reader.h"

namespace dini::compare {
namespace {

std::array<float, 3> to_float(const Point& p) {
  return {static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)};
}

template <class Rounding>
std::vector<Triangle> triangles_of(const Mesh& mesh, const Rounding& rounding) {
  std::vector<Triangle> result;
  for (const auto& [a, b, c] : mesh.triangles) {
    if (a == b || b == c || c == a) continue;
    Triangle triangle;
    std::size_t corner = 0;
    for (const std::uint32_t vertex : {a, b, c}) {
      triangle[corner++] = {rounding(to_float(mesh.positions[vertex])),
                            mesh.normals.empty() ? Vector{} : mesh.normals[vertex]};
    }
    std::array<Triangle, 3> turns = {
        triangle, {triangle[1], triangle[2], triangle[0]}, {triangle[2], triangle[0], triangle[1]}};
    const auto positions = [](const Triangle& t) { return std::array{t[0].position, t[1].position, t[2].position}; };
    result.push_back(*std::min_element(turns.begin(), turns.end(), [&](const Triangle& left, const Triangle& right) {
      return positions(left) < positions(right);
    }));
  }
  std::sort(result.begin(), result.end(), [](const Triangle& left, const Triangle& right) {
    return std::array{left[0].position, left[1].position, left[2].position} <
           std::array{right[0].position, right[1].position, right[2].position};
  });
  return result;
}

}  // namespace

QuantizationGrid grid_of(const Scene& scene, int bits) {
  FloatBox box;
  for (const Part& part : scene.parts) {
    const auto* mesh = std::get_if<SharedMesh>(&part.shape);
    if (mesh == nullptr) continue;
    for (const auto& [a, b, c] : (*mesh)->triangles) {
      if (a == b || b == c || c == a) continue;
      for (const std::uint32_t vertex : {a, b, c}) box.include(to_float((*mesh)->positions[vertex]));
    }
  }
  return QuantizationGrid(box, bits);
}

std::vector<Triangle> rounded_triangles(const Mesh& mesh, const QuantizationGrid& grid) {
  return triangles_of(mesh, [&](const std::array<float, 3>& p) {
    return std::array<float, 3>{grid.decoded(0, p[0]), grid.decoded(1, p[1]), grid.decoded(2, p[2])};
  });
}

std::vector<Triangle> stored_triangles(const Mesh& mesh) {
  return triangles_of(mesh, [](const std::array<float, 3>& p) { return p; });
}

bool same_positions(const std::vector<Triangle>& a, const std::vector<Triangle>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const Triangle& left, const Triangle& right) {
    return left[0].position == right[0].position && left[1].position == right[1].position &&
           left[2].position == right[2].position;
  });
}

double largest_normal_angle(const std::vector<Triangle>& a, const std::vector<Triangle>& b) {
  double largest = 0;
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) {
    for (std::size_t corner = 0; corner < 3; ++corner) {
      const Vector& left = a[i][corner].normal;
      const Vector& right = b[i][corner].normal;
      largest = std::max(largest, std::atan2(length(cross(left, right)), dot(left, right)));
    }
  }
  return largest;
}

const Mesh& mesh_of(const Scene& scene, std::size_t index) {
  return *std::get<SharedMesh>(scene.parts.at(index).shape);
}

EncodedScene encode(const Scene& scene, const EncodeOptions& options) {
  auto result = encode_scene(scene, options, Cancel());
  if (!result) FAIL(result.error().part << ": " << result.error().detail);
  return *std::move(result);
}

Scene decode(const std::string& glb) {
  auto scene = read_glb(glb);
  REQUIRE(scene);
  return std::move(*scene);
}

EncodeError failure(const Scene& scene, const EncodeOptions& options) {
  const auto result = encode_scene(scene, options, Cancel());
  REQUIRE_FALSE(result);
  return result.error();
}

}  // namespace dini::compare
