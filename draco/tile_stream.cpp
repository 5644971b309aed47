#include "draco/tile_stream.h"

#include <algorithm>

#include "draco/attribute_symbols.h"

namespace dini {
namespace {

enum class AttributeKind : std::uint8_t { position = 0, normal = 1, color = 2, uv = 3 };
enum class NumberKind : std::uint8_t { uint16 = 4, float32 = 9 };
enum class Decoder : std::uint8_t { integers = 1, quantized = 2, normals = 3 };

/// One attribute on its way into the stream.
struct Attribute {
  AttributeKind kind;
  NumberKind numbers;
  int components;
  Decoder decoder;
  AttributeSymbols symbols;
  StreamGrid grid;  ///< of normals only the bits
};

/// The numbers of all vertices, for as long as they are predicted.
class Rows {
 public:
  explicit Rows(std::size_t count) : rows_(std::make_unique_for_overwrite<kernels::Row[]>(count)), count_(count) {}
  kernels::Row* get() { return rows_.get(); }
  operator std::span<const kernels::Row>() const { return {rows_.get(), count_}; }

 private:
  std::unique_ptr<kernels::Row[]> rows_;
  std::size_t count_;
};

template <std::size_t columns>
Rows on_grid(std::span<const std::array<float, columns>> values, const StreamGrid& grid) {
  kernels::Steps steps = {{}, static_cast<float>((1u << grid.bits) - 1u) / grid.range};
  std::copy_n(grid.origin.begin(), columns, steps.origin.begin());
  Rows rows(values.size());
  kernels::quantize(values, steps, rows.get());
  return rows;
}

Rows whole_numbers(std::span<const std::array<std::uint16_t, 4>> values) {
  Rows rows(values.size());
  for (std::size_t i = 0; i < values.size(); ++i) std::copy(values[i].begin(), values[i].end(), rows.get()[i].begin());
  return rows;
}

std::vector<Attribute> attributes_of(const StreamAttributes& given, const VertexOrder& order) {
  std::vector<Attribute> result;
  result.push_back({AttributeKind::position, NumberKind::float32, 3, Decoder::quantized,
                    parallelogram_symbols(on_grid(given.positions, given.position_grid), 3, order),
                    given.position_grid});
  if (!given.normals.empty()) {
    result.push_back({AttributeKind::normal,
                      NumberKind::float32,
                      3,
                      Decoder::normals,
                      octahedron_symbols(given.normals, given.normal_bits, order),
                      {{}, 1, given.normal_bits}});
  }
  if (!given.uvs.empty()) {
    result.push_back({AttributeKind::uv, NumberKind::float32, 2, Decoder::quantized,
                      parallelogram_symbols(on_grid(given.uvs, given.uv_grid), 2, order), given.uv_grid});
  }
  if (!given.colors.empty()) {
    result.push_back({AttributeKind::color,
                      NumberKind::uint16,
                      4,
                      Decoder::integers,
                      parallelogram_symbols(whole_numbers(given.colors), 4, order),
                      {}});
  }
  return result;
}

void write_descriptions(const std::vector<Attribute>& attributes, ByteWriter& bytes) {
  constexpr std::uint8_t no_own_connectivity = 0xff;
  constexpr std::uint8_t one_value_per_vertex = 0;
  constexpr std::uint8_t depth_first = 0;
  bytes.byte(1);  // group of attributes
  bytes.byte(no_own_connectivity);
  bytes.byte(one_value_per_vertex);
  bytes.byte(depth_first);
  bytes.varint(static_cast<std::uint32_t>(attributes.size()));
  for (std::size_t i = 0; i < attributes.size(); ++i) {
    bytes.byte(static_cast<std::uint8_t>(attributes[i].kind));
    bytes.byte(static_cast<std::uint8_t>(attributes[i].numbers));
    bytes.byte(static_cast<std::uint8_t>(attributes[i].components));
    bytes.byte(attributes[i].numbers == NumberKind::uint16 ? 1 : 0);  // whether 65535 stands for 1
    bytes.varint(static_cast<std::uint32_t>(i));
  }
  for (const Attribute& attribute : attributes) bytes.byte(static_cast<std::uint8_t>(attribute.decoder));
}

void write_values(const AttributeSymbols& symbols, const SymbolCoding& coding, const std::string& coded,
                  ByteWriter& bytes) {
  bytes.byte(static_cast<std::uint8_t>(symbols.prediction));
  bytes.byte(static_cast<std::uint8_t>(symbols.transform));
  bytes.byte(1);  // compressed
  coding.write(coded, bytes);
  for (const std::int32_t number : symbols.range) bytes.number(number);
}

void write_all_values(const std::vector<Attribute>& attributes, int effort, ByteWriter& bytes) {
  for (std::size_t i = 0; i < attributes.size(); i += 2) {
    const AttributeSymbols& first = attributes[i].symbols;
    const SymbolCoding first_coding(first.rows(), effort);
    if (i + 1 == attributes.size()) return write_values(first, first_coding, rans_bytes(first_coding.input()), bytes);
    const AttributeSymbols& second = attributes[i + 1].symbols;
    const SymbolCoding second_coding(second.rows(), effort);
    const TwoTexts coded = rans_bytes(first_coding.input(), second_coding.input());
    write_values(first, first_coding, coded.first, bytes);
    write_values(second, second_coding, coded.second, bytes);
  }
}

void write_grids(const std::vector<Attribute>& attributes, ByteWriter& bytes) {
  for (const Attribute& attribute : attributes) {
    if (attribute.decoder == Decoder::integers) continue;
    if (attribute.decoder == Decoder::quantized) {
      for (int axis = 0; axis < attribute.components; ++axis) {
        bytes.number(attribute.grid.origin[static_cast<std::size_t>(axis)]);
      }
      bytes.number(attribute.grid.range);
    }
    bytes.byte(static_cast<std::uint8_t>(attribute.grid.bits));
  }
}

}  // namespace

std::vector<char> tile_stream(const TileTopology& topology, const StreamAttributes& attributes, int effort) {
  using namespace std::string_view_literals;
  ByteWriter bytes;
  bytes.text("DRACO\x02\x02\x01\x01\x00\x00"sv);  // version 2.2, triangles, edgebreaker, no metadata
  bytes.text({topology.connectivity.data(), topology.connectivity.size()});
  const std::vector<Attribute> prepared = attributes_of(attributes, topology.order);
  write_descriptions(prepared, bytes);
  write_all_values(prepared, effort, bytes);
  write_grids(prepared, bytes);
  return bytes.take();
}

}  // namespace dini
