#include "formats/plain_scene.h"

#include <algorithm>
#include <cmath>

#include "geometry/length_unit.h"
#include "gltf/file_error.h"
#include "gltf/tiles.h"

namespace dini {

namespace {

constexpr double root_of_three = 1.7320508075688772;  ///< From an error per axis to a distance.

/// Names of parts, of which a sentence tells the first few.
class NameList {
 public:
  void add(const std::string& name) {
    if (++count_ <= most_named) text_ += (text_.empty() ? "" : ", ") + name;
  }

  bool empty() const { return count_ == 0; }
  std::string text() const {
    return text_ + (count_ > most_named ? " and " + std::to_string(count_ - most_named) + " more" : "");
  }

 private:
  static constexpr std::size_t most_named = 3;

  std::string text_;
  std::size_t count_ = 0;
};

class Builder {
 public:
  Builder(const FileOptions& options, const Carried& carried, const Cancel& cancel)
      : options_(options), carried_(carried), cancel_(cancel) {}

  std::optional<FileError> add(const Part& part) {
    PlainPart plain{.name = part.name, .material = part.material, .color = part.color};
    if (auto error = std::visit([&](const auto& shape) { return take(shape, plain); }, part.shape)) {
      error->part = part.name;
      return file_error(*error);
    }
    if (cancel_.stopped()) return file_error(canceled());
    if (left_out_) return std::nullopt;
    const std::size_t count = plain.mesh.positions.size() + plain.curves.points.size() + plain.points.size();
    if (count == 0) {
      scene_.notes.push_back({"empty", part.name + " has nothing to draw"});
      return std::nullopt;
    }
    scene_.vertices += count;
    scene_.triangles += plain.mesh.triangles.size();
    scene_.parts.push_back(std::move(plain));
    return std::nullopt;
  }

  Expected<PlainScene, FileError> finish() && {
    const std::string format(carried_.format);
    if (scene_.parts.empty()) {
      if (meshes_.empty() && curves_.empty() && points_.empty()) return FileError{"nothing-to-export", ""};
      if (!carried_.meshes) {
        return FileError{"nothing-to-export",
                         format +
                             " holds only curves, and there is nothing else to write; choose another format, or "
                             "give the export curves or circles"};
      }
      return FileError{"nothing-to-export",
                       format + " holds " + (points_.empty() || carried_.points ? "no curves" : "only meshes") +
                           ", and there is nothing else to write; choose another format, or give the export a mesh"};
    }
    tell(meshes_, format + " holds no meshes; not in the file: ");
    tell(curves_, format + " holds no curves; not in the file: ");
    tell(points_, format + " holds no points; not in the file: ");
    tell(colors_, format + " holds no colors; without theirs in the file: ");
    tell(opacity_, format + " holds no opacity; opaque in the file: ");
    tell(finish_, format + " holds neither metallic nor roughness nor sides; without theirs in the file: ");
    if (!carried_.graph && options_.about.is_object() && options_.about.contains("document")) {
      scene_.notes.push_back({"left-out", format + " has no room for the graph; it is not in the file"});
    }
    scale_to_file();
    return std::move(scene_);
  }

 private:
  /// From the unit of the document to that of the file, and what is lost by rounding.
  void scale_to_file() {
    scene_.position_error = root_of_three * std::ldexp(largest_, -24);
    const std::optional<LengthUnit> unit = unit_of(options_.about);
    if (!unit) return;
    const double meters = meters_of(*unit);
    scene_.in_millimeters = carried_.millimeters;
    const double factor = carried_.millimeters ? millimeters_of(*unit) : meters;
    scene_.position_error *= meters * (factor == 1 ? 1 : 2);
    if (factor == 1) return;
    const auto scale = [&](FloatPoints& points) {
      for (auto& point : points) {
        for (float& value : point) value = static_cast<float>(factor * static_cast<double>(value));
      }
    };
    for (PlainPart& part : scene_.parts) {
      if (cancel_.stopped()) return;
      scale(part.mesh.positions);
      scale(part.curves.points);
      scale(part.points);
    }
  }

  std::optional<EncodeError> take(const SharedMesh& mesh, PlainPart& plain) {
    left_out_ = !carried_.meshes;
    if (left_out_) return leave(plain, meshes_);
    if (mesh == nullptr) return std::nullopt;
    plain.color = mesh->color;
    if (auto error = check_mesh(*mesh)) return error;
    EncodeOptions encode;
    encode.normals = options_.normals;
    auto built = build_tile(*mesh, 0, mesh->triangles.size(), encode, cancel_);
    if (!built) return std::move(built).error();
    plain.mesh = *std::move(built);
    note_looks(*mesh, plain);
    include(plain.mesh.position_box);
    return std::nullopt;
  }

  std::optional<EncodeError> take(const std::vector<Polyline>& polylines, PlainPart& plain) {
    left_out_ = !carried_.curves;
    if (left_out_) return leave(plain, curves_);
    for (const Polyline& polyline : polylines) add_drawable_runs(polyline, plain.curves, cancel_);
    return include(plain.curves.points);
  }

  std::optional<EncodeError> take(const CurveSource& curves, PlainPart& plain) {
    left_out_ = !carried_.curves;
    if (left_out_) return leave(plain, curves_);
    for (std::size_t i = 0; i < curves.count && !cancel_.stopped(); ++i) {
      add_drawable_runs(curves.curve(i), plain.curves, cancel_);
    }
    return include(plain.curves.points);
  }

  std::optional<EncodeError> take(const SharedColumn<Point>& points, PlainPart& plain) {
    left_out_ = !carried_.points;
    if (left_out_) return leave(plain, points_);
    if (points != nullptr) plain.points = drawable_points(*points, cancel_);
    return include(plain.points);
  }

  std::optional<EncodeError> leave(const PlainPart& plain, NameList& names) {
    names.add(plain.name);
    return std::nullopt;
  }

  void note_looks(const Mesh& mesh, const PlainPart& plain) {
    if (plain.mesh.triangles.empty()) return;
    const bool colored = !mesh.colors.empty() || mesh.color != Mesh{}.color;
    const bool clear = mesh.colors.empty() ? mesh.color[3] < 1
                                           : std::any_of(mesh.colors.begin(), mesh.colors.end(),
                                                         [](const auto& color) { return color[3] < 1; });
    scene_.colored = scene_.colored || colored;
    if (colored && !carried_.colors) colors_.add(plain.name);
    if (clear && !carried_.opacity) opacity_.add(plain.name);
    if (mesh.finish != Finish{}) finish_.add(plain.name);
  }

  std::optional<EncodeError> include(const FloatPoints& points) {
    for (const auto& point : points) {
      for (const float value : point) largest_ = std::max(largest_, std::abs(static_cast<double>(value)));
    }
    return std::nullopt;
  }

  void include(const FloatBox& box) { largest_ = std::max(largest_, static_cast<double>(box.largest())); }

  void tell(const NameList& names, const std::string& sentence) {
    if (!names.empty()) scene_.notes.push_back({"left-out", sentence + names.text()});
  }

  const FileOptions& options_;
  const Carried& carried_;
  const Cancel& cancel_;
  PlainScene scene_;
  bool left_out_ = false;  ///< the part at hand
  NameList meshes_, curves_, points_, colors_, opacity_, finish_;
  double largest_ = 0;
};

}  // namespace

WrittenFile PlainScene::file(std::string bytes) && {
  return {std::move(bytes), vertices, triangles, position_error, std::move(notes)};
}

Expected<PlainScene, FileError> plain_scene(const Scene& scene, const FileOptions& options, const Carried& carried,
                                            const Cancel& cancel) {
  Builder builder(options, carried, cancel);
  for (const Part& part : scene.parts) {
    if (auto error = builder.add(part)) return std::move(*error);
  }
  return std::move(builder).finish();
}

}  // namespace dini
