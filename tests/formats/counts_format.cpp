#include "tests/formats/counts_format.h"

namespace dini::support {

namespace {

Expected<WrittenFile, FileError> write(const Scene& scene, const FileOptions& options, const Cancel&) {
  std::size_t meshes = 0;
  WrittenFile file;
  for (const Part& part : scene.parts) {
    const auto* mesh = std::get_if<SharedMesh>(&part.shape);
    if (mesh == nullptr) continue;
    ++meshes;
    file.vertices += (*mesh)->positions.size();
    file.triangles += (*mesh)->triangles.size();
  }
  if (meshes == 0) return FileError{"nothing-to-export", "there are no meshes"};
  if (meshes < scene.parts.size()) file.notes.push_back({"left-out", "only meshes are counted"});
  file.bytes = std::to_string(meshes) + " meshes, " + std::to_string(file.triangles) + " triangles, by " +
               options.about.value("engine", "nobody") + "\n";
  return file;
}

}  // namespace

FileFormat counts_format() {
  return {.name = "counts",
          .media_types = {"text/x-counts"},
          .extension = ".counts",
          .doc = "How much there is.",
          .write = write};
}

}  // namespace dini::support
