#include "geometry/implicit_vertex.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace dini {

namespace {

/// Normals this near to their mean, as cosine, belong to a smooth piece.
constexpr double smooth = 0.85;
/// Normals this near to one another, as cosine, are of one side of an edge.
constexpr double one_side = 0.7;
/// Directions along which the tangent planes say less than this share of what the best one says are left as they are.
constexpr double least_share = 0.05;
/// How near to the border of its cell a vertex may come, in half cells.
constexpr double within_cell = 0.999;

using Symmetric = std::array<std::array<double, 3>, 3>;

/// Turns a symmetric matrix until it is diagonal (Jacobi); the columns of `turned` are its eigenvectors.
void diagonalize(Symmetric& matrix, Symmetric& turned) {
  turned = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  for (int sweep = 0; sweep < 8; ++sweep) {
    for (std::size_t p = 0; p < 2; ++p) {
      for (std::size_t q = p + 1; q < 3; ++q) {
        if (matrix[p][q] == 0) continue;
        const double theta = (matrix[q][q] - matrix[p][p]) / (2 * matrix[p][q]);
        const double t = (theta < 0 ? -1 : 1) / (std::abs(theta) + std::sqrt(theta * theta + 1));
        const double c = 1 / std::sqrt(t * t + 1), s = t * c;
        for (std::size_t k = 0; k < 3; ++k) {
          const double a = matrix[k][p], b = matrix[k][q];
          matrix[k][p] = c * a - s * b;
          matrix[k][q] = s * a + c * b;
        }
        for (std::size_t k = 0; k < 3; ++k) {
          const double a = matrix[p][k], b = matrix[q][k];
          matrix[p][k] = c * a - s * b;
          matrix[q][k] = s * a + c * b;
        }
        for (std::size_t k = 0; k < 3; ++k) {
          const double a = turned[k][p], b = turned[k][q];
          turned[k][p] = c * a - s * b;
          turned[k][q] = s * a + c * b;
        }
      }
    }
  }
}

/// The place nearest to `mean` where the tangent planes at the crossings meet best.
Vector where_planes_meet(std::span<const Crossing> crossings, const Vector& mean) {
  Symmetric matrix{}, turned{};
  Vector right;
  for (const auto& [place, normal] : crossings) {
    const std::array<double, 3> n = {normal.x, normal.y, normal.z};
    for (std::size_t p = 0; p < 3; ++p) {
      for (std::size_t q = 0; q < 3; ++q) matrix[p][q] += n[p] * n[q];
    }
    right = right + dot(normal, place - mean) * normal;
  }
  diagonalize(matrix, turned);
  const double largest = std::max({matrix[0][0], matrix[1][1], matrix[2][2]});
  Vector meet = mean;
  for (std::size_t k = 0; k < 3; ++k) {
    if (!(matrix[k][k] > least_share * largest)) continue;
    const Vector direction{turned[0][k], turned[1][k], turned[2][k]};
    meet = meet + (dot(direction, right) / matrix[k][k]) * direction;
  }
  return meet;
}

Vector clamped(const Vector& place, const Vector& center, double half) {
  const auto within = [&](double x, double middle) { return std::clamp(x, middle - half, middle + half); };
  return {within(place.x, center.x), within(place.y, center.y), within(place.z, center.z)};
}

/// Where a step along the gradient to the surface ends, kept in the cell: what would leave it goes along its side.
Vector stepped(const Vector& place, const Slope& slope, const Vector& center, double half) {
  const auto blocked = [&](double x, double middle, double gradient) {
    const double away = -slope.value * gradient;
    return away > 0 ? x >= middle + half : x <= middle - half;
  };
  Vector free = slope.gradient;
  if (blocked(place.x, center.x, free.x)) free.x = 0;
  if (blocked(place.y, center.y, free.y)) free.y = 0;
  if (blocked(place.z, center.z, free.z)) free.z = 0;
  const double steepness = squared_length(free);
  return steepness > 0 ? clamped(place - (slope.value / steepness) * free, center, half) : place;
}

/// Steps to the surface while that helps.
Slope polish(const ScalarField& field, Vector& place, const Vector& center, double half) {
  constexpr int most_steps = 8;
  constexpr double good_enough = 1e-12;
  Slope slope = field.slope(place);
  for (int step = 0; step < most_steps && std::abs(slope.value) > good_enough * half; ++step) {
    if (!is_finite(slope.gradient)) break;
    const Vector next = stepped(place, slope, center, half);
    const Slope there = field.slope(next);
    if (!(std::abs(there.value) < std::abs(slope.value))) break;
    place = next;
    slope = there;
  }
  return slope;
}

/// Puts normals that are near one another together; each side has their mean.
void find_sides(std::span<const Crossing> crossings, ImplicitVertex& vertex) {
  std::vector<Vector> firsts;
  for (const Crossing& crossing : crossings) {
    std::size_t side = 0;
    while (side < firsts.size() && dot(firsts[side], crossing.normal) < one_side) ++side;
    if (side == firsts.size()) {
      firsts.push_back(crossing.normal);
      vertex.normals.push_back({});
    }
    vertex.normals[side] = vertex.normals[side] + crossing.normal;
    vertex.normal_of.push_back(static_cast<std::uint8_t>(side));
  }
  for (std::size_t side = 0; side < firsts.size(); ++side) {
    const Vector mean = normalized(vertex.normals[side]);
    vertex.normals[side] = mean == Vector{} ? firsts[side] : mean;
  }
}

}  // namespace

ImplicitVertex implicit_vertex(const ScalarField& field, std::span<const Crossing> crossings, const Vector& center,
                               double step, bool only_piece) {
  Vector place, normal;
  for (const Crossing& crossing : crossings) {
    place = place + crossing.place;
    normal = normal + crossing.normal;
  }
  place = place / static_cast<double>(crossings.size());
  normal = normalized(normal);
  const double half = 0.5 * within_cell * step;
  const bool is_smooth = std::all_of(crossings.begin(), crossings.end(),
                                     [&](const Crossing& c) { return dot(c.normal, normal) > smooth; });
  if (!is_smooth && only_piece) place = where_planes_meet(crossings, place);
  ImplicitVertex vertex{clamped(place, center, half), {}, {}};
  const Slope slope = only_piece ? polish(field, vertex.place, center, half) : field.slope(vertex.place);
  if (!is_smooth) {
    find_sides(crossings, vertex);
    return vertex;
  }
  const Vector steepest = normalized(slope.gradient);
  vertex.normals = {is_finite(steepest) && dot(steepest, normal) > 0 ? steepest : normal};
  vertex.normal_of.assign(crossings.size(), 0);
  return vertex;
}

}  // namespace dini
