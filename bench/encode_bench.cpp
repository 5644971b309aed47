// Encoding one million triangles (a wavy height field of 708 x 708 vertices with normals) as GLB.
//   encode_bench [Google Benchmark options]
//   encode_bench --write-ply FILE     writes the same mesh for other encoders; see scripts/bench-encode

#include <benchmark/benchmark.h>
#include <cstdint>
#include <fstream>
#include <string>
#include <tbb/global_control.h>
#include <tbb/task_arena.h>
#include <utility>
#include <vector>

#include "gltf/draco_encoder.h"
#include "gltf/glb_writer.h"
#include "gltf/tile_encoder.h"
#include "gltf/tiles.h"
#include "tests/gltf/shapes.h"

namespace dini {
namespace {

constexpr std::size_t side = 708;
constexpr double waves = 2.6;

Mesh million_triangles(std::size_t tile_side) {
  Mesh mesh = shapes::wavy_field(side, side, waves);
  mesh.uvs.clear();
  if (tile_side > 0) shapes::cut_into_square_tiles(mesh, side - 1, side - 1, tile_side);
  return mesh;
}

// Arguments: threads, quads along the side of the tiles that the mesh proposes (0: none), Draco speed.
void encode_million(benchmark::State& state) {
  const auto threads = static_cast<int>(state.range(0));
  const Scene scene = shapes::scene_of(million_triangles(static_cast<std::size_t>(state.range(1))));
  EncodeOptions options;
  options.speed = static_cast<int>(state.range(2));
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(threads));
  tbb::task_arena arena(threads);
  for (auto _ : state) {
    const auto result = arena.execute([&] { return encode_scene(scene, options, Cancel()); });
    if (!result) return state.SkipWithError("encoding failed");
    state.counters["bytes"] = static_cast<double>(result->bytes);
  }
}

BENCHMARK(encode_million)
    ->ArgNames({"threads", "tile", "speed"})
    ->ArgsProduct({{1, 2}, {0, 128}, {7}})
    ->ArgsProduct({{2}, {128}, {3, 9, 10}})
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);

// One thread, tiles of 128 x 128 quads that are built already: by libdraco (0), by the own writer for triangles that it
// meets for the first time (1), and for known ones (2).
void encode_tiles(benchmark::State& state) {
  const Mesh mesh = million_triangles(128);
  const EncodeOptions usual;
  std::vector<Tile> tiles;
  FloatBox box;
  std::size_t begin = 0;
  for (const std::size_t end : plan_tiles(mesh, tile_sizes(usual))) {
    tiles.push_back(*build_tile(mesh, std::exchange(begin, end), end, usual, Cancel()));
    box.include(tiles.back().position_box);
  }
  const TileGrids grids = {QuantizationGrid(box, usual.position_bits), {}};
  TopologyCache topologies(std::size_t{1} << 28);
  EncodeOptions options;
  if (state.range(0) == 2) options.topologies = &topologies;
  const DracoEncoder libdraco;
  const TileEncoder own;
  const MeshEncoder& encoder = state.range(0) == 0 ? static_cast<const MeshEncoder&>(libdraco) : own;
  for (auto _ : state) {
    std::size_t bytes = 0;
    for (const Tile& tile : tiles) bytes += encoder.encode(tile, grids, options)->bytes.size();
    state.counters["bytes"] = static_cast<double>(bytes);
  }
}
BENCHMARK(encode_tiles)->ArgName("writer")->Arg(0)->Arg(1)->Arg(2)->Unit(benchmark::kMillisecond);

template <class Value>
void put(std::ofstream& file, Value value) {
  file.write(reinterpret_cast<const char*>(&value), sizeof(value));
}

int write_ply(const char* name) {
  const Mesh mesh = million_triangles(0);
  std::ofstream file(name, std::ios::binary);
  file << "ply\nformat binary_little_endian 1.0\nelement vertex " << mesh.positions.size();
  for (const char* property : {"x", "y", "z", "nx", "ny", "nz"}) file << "\nproperty float " << property;
  file << "\nelement face " << mesh.triangles.size() << "\nproperty list uchar int vertex_indices\nend_header\n";
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    const Point p = mesh.positions[i];
    const Vector n = mesh.normals[i];
    for (const double value : {p.x, p.y, p.z, n.x, n.y, n.z}) put(file, static_cast<float>(value));
  }
  for (const auto& triangle : mesh.triangles) {
    put(file, std::uint8_t{3});
    for (const std::uint32_t index : triangle) put(file, static_cast<std::int32_t>(index));
  }
  return file.good() ? 0 : 1;
}

}  // namespace
}  // namespace dini

int main(int count, char** arguments) {
  if (count == 3 && std::string(arguments[1]) == "--write-ply") return dini::write_ply(arguments[2]);
  benchmark::Initialize(&count, arguments);
  if (benchmark::ReportUnrecognizedArguments(count, arguments)) return 1;
  benchmark::RunSpecifiedBenchmarks();
}
