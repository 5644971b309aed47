#include "service/preview_frame.h"

#include <algorithm>
#include <cmath>

#include "algebra/extract.h"
#include "algebra/generator_kind.h"
#include "algebra/kernels.h"

namespace dini {

namespace {

/// Something with a place: a ball that holds it.
struct Ball {
  Vector center;
  double radius = 0;
};

constexpr double far_off = 10;  ///< times the median distance
constexpr double sizes_seen = 4;

std::optional<Ball> ball_of(const Point& point) { return Ball{to_vector(point), 0}; }
std::optional<Ball> ball_of(const Vector& vector) { return Ball{{}, length(vector)}; }
std::optional<Ball> ball_of(double) { return std::nullopt; }
std::optional<Ball> ball_of(const SharedFile&) { return std::nullopt; }

std::optional<Ball> ball_of(const SharedField& field) {
  if (!field->reach()) return std::nullopt;
  return Ball{field->reach()->ball.center, field->reach()->ball.radius};
}

std::optional<Ball> ball_of(const Circle& circle) {
  const auto found = coordinates(circle);
  if (!found) return std::nullopt;
  if (found->line) return Ball{to_vector(found->point), 0};
  return Ball{to_vector(found->center), found->radius};
}

std::optional<Ball> ball_of(const Sphere& sphere) {
  const auto found = coordinates(sphere);
  if (!found) return std::nullopt;
  if (found->plane) return Ball{found->distance * found->normal, 0};
  return Ball{to_vector(found->center), found->radius};
}

std::optional<Ball> ball_of(const Generator& generator) {
  switch (kind_of(generator)) {
    case GeneratorKind::zero:
    case GeneratorKind::direction:
      return std::nullopt;
    case GeneratorKind::null_pair:
      return Ball{to_vector(kernels::warp_source(generator).position), length(generator.no_e)};
    case GeneratorKind::imaginary_pair:
      return ball_of(Circle{generator});
    default:
      return Ball{to_vector(kernels::warp_source(generator).position), 0};
  }
}

std::optional<Ball> ball_of(const SharedMesh& mesh) {
  const Column<Point>& points = mesh->positions;
  if (points.empty()) return std::nullopt;
  Vector least = to_vector(points[0]), most = least;
  for (std::size_t i = 1; i < points.size(); ++i) {
    const Point p = points[i];
    least = {std::min(least.x, p.x), std::min(least.y, p.y), std::min(least.z, p.z)};
    most = {std::max(most.x, p.x), std::max(most.y, p.y), std::max(most.z, p.z)};
  }
  return Ball{(least + most) / 2, length(most - least) / 2};
}

double median(std::vector<double> numbers) {
  const auto middle = numbers.begin() + static_cast<std::ptrdiff_t>(numbers.size() / 2);
  std::nth_element(numbers.begin(), middle, numbers.end());
  return *middle;
}

Vector median_center(const std::vector<Ball>& balls) {
  std::vector<double> x, y, z;
  x.reserve(balls.size());
  y.reserve(balls.size());
  z.reserve(balls.size());
  for (const Ball& ball : balls) {
    x.push_back(ball.center.x);
    y.push_back(ball.center.y);
    z.push_back(ball.center.z);
  }
  return {median(std::move(x)), median(std::move(y)), median(std::move(z))};
}

}  // namespace

PreviewFrame frame_of(const std::vector<Value>& values, std::size_t elements, const Cancel& cancel) {
  std::vector<Ball> balls;
  for (const Value& value : values) {
    std::visit(
        [&](const auto& column) {
          for (const std::size_t i : spread_indices(column->size(), elements)) {
            if (cancel.stopped()) return;
            const std::optional<Ball> ball = ball_of((*column)[i]);
            if (ball && is_finite(ball->center) && std::isfinite(ball->radius)) balls.push_back(*ball);
          }
        },
        value.column);
  }
  PreviewFrame frame;
  if (balls.empty()) return frame;
  frame.center = median_center(balls);
  std::vector<double> distances;
  distances.reserve(balls.size());
  for (const Ball& ball : balls) distances.push_back(length(ball.center - frame.center) + ball.radius);
  const double usual = median(distances);
  double size = 0;
  for (const double distance : distances) {
    if (usual == 0 || distance <= far_off * usual) size = std::max(size, distance);
  }
  if (size > 0) frame.size = size;
  frame.reach = length(frame.center) + sizes_seen * frame.size;
  return frame;
}

std::vector<std::size_t> spread_indices(std::size_t count, std::size_t most) {
  std::vector<std::size_t> indices;
  const std::size_t kept = std::min(count, most);
  indices.reserve(kept);
  for (std::size_t i = 0; i < kept; ++i) {
    indices.push_back(kept < 2 ? 0 : kept == count ? i : i * (count - 1) / (kept - 1));
  }
  return indices;
}

}  // namespace dini
