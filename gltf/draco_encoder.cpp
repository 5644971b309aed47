#include "gltf/draco_encoder.h"

#include <algorithm>
#include <draco/compression/expert_encode.h>
#include <draco/core/encoder_buffer.h>
#include <draco/mesh/mesh.h>
#include <exception>
#include <utility>

namespace dini {
namespace {

constexpr int sequential_speed = 10;

// Valence traversal carries a header that only larger meshes pay back.
constexpr std::size_t smallest_valence_mesh = 1000;

template <class Value, std::size_t width>
int add_attribute(draco::Mesh& mesh, draco::GeometryAttribute::Type type, draco::DataType data_type, bool normalized,
                  const std::vector<std::array<Value, width>>& values,
                  const std::vector<std::array<Value, width>>& unused_values = {}) {
  if (values.empty()) return -1;
  constexpr std::size_t row = sizeof(values[0]);
  draco::GeometryAttribute description;
  description.Init(type, nullptr, width, data_type, normalized, row, 0);
  const int id = mesh.AddAttribute(description, true, static_cast<std::uint32_t>(values.size() + unused_values.size()));
  draco::DataBuffer* buffer = mesh.attribute(id)->buffer();
  buffer->Write(0, values.data(), values.size() * row);
  const auto end = static_cast<std::int64_t>(values.size() * row);
  if (!unused_values.empty()) buffer->Write(end, unused_values.data(), unused_values.size() * row);
  return id;
}

// How libdraco is told the grid: it quantizes over the box of all values of an attribute, used by a vertex or not, so
// the corners of the grid are added as unused values. Its option for explicit quantization keeps six decimals of origin
// and range only (and crashes for small ranges).
template <std::size_t width>
std::vector<std::array<float, width>> grid_corners(const QuantizationGrid& grid) {
  std::vector<std::array<float, width>> corners(2);
  std::copy_n(grid.box().minimum.begin(), width, corners[0].begin());
  std::copy_n(grid.box().maximum.begin(), width, corners[1].begin());
  return corners;
}

// Vertices are shared by index already, so no deduplication is needed: every attribute maps vertex i to value i.
EncodeResult<EncodedTile> encode_unguarded(const Tile& tile, const TileGrids& grids, const EncodeOptions& options) {
  draco::Mesh mesh;
  mesh.set_num_points(static_cast<std::uint32_t>(tile.positions.size()));
  mesh.SetNumFaces(tile.triangles.size());
  for (std::size_t i = 0; i < tile.triangles.size(); ++i) {
    const auto& [a, b, c] = tile.triangles[i];
    mesh.SetFace(draco::FaceIndex(static_cast<std::uint32_t>(i)),
                 {draco::PointIndex(a), draco::PointIndex(b), draco::PointIndex(c)});
  }
  EncodedTile result;
  using Attribute = draco::GeometryAttribute;
  result.position_id = add_attribute(mesh, Attribute::POSITION, draco::DT_FLOAT32, false, tile.positions,
                                     grid_corners<3>(grids.positions));
  result.normal_id = add_attribute(mesh, Attribute::NORMAL, draco::DT_FLOAT32, false, tile.normals);
  result.uv_id =
      add_attribute(mesh, Attribute::TEX_COORD, draco::DT_FLOAT32, false, tile.uvs, grid_corners<2>(grids.uvs));
  result.color_id = add_attribute(mesh, Attribute::COLOR, draco::DT_UINT16, true, tile.colors);

  draco::ExpertEncoder encoder(mesh);
  encoder.SetSpeedOptions(options.speed, options.speed);
  encoder.SetTrackEncodedProperties(true);
  if (options.speed < sequential_speed) {
    encoder.SetEncodingMethod(draco::MESH_EDGEBREAKER_ENCODING);
    encoder.options().SetGlobalInt("edgebreaker_method", tile.triangles.size() < smallest_valence_mesh
                                                             ? draco::MESH_EDGEBREAKER_STANDARD_ENCODING
                                                             : draco::MESH_EDGEBREAKER_VALENCE_ENCODING);
  } else {
    encoder.SetEncodingMethod(draco::MESH_SEQUENTIAL_ENCODING);
  }
  encoder.SetAttributeQuantization(result.position_id, grids.positions.bits());
  if (result.normal_id >= 0) encoder.SetAttributeQuantization(result.normal_id, options.normal_bits);
  if (result.uv_id >= 0) encoder.SetAttributeQuantization(result.uv_id, grids.uvs.bits());

  draco::EncoderBuffer buffer;
  const draco::Status status = encoder.EncodeToBuffer(&buffer);
  if (!status.ok()) return EncodeError{EncodeError::Code::encoder_failed, status.error_msg_string(), ""};
  result.bytes = std::move(*buffer.buffer());
  result.vertices = encoder.num_encoded_points();
  result.triangles = encoder.num_encoded_faces();
  return result;
}

}  // namespace

EncodeResult<EncodedTile> DracoEncoder::encode(const Tile& tile, const TileGrids& grids,
                                               const EncodeOptions& options) const {
  if (tile.triangles.empty()) return EncodeError{EncodeError::Code::empty, "The mesh has no triangles.", ""};
  try {
    return encode_unguarded(tile, grids, options);
  } catch (const std::bad_alloc&) {
    throw;  // no fault of the scene's
  } catch (const std::exception& error) {
    return EncodeError{EncodeError::Code::encoder_failed, error.what(), ""};
  }
}

}  // namespace dini
