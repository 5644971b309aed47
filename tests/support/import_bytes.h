#pragma once

// Small mesh files made by hand, and files that mean harm made out of them.

#include <bit>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/imported_mesh.h"
#include "geometry/json.h"

namespace dini::support {

/// Numbers as bytes, the least significant first.
class Bytes {
 public:
  Bytes& u8(std::uint32_t value) { return put(value, 1); }
  Bytes& u16(std::uint32_t value) { return put(value, 2); }
  Bytes& u32(std::uint32_t value) { return put(value, 4); }
  Bytes& f32(float value) { return put(std::bit_cast<std::uint32_t>(value), 4); }
  Bytes& f32s(const std::vector<float>& values) {
    for (const float value : values) f32(value);
    return *this;
  }

  std::string text;

 private:
  Bytes& put(std::uint32_t value, int size) {
    for (int i = 0; i < size; ++i) text += static_cast<char>(value >> 8 * i & 255);
    return *this;
  }
};

/// A GLB of a JSON and a binary chunk.
inline std::string glb_of(std::string json, std::string binary) {
  json.resize((json.size() + 3) / 4 * 4, ' ');
  binary.resize((binary.size() + 3) / 4 * 4, '\0');
  Bytes glb;
  glb.text = "glTF";
  glb.u32(2).u32(static_cast<std::uint32_t>(28 + json.size() + binary.size()));
  glb.u32(static_cast<std::uint32_t>(json.size())).text += "JSON" + json;
  glb.u32(static_cast<std::uint32_t>(binary.size())).text += std::string("BIN\0", 4) + binary;
  return glb.text;
}

/// The data of `quad_document`: four corners of a unit square in the plane y = 0 (which is level in glTF), texture
/// coordinates, colors as shares of 255, and two triangles.
inline std::string quad_binary() {
  Bytes bytes;
  bytes.f32s({0, 0, 0, 1, 0, 0, 1, 0, -1, 0, 0, -1});  // 48 bytes from 0
  bytes.f32s({0, 0, 1, 0, 1, 1, 0, 1});                // 32 from 48
  for (const std::uint32_t c : {255, 0, 0, 255, 0, 255, 0, 255, 0, 0, 255, 255, 51, 51, 51, 255})
    bytes.u8(c);                                                  // 16 from 80
  for (const std::uint32_t i : {0, 1, 2, 0, 2, 3}) bytes.u16(i);  // 12 from 96
  return bytes.text;
}

inline dini::Json quad_document() {
  return dini::Json::parse(R"({
    "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}],
    "nodes": [{"mesh": 0}],
    "meshes": [{"primitives": [{"attributes": {"POSITION": 0, "TEXCOORD_0": 1, "COLOR_0": 2}, "indices": 3}]}],
    "buffers": [{"byteLength": 108}],
    "bufferViews": [
      {"buffer": 0, "byteOffset": 0, "byteLength": 48}, {"buffer": 0, "byteOffset": 48, "byteLength": 32},
      {"buffer": 0, "byteOffset": 80, "byteLength": 16}, {"buffer": 0, "byteOffset": 96, "byteLength": 12}],
    "accessors": [
      {"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3"},
      {"bufferView": 1, "componentType": 5126, "count": 4, "type": "VEC2"},
      {"bufferView": 2, "componentType": 5121, "normalized": true, "count": 4, "type": "VEC4"},
      {"bufferView": 3, "componentType": 5123, "count": 6, "type": "SCALAR"}]})");
}

inline std::string quad_glb() { return glb_of(quad_document().dump(), quad_binary()); }

/// A square of two triangles with a seam down its diagonal, colors, and the same normal everywhere.
inline constexpr std::string_view quad_obj =
    "# a square\n"
    "v 0 0 0 1 0 0\nv 1 0 0 0 1 0\nv 1 1 0 0 0 1\nv 0 1 0 1 1 1\n"
    "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nvt 0.25 0.25\n"
    "vn 0 0 1\n"
    "f 1/1/1 2/2/1 3/3/1\n"
    "f -4/5/-1 -2/3/-1 -1/4/-1\n";

inline constexpr std::string_view quad_ply =
    "ply\nformat ascii 1.0\ncomment a square\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
    "property float s\nproperty float t\nproperty uchar red\nproperty uchar green\nproperty uchar blue\n"
    "element face 1\nproperty list uchar int vertex_indices\nend_header\n"
    "0 0 0 0 0 255 0 0\n1 0 0 1 0 0 255 0\n1 1 0 1 1 0 0 255\n0 1 0 0 1 255 255 255\n4 0 1 2 3\n";

/// The same square without colors and texture coordinates, as text of two kinds of hands.
inline constexpr std::string_view quad_stl =
    "solid a square\n"
    "  facet normal 0 0 1\n    outer loop\n      vertex 0 0 0\n      vertex 1e0 0 0\n      vertex 1 1 0\n    endloop\n"
    "  endfacet\n"
    "FACET NORMAL nan nan nan\r\nouter loop\nVertex 0 0 0\nvertex 1 1 -0\nvertex 0 1 0\nendloop\nendfacet\n"
    "endsolid a square\n";

/// What a reader says to `bytes`: nothing when it takes them, else its code and sentence.
template <class Read>
std::string refusal(Read read, std::string_view bytes, const ImportLimits& limits = {}, const Cancel& cancel = {}) {
  // A copy of its own, so that a read past the end is one for the address sanitizer too.
  const std::vector<char> exact(bytes.begin(), bytes.end());
  const ImportResult result = read(std::string_view(exact.data(), exact.size()), limits, cancel);
  if (result) return "";
  const auto& [code, detail] = result.error();
  if (code == ImportError::Code::stopped) return "stopped";
  return (code == ImportError::Code::invalid ? "invalid: " : "too large: ") + detail;
}

}  // namespace dini::support
