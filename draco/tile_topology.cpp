#include "draco/tile_topology.h"

#include "draco/bit_writer.h"
#include "draco/symbol_coding.h"
#include "draco/valence_contexts.h"

namespace dini {
namespace {

enum class TraversalKind : std::uint8_t { standard = 0, valence = 2 };

// Valence contexts carry a table each, that only larger meshes pay back.
constexpr std::size_t smallest_valence_mesh = 1000;

void write_splits(const Edgebreaker& walk, ByteWriter& bytes) {
  bytes.varint(static_cast<std::uint32_t>(walk.splits.size()));
  std::uint32_t last = 0;
  BitWriter edges;
  for (const SplitEvent& event : walk.splits) {
    bytes.varint(event.source - last);
    bytes.varint(event.source - event.split);
    edges.bits(event.right ? 1 : 0, 1);
    last = event.source;
  }
  bytes.text(edges.take());
}

// Symbols in the order of decoding: one bit for `c`, three for the others.
void write_plain_symbols(const Edgebreaker& walk, ByteWriter& bytes) {
  BitWriter bits;
  for (std::size_t i = walk.symbols.size(); i-- > 0;) {
    const Symbol symbol = walk.symbols[i];
    if (symbol == Symbol::c) {
      bits.bits(0, 1);
    } else {
      bits.bits(2 * static_cast<std::uint32_t>(symbol) - 1, 3);
    }
  }
  bytes.block(bits.take());
}

void write_contexts(const CornerTable& table, const Edgebreaker& walk, ByteWriter& bytes) {
  for (const auto& context : valence_contexts(table, walk)) {
    bytes.varint(static_cast<std::uint32_t>(context.size()));
    std::vector<std::uint32_t> values(context.size());
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = static_cast<std::uint32_t>(context[i]);
    write_symbols({values.data(), values.size(), 1, 1}, usual_table_effort, bytes);
  }
}

std::vector<char> connectivity(const CornerTable& table, const Edgebreaker& walk) {
  const bool plain = table.triangles() < smallest_valence_mesh;
  ByteWriter bytes;
  bytes.byte(static_cast<std::uint8_t>(plain ? TraversalKind::standard : TraversalKind::valence));
  bytes.varint(static_cast<std::uint32_t>(table.vertices()));
  bytes.varint(static_cast<std::uint32_t>(table.triangles()));
  bytes.byte(0);  // attributes with a connectivity of their own
  bytes.varint(static_cast<std::uint32_t>(walk.symbols.size()));
  bytes.varint(walk.split_symbols);
  write_splits(walk, bytes);
  if (plain) write_plain_symbols(walk, bytes);
  write_bits(walk.closed, bytes);
  if (!plain) write_contexts(table, walk, bytes);
  return bytes.take();
}

}  // namespace

std::size_t TileTopology::size() const {
  return sizeof *this + triangles.capacity() * sizeof triangles[0] + connectivity.capacity() +
         order.vertices.capacity() * sizeof order.vertices[0] +
         order.parallelograms.capacity() * sizeof order.parallelograms[0];
}

std::shared_ptr<const TileTopology> tile_topology(Triangles triangles, std::size_t vertices) {
  const std::optional<CornerTable> table = CornerTable::of(triangles, vertices);
  if (!table) return nullptr;
  const Edgebreaker walk = edgebreaker(*table);
  auto result = std::make_shared<TileTopology>();
  result->triangles.assign(triangles.begin(), triangles.end());
  result->connectivity = connectivity(*table, walk);
  result->order = vertex_order(*table, walk);
  return result;
}

}  // namespace dini
