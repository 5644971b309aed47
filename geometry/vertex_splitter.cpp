#include "geometry/vertex_splitter.h"

namespace dini {

namespace {

template <class Value>
void append(std::vector<Value>& values, const std::vector<std::uint32_t>& sources) {
  if (values.empty()) return;
  values.reserve(values.size() + sources.size());
  for (const std::uint32_t source : sources) values.push_back(values[source]);
}

}  // namespace

std::uint32_t VertexSplitter::at(std::uint32_t vertex, const Value& value) {
  const auto [number, fresh] = known_.number_of({vertex, value[0], value[1], value[2], value[3]});
  if (!fresh) return targets_[number];
  if (has_value_[vertex - first_]) {
    targets_.push_back(static_cast<std::uint32_t>(vertices_ + sources_.size()));
    sources_.push_back(vertex);
  } else {
    has_value_[vertex - first_] = true;
    targets_.push_back(vertex);
  }
  return targets_.back();
}

void VertexSplitter::append_copies(RawMesh& raw) const {
  append(raw.positions, sources_);
  append(raw.normals, sources_);
  append(raw.uvs, sources_);
  append(raw.colors, sources_);
}

}  // namespace dini
