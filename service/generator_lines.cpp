#include "service/generator_lines.h"

#include <array>
#include <cmath>

#include "algebra/kernels.h"

namespace dini {

namespace {

Vector place_of(const Generator& generator) { return to_vector(kernels::warp_source(generator).position); }

void draw_real_pair(const Generator& pair, ControlLines& lines) {
  // B.B = r^2 |no_e|^2 with half the distance r of the poles.
  const Vector place = place_of(pair);
  const double square = pair.no_ni * pair.no_ni - squared_length(pair.e_e) - 2 * dot(pair.no_e, pair.e_ni);
  const double radius = std::sqrt(std::max(square, 0.0)) / length(pair.no_e);
  const Vector normal = normalized(pair.no_e);
  lines.segment(place - radius * normal, place + radius * normal);
  lines.cross_mark(place - radius * normal);
  lines.cross_mark(place + radius * normal);
  CircleCoordinates equator;
  equator.center = to_point(place);
  equator.normal = normal;
  equator.radius = radius;
  lines.round(equator);
}

void draw_imaginary_pair(const Generator& pair, ControlLines& lines) {
  if (const auto circle = coordinates(Circle{pair})) lines.round(*circle, true);
}

void draw_flat_point(const Generator& generator, ControlLines& lines) {
  const Vector place = place_of(generator);
  const double half = 0.3 * lines.frame().size;
  for (const double side : {half, -half}) {
    for (const Vector& axis : {Vector{side, 0, 0}, Vector{0, side, 0}, Vector{0, 0, side}}) {
      lines.arrow(place + 0.3 * axis, 0.7 * axis);
    }
  }
}

void draw_rotation(const Generator& generator, ControlLines& lines) {
  const Vector axis = normalized(generator.e_e);
  const Vector start = place_of(generator);
  const PreviewFrame& frame = lines.frame();
  const Vector place = start + dot(frame.center - start, axis) * axis;
  lines.segment(place - (0.5 * frame.size) * axis, place + (0.5 * frame.size) * axis);
  lines.turn_mark(place, axis, 0.15 * frame.size);
}

}  // namespace

std::string_view word_for(GeneratorKind kind) {
  constexpr std::array<std::string_view, 8> words = {"zero",       "null",      "real",     "imaginary",
                                                     "flat_point", "direction", "rotation", "general"};
  return words[static_cast<std::size_t>(kind)];
}

void draw(const Generator& generator, GeneratorKind kind, ControlLines& lines) {
  constexpr double part_noise = 1e-6;  // parts are differences of the whole
  switch (kind) {
    case GeneratorKind::zero:
      return;
    case GeneratorKind::null_pair:
      return lines.arrow(place_of(generator), generator.no_e);
    case GeneratorKind::real_pair:
      return draw_real_pair(generator, lines);
    case GeneratorKind::imaginary_pair:
      return draw_imaginary_pair(generator, lines);
    case GeneratorKind::flat_point:
      return draw_flat_point(generator, lines);
    case GeneratorKind::direction:
      return lines.arrow({}, generator.e_ni);
    case GeneratorKind::rotation:
      return draw_rotation(generator, lines);
    case GeneratorKind::general:
      break;
  }
  for (const Generator& part : commuting_parts(generator)) {
    const GeneratorKind part_kind = kind_of(part, part_noise);
    if (part_kind != GeneratorKind::general) draw(part, part_kind, lines);
  }
}

}  // namespace dini
