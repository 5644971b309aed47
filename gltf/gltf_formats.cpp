#include "gltf/gltf_formats.h"

#include <algorithm>
#include <charconv>

#include "geometry/length_unit.h"
#include "gltf/file_error.h"
#include "gltf/glb_writer.h"

namespace dini {

namespace {

constexpr double root_of_three = 1.7320508075688772;  ///< From an error per axis to a distance.

std::string digits(double value, int count) {
  char text[32];
  return {text, std::to_chars(text, text + sizeof(text), value, std::chars_format::general, count).ptr};
}

/// Tells the part whose texture coordinates lose the most to rounding, and how many lose much.
FileNote note_of(const std::vector<RoughUvs>& rough) {
  const RoughUvs& worst = *std::max_element(rough.begin(), rough.end(),
                                            [](const RoughUvs& a, const RoughUvs& b) { return a.error < b.error; });
  return {"imprecise",
          "the texture coordinates of " + worst.part + " reach from " + digits(worst.minimum, 6) + " to " +
              digits(worst.maximum, 6) + " and are rounded by up to " + digits(worst.error, 2) +
              ", where 1 is the size of the picture" +
              (rough.size() == 1 ? "" : "; so are those of " + std::to_string(rough.size() - 1) + " more")};
}

Expected<WrittenFile, FileError> write(const Scene& scene, const FileOptions& options, const Cancel& cancel,
                                       GltfContainer container) {
  EncodeOptions encode;
  encode.position_bits = options.position_bits;
  encode.normal_bits = options.normal_bits;
  encode.uv_bits = options.uv_bits;
  encode.speed = options.speed;
  encode.draco = options.draco;
  encode.normals = options.normals;
  encode.extras = options.about;
  encode.container = container;
  encode.topologies = options.topologies;
  EncodeResult<EncodedScene> encoded = encode_scene(scene, encode, cancel);
  if (!encoded) return file_error(encoded.error());
  EncodedScene& written = *encoded;
  WrittenFile file{
      std::move(written.file), written.vertices, written.triangles,
      root_of_three * meters_of(unit_of(options.about).value_or(LengthUnit::meter)) * written.position_error};
  file.attribute_errors = written.attribute_errors;
  if (!written.rough_uvs.empty()) file.notes.push_back(note_of(written.rough_uvs));
  for (const std::string& part : written.empty_parts)
    file.notes.push_back(FileNote{"empty", part + " has nothing to draw"});
  return file;
}

}  // namespace

FileFormat glb_format() {
  return {.name = "glb",
          .media_types = {"model/gltf-binary"},
          .extension = ".glb",
          .doc = "glTF 2.0 in one binary file, meshes compressed with Draco unless the export says not to.",
          .write = [](const Scene& scene, const FileOptions& options, const Cancel& cancel) {
            return write(scene, options, cancel, GltfContainer::binary);
          }};
}

FileFormat gltf_format() {
  return {.name = "gltf",
          .media_types = {"model/gltf+json"},
          .extension = ".gltf",
          .doc = "glTF 2.0 as JSON with its data inside, meshes compressed with Draco unless the export says not to.",
          .write = [](const Scene& scene, const FileOptions& options, const Cancel& cancel) {
            return write(scene, options, cancel, GltfContainer::embedded);
          }};
}

}  // namespace dini
