#include "geometry/vertex_splitter.h"

#include "geometry/hash_seed.h"

namespace dini {

namespace {

template <class Value>
void append(std::vector<Value>& values, const std::vector<std::uint32_t>& sources) {
  if (values.empty()) return;
  values.reserve(values.size() + sources.size());
  for (const std::uint32_t source : sources) values.push_back(values[source]);
}

}  // namespace

std::size_t VertexSplitter::KeyHash::operator()(const Key& key) const {
  std::uint64_t bits = hash_with(hash_seed(), key.vertex);
  for (const std::uint32_t part : key.value) bits = hash_with(bits, part);
  return static_cast<std::size_t>(bits);
}

std::uint32_t VertexSplitter::at(std::uint32_t vertex, const Value& value) {
  const auto [found, fresh] = known_.try_emplace(Key{vertex, value}, vertex);
  if (!fresh) return found->second;
  if (!has_value_[vertex - first_]) {
    has_value_[vertex - first_] = true;
    return vertex;
  }
  found->second = static_cast<std::uint32_t>(vertices_ + sources_.size());
  sources_.push_back(vertex);
  return found->second;
}

void VertexSplitter::append_copies(RawMesh& raw) const {
  append(raw.positions, sources_);
  append(raw.normals, sources_);
  append(raw.uvs, sources_);
  append(raw.colors, sources_);
}

}  // namespace dini
