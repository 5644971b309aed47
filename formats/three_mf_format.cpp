#include <map>
#include <set>

#include "formats/file_texts.h"
#include "formats/formats.h"
#include "formats/plain_scene.h"
#include "formats/three_mf_mesh.h"
#include "formats/zip_archive.h"
#include "geometry/markup.h"

namespace dini {

namespace {

constexpr const char* content_types =
    R"(<?xml version="1.0" encoding="UTF-8"?>
<Types xmlns="http://schemas.openxmlformats.org/package/2006/content-types">
<Default Extension="rels" ContentType="application/vnd.openxmlformats-package.relationships+xml"/>
<Default Extension="model" ContentType="application/vnd.ms-package.3dmanufacturing-3dmodel+xml"/>
</Types>
)";

constexpr const char* relations =
    R"(<?xml version="1.0" encoding="UTF-8"?>
<Relationships xmlns="http://schemas.openxmlformats.org/package/2006/relationships">
<Relationship Id="model" Target="/3D/3dmodel.model" Type="http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel"/>
</Relationships>
)";

constexpr std::size_t materials_id = 1;  ///< of the resources: the materials first, then colors and objects

/// "#FF8000FF".
std::string hexadecimal(const PictureColor& color) {
  constexpr std::string_view digits = "0123456789ABCDEF";
  std::string text = "#";
  for (const std::uint8_t channel : color) {
    text += digits[channel / 16];
    text += digits[channel % 16];
  }
  return text;
}

/// A list of colors, each once, in the order in which they are asked for.
class ColorList {
 public:
  std::size_t number_of(const PictureColor& color) {
    const auto [entry, fresh] = numbers_.try_emplace(color, numbers_.size());
    if (fresh) text_ += "<m:color color=\"" + hexadecimal(color) + "\"/>\n";
    return entry->second;
  }

  const std::string& text() const { return text_; }

 private:
  std::map<PictureColor, std::size_t> numbers_;
  std::string text_;
};

class ModelWriter {
 public:
  explicit ModelWriter(const Cancel& cancel) : cancel_(cancel), steps_(cancel) {}

  /// Adds the object of a mesh; false when joining its vertices leaves no triangle.
  bool add(const PlainPart& part) {
    const JoinedMesh mesh = joined_mesh(part.mesh, cancel_);
    if (mesh.triangles.empty()) return false;
    const std::size_t material = material_of(part);
    const bool colored = !part.mesh.colors.empty();
    const std::size_t colors = colored ? next_id_++ : 0;
    const std::string triangles = triangles_of(mesh, part, colors);
    const std::size_t id = next_id_++;
    objects_ += "<object id=\"" + std::to_string(id) + "\" name=\"" + escaped_markup(part.name) + "\" type=\"" +
                (mesh.closed ? "model" : "surface") + "\" pid=\"" + std::to_string(materials_id) + "\" pindex=\"" +
                std::to_string(material) + "\"><mesh>\n<vertices>\n";
    for (const auto& place : mesh.places) {
      if (steps_.stopped()) break;
      append_vertex(place);
    }
    objects_ += "</vertices>\n<triangles>\n" + triangles + "</triangles>\n</mesh></object>\n";
    items_ += "<item objectid=\"" + std::to_string(id) + "\"/>\n";
    vertices_ += mesh.places.size();
    triangles_ += mesh.triangles.size();
    return true;
  }

  std::string model(const FileOptions& options, bool in_millimeters) const {
    std::string text =
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<model unit=\"" +
        std::string(in_millimeters ? "millimeter" : "meter") +
        "\" xml:lang=\"en-US\" "
        "xmlns=\"http://schemas.microsoft.com/3dmanufacturing/core/2015/02\" "
        "xmlns:m=\"http://schemas.microsoft.com/3dmanufacturing/material/2015/02\">\n<metadata name=\"Application\">" +
        escaped_markup(program_of(options)) + "</metadata>\n";
    if (const std::string about = about_line(options, true); !about.empty()) {
      text += "<metadata name=\"Description\">" + escaped_markup(about) + "</metadata>\n";
    }
    return text + "<resources>\n<basematerials id=\"" + std::to_string(materials_id) + "\">\n" + materials_ +
           "</basematerials>\n" + objects_ + "</resources>\n<build>\n" + items_ + "</build>\n</model>\n";
  }

  std::size_t vertices() const { return vertices_; }
  std::size_t triangles() const { return triangles_; }

 private:
  /// The material of a part; parts share one by name and color.
  std::size_t material_of(const PlainPart& part) {
    const PictureColor color = part.mesh.colors.empty() ? picture_color(part.color) : PictureColor{255, 255, 255, 255};
    const std::string& name = part.material.empty() ? part.name : part.material;
    const auto [entry, fresh] = numbers_.try_emplace({name, color}, numbers_.size());
    if (fresh) {
      // As in glTF: another color of the same name is called like the part where it shows first.
      const std::string& free = names_.insert(name).second ? name : *names_.insert(part.name).first;
      materials_ += "<base name=\"" + escaped_markup(free) + "\" displaycolor=\"" + hexadecimal(color) + "\"/>\n";
    }
    return entry->second;
  }

  /// The triangles, whose corners have colors where the vertices do; those are a resource before the object.
  std::string triangles_of(const JoinedMesh& mesh, const PlainPart& part, std::size_t colors) {
    constexpr std::array<const char*, 3> vertex_names = {" v1=\"", " v2=\"", " v3=\""};
    constexpr std::array<const char*, 3> color_names = {" p1=\"", " p2=\"", " p3=\""};
    const VertexColors color_of(part);
    ColorList list;
    std::string text;
    for (std::size_t i = 0; i < mesh.triangles.size() && !steps_.stopped(); ++i) {
      text += "<triangle";
      for (std::size_t k = 0; k < 3; ++k) append_attribute(text, vertex_names[k], mesh.triangles[i][k]);
      if (colors != 0) {
        append_attribute(text, " pid=\"", colors);
        for (std::size_t k = 0; k < 3; ++k) {
          append_attribute(text, color_names[k], list.number_of(color_of[mesh.corners[i][k]]));
        }
      }
      text += "/>\n";
    }
    if (colors != 0) {
      objects_ += "<m:colorgroup id=\"" + std::to_string(colors) + "\">\n" + list.text() + "</m:colorgroup>\n";
    }
    return text;
  }

  static void append_attribute(std::string& text, const char* name, std::size_t value) {
    text += name;
    append_count(text, value);
    text += '"';
  }

  void append_vertex(const std::array<float, 3>& place) {
    constexpr std::array<const char*, 3> names = {"<vertex x=\"", "\" y=\"", "\" z=\""};
    for (std::size_t k = 0; k < 3; ++k) {
      objects_ += names[k];
      append_number(objects_, place[k]);
    }
    objects_ += "\"/>\n";
  }

  const Cancel& cancel_;
  CancelEvery steps_;
  std::map<std::pair<std::string, PictureColor>, std::size_t> numbers_;
  std::set<std::string> names_;
  std::string materials_, objects_, items_;
  std::size_t next_id_ = materials_id + 1;
  std::size_t vertices_ = 0, triangles_ = 0;
};

Expected<WrittenFile, FileError> write(const Scene& scene, const FileOptions& options, const Cancel& cancel) {
  auto plain = plain_scene(
      scene, options, {.format = "3MF", .colors = true, .opacity = true, .graph = true, .millimeters = true}, cancel);
  if (!plain) return plain.error();
  ModelWriter writer(cancel);
  for (const PlainPart& part : plain->parts) {
    if (!writer.add(part)) plain->notes.push_back({"empty", part.name + " has nothing to draw"});
  }
  if (cancel.stopped()) return FileError{"encode-failed", "writing was stopped"};
  if (writer.triangles() == 0) return FileError{"nothing-to-export", ""};
  plain->vertices = writer.vertices();
  plain->triangles = writer.triangles();
  auto bytes = zip_archive({{"[Content_Types].xml", content_types},
                            {"_rels/.rels", relations},
                            {"3D/3dmodel.model", writer.model(options, plain->in_millimeters)}},
                           cancel);
  if (!bytes) return bytes.error();
  return std::move(*plain).file(*std::move(bytes));
}

}  // namespace

FileFormat three_mf_format() {
  return {.name = "3mf",
          .media_types = {"model/3mf"},
          .extension = ".3mf",
          .doc =
              "3MF for printing, in meters, or in millimeters where the document says a unit: an object for each mesh, "
              "with its name and colors.",
          .write = write,
          .vertex_bytes = 1024};
}

}  // namespace dini
