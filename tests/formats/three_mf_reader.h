#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace dini::support {

/// An object of a 3MF, as lib3mf sees it.
struct ThreeMfObject {
  std::string name;
  bool is_model = false;  ///< rather than a surface
  bool is_manifold = false;
  std::vector<std::array<float, 3>> vertices;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<std::array<std::array<int, 4>, 3>> colors;  ///< of the corners of each triangle; empty without
  std::string material;                                   ///< of the first triangle, with its color: "skin #FF0000FF"
};

struct ThreeMfFile {
  bool in_meters = false;
  bool in_millimeters = false;
  std::vector<std::string> warnings;
  std::vector<ThreeMfObject> objects;
};

/// Reads a 3MF strictly by the reference implementation of the 3MF consortium; fails the running test if that refuses.
ThreeMfFile read_three_mf(const std::string& path);

}  // namespace dini::support
