#include <cmath>
#include <limits>

#include "formats/file_texts.h"
#include "formats/formats.h"
#include "formats/plain_scene.h"

namespace dini {

namespace {

constexpr std::size_t header_bytes = 80;
constexpr std::size_t triangle_bytes = 50;

/// The direction that three corners turn about, of length 1; zero without area.
std::array<float, 3> normal_of(const FloatPoints& places, const std::array<std::uint32_t, 3>& triangle) {
  const auto at = [&](std::size_t k) {
    const auto& [x, y, z] = places[triangle[k]];
    return Vector{x, y, z};
  };
  const Vector normal = normalized(cross(at(1) - at(0), at(2) - at(0)));
  return {static_cast<float>(normal.x), static_cast<float>(normal.y), static_cast<float>(normal.z)};
}

/// Readers tell binary files from others by the first word, so the header must not begin with "solid".
std::string header_of(const FileOptions& options, bool in_millimeters) {
  std::string header = program_of(options) + (in_millimeters ? ", unit: millimeter, z up" : ", unit: meter, z up");
  header.resize(header_bytes, ' ');
  return header;
}

Expected<WrittenFile, FileError> write(const Scene& scene, const FileOptions& options, const Cancel& cancel) {
  auto plain = plain_scene(scene, options, {.format = "STL", .millimeters = true}, cancel);
  if (!plain) return plain.error();
  if (plain->triangles > std::numeric_limits<std::uint32_t>::max()) {
    return FileError{"limit-exceeded", "an STL holds at most 4294967295 triangles"};
  }
  std::string bytes = header_of(options, plain->in_millimeters);
  bytes.reserve(header_bytes + sizeof(std::uint32_t) + triangle_bytes * plain->triangles);
  append_bytes(bytes, static_cast<std::uint32_t>(plain->triangles));
  CancelEvery steps(cancel);
  for (const PlainPart& part : plain->parts) {
    for (const auto& triangle : part.mesh.triangles) {
      if (steps.stopped()) return FileError{"encode-failed", "writing was stopped"};
      append_bytes(bytes, normal_of(part.mesh.positions, triangle));
      for (const std::uint32_t corner : triangle) append_bytes(bytes, part.mesh.positions[corner]);
      append_bytes(bytes, std::uint16_t{0});
    }
  }
  return std::move(*plain).file(std::move(bytes));
}

}  // namespace

FileFormat stl_format() {
  return {.name = "stl",
          .media_types = {"model/stl"},
          .extension = ".stl",
          .doc =
              "Binary STL in meters, or in millimeters where the document says a unit: the triangles of all meshes, "
              "without names, colors and texture coordinates.",
          .write = write,
          .vertex_bytes = 128};
}

}  // namespace dini
