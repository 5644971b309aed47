#include "golden/model_facts.h"

#include <algorithm>

namespace dini {
namespace {

void measure_bounds(const Shape& shape, ModelFacts& facts) {
  if (shape.points.empty()) return;
  facts.low = facts.high = shape.points.front();
  for (const Vector& point : shape.points) {
    facts.low = {std::min(facts.low.x, point.x), std::min(facts.low.y, point.y), std::min(facts.low.z, point.z)};
    facts.high = {std::max(facts.high.x, point.x), std::max(facts.high.y, point.y), std::max(facts.high.z, point.z)};
  }
}

double half_of_edges(const Shape& shape) {
  double sum = 0;
  for (std::size_t i = 0; i < shape.triangles; ++i) {
    const auto& [a, b, c] = shape.pieces[i];
    sum += length(shape.points[a] - shape.points[b]) + length(shape.points[b] - shape.points[c]) +
           length(shape.points[c] - shape.points[a]);
  }
  return sum / 2;
}

}  // namespace

std::optional<Model> model_of(const File& file) {
  std::optional<Model> model = model_of_bytes(*file.bytes);
  if (model) model->facts.position_error = file.position_error;
  return model;
}

Model model_of_shape(Shape shape, std::string_view bytes, double position_error) {
  ModelFacts facts{.sha256 = to_hex(sha256(bytes)),
                   .position_error = position_error,
                   .triangles = shape.triangles,
                   .segments = shape.segments,
                   .points = shape.pieces.size() - shape.triangles - shape.segments,
                   .low = {},
                   .high = {},
                   .area = shape.measures.area,
                   .volume = shape.measures.volume,
                   .euler = shape.measures.euler,
                   .closed = shape.measures.closed,
                   .edges = half_of_edges(shape)};
  measure_bounds(shape, facts);
  facts.samples = samples_of(shape);
  facts.spacing = spacing_of(shape, facts.samples);
  return Model{std::move(facts), std::move(shape)};
}

std::optional<Model> model_of_bytes(std::string_view bytes) {
  std::optional<Shape> shape = read_shape(bytes);
  if (!shape) return std::nullopt;
  Model model = model_of_shape(*std::move(shape), bytes, 0);
  const Vector size = model.facts.high - model.facts.low;
  constexpr double steps = 1 << 14, half_of_diagonal = 0.8660254037844386;
  model.facts.position_error = half_of_diagonal * std::max({size.x, size.y, size.z}) / steps;
  return model;
}

}  // namespace dini
