#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "geometry/cancel.h"
#include "geometry/json.h"
#include "geometry/mesh.h"
#include "gltf/encode_options.h"
#include "gltf/lines.h"
#include "gltf/mesh_encoder.h"

namespace dini {

/// A glTF file while it grows: nodes with meshes under one root that turns Z up into glTF's Y up, or under groups below
/// it. Its JSON is kept as the text of the objects that are finished, so a file of many parts takes no more memory than
/// its own size. Throws what Json throws for a name that is no UTF-8.
class GlbModel {
 public:
  /// `extras` is what the file says about itself, or null.
  GlbModel(const std::string& generator, const Json& extras);

  /// Starts a node without a mesh; parts belong to it until `end_group`. One without parts gets the extra
  /// "drawable": false.
  void begin_group(const std::string& name, Json extras);
  void end_group();

  /// The node and mesh that the primitives which follow belong to; without any it is left out.
  struct PartNames {
    std::string node, mesh, material;
    Json extras = nullptr;
  };
  void begin_part(PartNames names);

  /// What a material is made of. `translucent` says that colors of vertices are.
  struct Look {
    Color color;
    Finish finish = {};
    bool translucent = false;

    auto operator<=>(const Look&) const = default;
  };

  /// A compressed tile, given its exact decoded bounds. A tile with vertex colors takes white as its material color.
  void add_tile(const EncodedTile& tile, const FloatBox& bounds, const Look& look);

  /// The same without compression: floats, colors in 16 bits, indices as small as they can be.
  void add_plain_tile(const Tile& tile, const Look& look);

  /// Polylines: one LINE_STRIP each; beyond 64 of them one LINES primitive, which viewers draw in one call.
  /// Returns their bounds. Stopped early: not all of them.
  FloatBox add_runs(const FloatRuns& runs, const Color& color, const Cancel& cancel);

  /// One POINTS primitive; `points` is not empty. Returns their bounds. Stopped early: not those of all.
  FloatBox add_points(const FloatPoints& points, const Color& color, const Cancel& cancel);

  /// Bytes of binary data so far.
  std::size_t binary_size() const { return binary_.size(); }

  /// The finished file; empty when it would be larger than GLB can address.
  std::string write(GltfContainer container);

 private:
  /// Objects of one kind as JSON text.
  struct ObjectList {
    std::string text;
    std::size_t count = 0;

    std::size_t add(const std::string& object);
  };
  struct Group {
    std::size_t node;
    Json object;
    std::vector<std::size_t> children;
  };

  std::size_t add_bytes(const void* data, std::size_t size, int target, std::size_t stride = 0);
  std::size_t add_material(Look look);
  std::string free_material_name();
  template <class Rows>
  std::size_t add_rows(const Rows& rows, Json accessor, int target);
  std::size_t add_indices(const Tile& tile);
  std::size_t add_positions(std::size_t view, std::size_t offset, std::size_t count, const FloatBox& box);
  void add_primitive(const Json& primitive);
  void finish_mesh();
  std::string buffer_object(GltfContainer container) const;

  Json asset_;
  std::string binary_;
  ObjectList accessors_, views_, materials_, meshes_;
  std::vector<std::string> nodes_;  ///< the root last of all, but first in the file
  std::vector<std::size_t> below_root_;
  std::optional<Group> group_;
  PartNames part_;
  std::string primitives_;  ///< of the part
  bool compressed_ = false;
  std::map<std::pair<std::string, Look>, std::size_t> material_of_;
  std::set<std::string> material_names_;
};

}  // namespace dini
