#include <limits>

#include "formats/file_texts.h"
#include "formats/formats.h"
#include "formats/plain_scene.h"

namespace dini {

namespace {

/// The properties that every vertex of the file has, since one of a mesh has them.
struct Properties {
  bool normals = false, uvs = false, colors = false;
};

Properties properties_of(const PlainScene& scene) {
  Properties properties;
  properties.colors = scene.colored;
  for (const PlainPart& part : scene.parts) {
    properties.normals = properties.normals || !part.mesh.normals.empty();
    properties.uvs = properties.uvs || !part.mesh.uvs.empty();
  }
  return properties;
}

std::string header_of(const PlainScene& scene, const Properties& properties, const FileOptions& options) {
  std::string text =
      "ply\nformat binary_little_endian 1.0\ncomment " + program_of(options) + "\ncomment unit: meter, z up\n";
  if (const std::string about = about_line(options, false); !about.empty()) text += "comment " + about + "\n";
  text += "element vertex " + std::to_string(scene.vertices) + "\n";
  const auto declare = [&](const char* type, std::initializer_list<const char*> names) {
    for (const char* const name : names) text += "property " + std::string(type) + " " + name + "\n";
  };
  declare("float", {"x", "y", "z"});
  if (properties.normals) declare("float", {"nx", "ny", "nz"});
  if (properties.uvs) declare("float", {"s", "t"});
  if (properties.colors) declare("uchar", {"red", "green", "blue", "alpha"});
  return text + "element face " + std::to_string(scene.triangles) +
         "\nproperty list uchar int vertex_indices\nend_header\n";
}

void append_vertices(const PlainPart& part, const Properties& properties, std::string& bytes, CancelEvery& steps) {
  const VertexColors colors(part);
  const Tile& mesh = part.mesh;
  const FloatPoints& places = mesh.positions.empty() ? part.points : mesh.positions;
  for (std::size_t i = 0; i < places.size() && !steps.stopped(); ++i) {
    append_bytes(bytes, places[i]);
    if (properties.normals) append_bytes(bytes, mesh.normals.empty() ? std::array<float, 3>{} : mesh.normals[i]);
    if (properties.uvs) {
      // Textures of PLY begin at the lower left.
      const std::array<float, 2> uv = mesh.uvs.empty() ? std::array<float, 2>{} : mesh.uvs[i];
      append_bytes(bytes, std::array{uv[0], 1 - uv[1]});
    }
    if (properties.colors) append_bytes(bytes, colors[i]);
  }
}

void append_faces(const PlainPart& part, std::size_t first, std::string& bytes, CancelEvery& steps) {
  for (const auto& triangle : part.mesh.triangles) {
    if (steps.stopped()) return;
    append_bytes(bytes, std::uint8_t{3});
    for (const std::uint32_t corner : triangle) append_bytes(bytes, static_cast<std::int32_t>(first + corner));
  }
}

Expected<WrittenFile, FileError> write(const Scene& scene, const FileOptions& options, const Cancel& cancel) {
  auto plain = plain_scene(scene, options, {.format = "PLY", .points = true, .colors = true, .opacity = true}, cancel);
  if (!plain) return plain.error();
  if (plain->vertices > std::numeric_limits<std::int32_t>::max()) {
    return FileError{"limit-exceeded", "a PLY holds at most 2147483647 vertices"};
  }
  const Properties properties = properties_of(*plain);
  std::string bytes = header_of(*plain, properties, options);
  CancelEvery steps(cancel);
  for (const PlainPart& part : plain->parts) append_vertices(part, properties, bytes, steps);
  std::size_t first = 0;
  for (const PlainPart& part : plain->parts) {
    append_faces(part, first, bytes, steps);
    first += part.mesh.positions.size() + part.points.size();
  }
  if (steps.stopped()) return FileError{"encode-failed", "writing was stopped"};
  return std::move(*plain).file(std::move(bytes));
}

}  // namespace

FileFormat ply_format() {
  return {
      .name = "ply",
      .media_types = {"model/ply"},
      .extension = ".ply",
      .doc = "Binary PLY in meters: all meshes as one, with normals, texture coordinates and colors, and loose points.",
      .write = write,
      .vertex_bytes = 192};
}

}  // namespace dini
