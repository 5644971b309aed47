#include "formats/file_texts.h"
#include "formats/formats.h"
#include "formats/plain_scene.h"

namespace dini {

namespace {

/// Writes parts one after the other; indices count on through the whole file, from 1.
class ObjWriter {
 public:
  ObjWriter(bool colored, const Cancel& cancel) : colored_(colored), steps_(cancel) {}

  void write_head(const FileOptions& options) {
    text_ += "# " + program_of(options) + "\n# unit: meter, z up\n";
    if (const std::string about = about_line(options, true); !about.empty()) text_ += "# " + about + "\n";
  }

  void write(const PlainPart& part) {
    text_ += "o " + part.name + "\n";
    const Tile& mesh = part.mesh;
    const VertexColors colors(part);
    for (std::size_t i = 0; i < mesh.positions.size() && !steps_.stopped(); ++i)
      write_vertex(mesh.positions[i], colors[i]);
    for (std::size_t i = 0; i < mesh.uvs.size() && !steps_.stopped(); ++i) {
      // Textures of OBJ begin at the lower left.
      write_row("vt", std::array{mesh.uvs[i][0], 1 - mesh.uvs[i][1]});
    }
    for (std::size_t i = 0; i < mesh.normals.size() && !steps_.stopped(); ++i) write_row("vn", mesh.normals[i]);
    for (const auto& triangle : mesh.triangles) {
      if (steps_.stopped()) break;
      write_face(triangle, mesh);
    }
    write_curves(part.curves, colors);
    write_points(part.points, colors);
    vertices_ += mesh.positions.size() + part.curves.points.size() + part.points.size();
    uvs_ += mesh.uvs.size();
    normals_ += mesh.normals.size();
  }

  bool stopped() { return steps_.stopped(); }
  std::string take() { return std::move(text_); }

 private:
  template <std::size_t N>
  void write_row(std::string_view keyword, const std::array<float, N>& numbers) {
    text_ += keyword;
    for (const float number : numbers) {
      text_ += ' ';
      append_number(text_, number);
    }
    text_ += '\n';
  }

  void write_vertex(const std::array<float, 3>& place, const PictureColor& color) {
    if (!colored_) return write_row("v", place);
    const auto share = [](std::uint8_t value) { return static_cast<float>(value) / 255; };
    write_row("v", std::array{place[0], place[1], place[2], share(color[0]), share(color[1]), share(color[2])});
  }

  void write_face(const std::array<std::uint32_t, 3>& triangle, const Tile& mesh) {
    text_ += 'f';
    for (const std::uint32_t corner : triangle) {
      text_ += ' ';
      append_count(text_, vertices_ + corner + 1);
      if (mesh.uvs.empty() && mesh.normals.empty()) continue;
      text_ += '/';
      if (!mesh.uvs.empty()) append_count(text_, uvs_ + corner + 1);
      if (mesh.normals.empty()) continue;
      text_ += '/';
      append_count(text_, normals_ + corner + 1);
    }
    text_ += '\n';
  }

  void write_curves(const FloatRuns& curves, const VertexColors& colors) {
    for (const auto& place : curves.points) write_vertex(place, colors[0]);
    std::size_t first = 0;
    for (const std::size_t end : curves.ends) {
      text_ += 'l';
      for (std::size_t i = first; i < end && !steps_.stopped(); ++i) {
        text_ += ' ';
        append_count(text_, vertices_ + i + 1);
      }
      text_ += '\n';
      first = end;
    }
  }

  void write_points(const FloatPoints& points, const VertexColors& colors) {
    for (const auto& place : points) write_vertex(place, colors[0]);
    for (std::size_t i = 0; i < points.size() && !steps_.stopped(); ++i) {
      text_ += "p ";
      append_count(text_, vertices_ + i + 1);
      text_ += '\n';
    }
  }

  std::string text_;
  bool colored_;
  CancelEvery steps_;
  std::size_t vertices_ = 0, uvs_ = 0, normals_ = 0;  ///< of the parts before
};

Expected<WrittenFile, FileError> write(const Scene& scene, const FileOptions& options, const Cancel& cancel) {
  const Carried carried = {.format = "OBJ", .curves = true, .points = true, .colors = true, .graph = true};
  auto plain = plain_scene(scene, options, carried, cancel);
  if (!plain) return plain.error();
  ObjWriter writer(plain->colored, cancel);
  writer.write_head(options);
  for (const PlainPart& part : plain->parts) writer.write(part);
  if (writer.stopped()) return FileError{"encode-failed", "writing was stopped"};
  return std::move(*plain).file(writer.take());
}

}  // namespace

FileFormat obj_format() {
  return {
      .name = "obj",
      .media_types = {"model/obj"},
      .extension = ".obj",
      .doc =
          "Wavefront OBJ in meters, with normals, texture coordinates, colors of vertices, curves and points; one file "
          "without materials.",
      .write = write,
      .vertex_bytes = 640};
}

}  // namespace dini
