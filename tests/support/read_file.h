#pragma once

// What a mesh file is read as, in a form that a test can write down.

#include <catch2/catch.hpp>

#include "geometry/imported_mesh.h"
#include "geometry/validate.h"

namespace dini::support {

using PlaceList = std::vector<std::array<double, 3>>;
using ColorList = std::vector<std::array<float, 4>>;
using Sentences = std::vector<std::string>;

/// Where the corners of the triangle are that most of the files hold.
inline const PlaceList triangle_places = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};

/// A mesh that was read. Fails the test when the file was refused.
struct ReadFile {
  Mesh mesh;
  std::vector<std::string> warnings;

  explicit ReadFile(const ImportResult& result) {
    if (!result) FAIL(result.error().detail);
    mesh = result->mesh;
    warnings = result->warnings;
    CHECK_FALSE(mesh_defect(mesh));
  }

  PlaceList positions() const {
    PlaceList found;
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
      found.push_back({mesh.positions[i].x, mesh.positions[i].y, mesh.positions[i].z});
    }
    return found;
  }

  /// The corners of the triangles, whatever numbers their vertices have.
  std::vector<std::array<std::array<double, 3>, 3>> triangles() const {
    const auto places = positions();
    std::vector<std::array<std::array<double, 3>, 3>> found;
    for (const auto& [a, b, c] : mesh.triangles) found.push_back({places[a], places[b], places[c]});
    return found;
  }
};

}  // namespace dini::support
