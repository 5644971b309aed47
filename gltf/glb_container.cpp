#include "gltf/glb_container.h"

#include <cstdint>
#include <limits>

namespace dini {
namespace {

constexpr std::uint32_t glb_magic = 0x46546C67;     // "glTF"
constexpr std::uint32_t json_chunk = 0x4E4F534A;    // "JSON"
constexpr std::uint32_t binary_chunk = 0x004E4942;  // "BIN"
constexpr std::size_t header_size = 12;
constexpr std::size_t chunk_header_size = 8;

std::uint32_t read_word(std::string_view text, std::size_t at) {
  std::uint32_t word = 0;
  for (std::size_t i = 4; i-- > 0;) word = word << 8 | static_cast<unsigned char>(text[at + i]);
  return word;
}

void append_word(std::string& text, std::size_t value) {
  for (std::size_t i = 0; i < 4; ++i) text.push_back(static_cast<char>(value >> 8 * i & 0xFF));
}

struct Chunk {
  std::uint32_t type = 0;
  std::string_view bytes;
};

// Takes the chunk at the front of `rest`; nothing if it is cut short.
std::optional<Chunk> take_chunk(std::string_view& rest) {
  if (rest.size() < chunk_header_size) return std::nullopt;
  const std::size_t size = read_word(rest, 0);
  if (rest.size() - chunk_header_size < size) return std::nullopt;
  const Chunk chunk = {read_word(rest, 4), rest.substr(chunk_header_size, size)};
  rest.remove_prefix(chunk_header_size + size);
  return chunk;
}

}  // namespace

std::optional<GlbChunks> split_glb(std::string_view glb) {
  if (glb.size() < header_size || read_word(glb, 0) != glb_magic || read_word(glb, 4) != 2) return std::nullopt;
  const std::size_t size = read_word(glb, 8);
  if (size < header_size || size > glb.size()) return std::nullopt;
  std::string_view rest = glb.substr(header_size, size - header_size);
  const auto json = take_chunk(rest);
  if (!json || json->type != json_chunk) return std::nullopt;
  GlbChunks chunks = {json->bytes, {}, glb.size() - size};
  // Fewer bytes than a chunk has are padding that was counted wrongly.
  if (rest.size() < chunk_header_size) return chunks;
  const auto second = take_chunk(rest);
  if (!second) return std::nullopt;
  if (second->type == binary_chunk) chunks.binary = second->bytes;
  return chunks;
}

std::string join_glb(std::string_view json, std::string_view binary) {
  const std::size_t padded = (json.size() + 3) / 4 * 4;
  const std::size_t size =
      header_size + chunk_header_size + padded + (binary.empty() ? 0 : chunk_header_size + binary.size());
  if (size > std::numeric_limits<std::uint32_t>::max()) return {};
  std::string result;
  result.reserve(size);
  append_word(result, glb_magic);
  append_word(result, 2);
  append_word(result, size);
  append_word(result, padded);
  append_word(result, json_chunk);
  result += json;
  result.append(padded - json.size(), ' ');
  if (binary.empty()) return result;
  append_word(result, binary.size());
  append_word(result, binary_chunk);
  result += binary;
  return result;
}

}  // namespace dini
