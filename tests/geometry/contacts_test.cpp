// Exact signs, and the pairs of triangles that meet.

#include "geometry/contacts.h"

#include <catch2/catch.hpp>

#include "geometry/exact_sign.h"
#include "geometry/primitives.h"
#include "geometry/triangle_pair.h"
#include "tests/geometry/grids.h"
#include "tests/support/random_elements.h"

using namespace dini;
using namespace dini::support;

namespace {

/// Integers of up to 38 bits, of which determinants can be computed in 128 bits.
Vector grid_place(RandomElements& random, double size) {
  const auto whole = [&] { return std::floor(random.number(size)); };
  return {whole(), whole(), whole()};
}

int sign_in_integers(const Vector& a, const Vector& b, const Vector& c, const Vector& d) {
  __extension__ typedef __int128 Wide;
  const auto part = [](double x, double y) { return Wide{static_cast<long long>(x)} - static_cast<long long>(y); };
  const Wide ux = part(b.x, a.x), uy = part(b.y, a.y), uz = part(b.z, a.z);
  const Wide vx = part(c.x, a.x), vy = part(c.y, a.y), vz = part(c.z, a.z);
  const Wide wx = part(d.x, a.x), wy = part(d.y, a.y), wz = part(d.z, a.z);
  const Wide volume = wx * (uy * vz - uz * vy) + wy * (uz * vx - ux * vz) + wz * (ux * vy - uy * vx);
  return volume > 0 ? 1 : volume < 0 ? -1 : 0;
}

PairCorners triangle(const Corners& vertices, const std::array<Vector, 3>& places) {
  return {vertices, places, axis_of_area(places)};
}

/// Two triangles without a common corner meet.
bool meet(const std::array<Vector, 3>& a, const std::array<Vector, 3>& b) {
  const bool found = triangles_meet(triangle({0, 1, 2}, a), triangle({3, 4, 5}, b));
  CHECK(found == triangles_meet(triangle({3, 4, 5}, b), triangle({0, 1, 2}, a)));
  return found;
}

const std::array<Vector, 3> flat = {Vector{0, 0, 0}, Vector{4, 0, 0}, Vector{0, 4, 0}};

}  // namespace

TEST_CASE("Sides of planes are those of integers, also where places are nearly in one plane") {
  RandomElements random(3);
  int zeros = 0;
  for (int round = 0; round < 3000; ++round) {
    const double size = round % 3 == 0 ? 4 : round % 3 == 1 ? 0x1p20 : 0x1p37;
    const Vector a = grid_place(random, size), b = grid_place(random, size), c = grid_place(random, size);
    Vector d = grid_place(random, size);
    // One step beside a place of the plane: the volume is of the size of an area, and rounding hides it.
    if (round % 2 == 0) d = b + c - a + Vector{0, 0, static_cast<double>(round / 2 % 3 - 1)};
    const int sign = sign_in_integers(a, b, c, d);
    zeros += sign == 0 ? 1 : 0;
    CHECK(side_of_plane(a, b, c, d) == sign);
    CHECK(side_of_plane(a, c, b, d) == -sign);
    CHECK(side_of_plane(a, b, c, b) == 0);
  }
  CHECK(zeros > 300);
  CHECK(side_of_plane({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1e-60}) == 1);
  CHECK(side_of_plane({1, 1, 1}, {2, 1, 1}, {1, 2, 1}, {0.1, 0.1, std::nextafter(1.0, 2.0)}) == 1);
}

TEST_CASE("Turns seen along an axis are those of the flat triangle") {
  const Vector a{0.1, 0.1, 5}, b{0.2, 0.2, -3};
  CHECK(turn_seen_along(2, a, b, {0.3, std::nextafter(0.3, 1.0), 1}) == 1);
  CHECK(turn_seen_along(2, {1, 1, 0}, {2, 2, 7}, {3, 3, 1}) == 0);
  CHECK(turn_seen_along(0, {9, 0, 0}, {8, 1, 0}, {7, 0, 1}) == 1);
  CHECK(turn_seen_along(1, {0, 5, 0}, {0, 6, 1}, {1, 7, 0}) == 1);
}

TEST_CASE("Triangles meet where they have a point in common, and not a hair beside it") {
  CHECK(meet(flat, {Vector{1, 1, -1}, {1, 1, 1}, {2, 1, 1}}));
  CHECK(meet(flat, {Vector{1, 1, 0}, {1, 1, 1}, {2, 1, 1}}));          // a corner in the other
  CHECK(meet(flat, {Vector{2, -1, 0}, {2, 1, 0}, {2, 0, 1}}));         // an edge crosses one
  CHECK(meet(flat, {Vector{4, 0, 0}, {5, 0, 0}, {5, 1, 1}}));          // corner on corner
  CHECK(meet(flat, {Vector{1, 1, 0}, {9, 9, 0}, {9, 8, 0}}));          // in one plane
  CHECK(meet(flat, {Vector{0.5, 0.5, 0}, {1, 0.5, 0}, {0.5, 1, 0}}));  // one inside the other
  CHECK_FALSE(meet(flat, {Vector{1, 1, 1e-60}, {1, 1, 1}, {2, 1, 1}}));
  CHECK_FALSE(meet(flat, {Vector{5, 5, 0}, {9, 9, 0}, {9, 8, 0}}));
  CHECK_FALSE(meet(flat, {Vector{2, std::nextafter(2.0, 3.0), -1}, {2, std::nextafter(2.0, 3.0), 1}, {3, 3, 0}}));
}

TEST_CASE("Random triangles meet as a segment through a triangle says") {
  RandomElements random(8);
  int found = 0;
  for (int round = 0; round < 2000; ++round) {
    std::array<std::array<Vector, 3>, 2> pair;
    for (auto& places : pair) places = {random.vector(), random.vector(), random.vector()};
    const auto pierces = [](const std::array<Vector, 3>& t, const Vector& p, const Vector& q) {
      const Vector normal = cross(t[1] - t[0], t[2] - t[0]);
      const double from = dot(normal, p - t[0]), to = dot(normal, q - t[0]);
      if ((from > 0) == (to > 0)) return false;
      const Vector hit = p + from / (from - to) * (q - p);
      for (std::size_t k = 0; k < 3; ++k) {
        if (dot(normal, cross(t[(k + 1) % 3] - t[k], hit - t[k])) < 0) return false;
      }
      return true;
    };
    bool expected = false;
    for (std::size_t k = 0; k < 3; ++k) {
      expected = expected || pierces(pair[0], pair[1][k], pair[1][(k + 1) % 3]) ||
                 pierces(pair[1], pair[0][k], pair[0][(k + 1) % 3]);
    }
    found += expected ? 1 : 0;
    CHECK(meet(pair[0], pair[1]) == expected);
  }
  CHECK(found > 100);
}

TEST_CASE("Triangles with a common corner or edge meet only beside it") {
  const auto pair = [](const std::array<Vector, 3>& b, const Corners& vertices) {
    return triangles_meet(triangle({0, 1, 2}, flat), triangle(vertices, b));
  };
  CHECK_FALSE(pair({Vector{0, 0, 0}, {-1, -1, 0}, {-1, -2, 0}}, {0, 3, 4}));
  CHECK_FALSE(pair({Vector{0, 0, 0}, {1, 1, 1}, {1, 2, 1}}, {0, 3, 4}));
  CHECK(pair({Vector{0, 0, 0}, {1, 1, 1}, {1, 1, -1}}, {0, 3, 4}));
  CHECK(pair({Vector{0, 0, 0}, {1, 1, 0}, {1, 2, 1}}, {0, 3, 4}));  // along an edge of its own
  CHECK(pair({Vector{0, 0, 0}, {9, 1, 0}, {9, 2, 0}}, {0, 3, 4}));  // in one plane, and the cones overlap
  CHECK_FALSE(pair({Vector{4, 0, 0}, {0, 0, 0}, {0, -4, 0}}, {1, 0, 3}));
  CHECK_FALSE(pair({Vector{4, 0, 0}, {0, 0, 0}, {1, 1, 1}}, {1, 0, 3}));
  CHECK(pair({Vector{4, 0, 0}, {0, 0, 0}, {1, 1, 0}}, {1, 0, 3}));  // folded back
  CHECK(pair({Vector{0, 0, 0}, {0, 4, 0}, {4, 0, 0}}, {0, 2, 1}));  // on one another
}

TEST_CASE("Surfaces that are embedded meet nowhere, and a spindle torus does, up to the limit") {
  const Cancel& cancel = never_stopped;
  for (const double minor : {0.1, 0.6, 0.99}) {
    const Mesh torus = torus_mesh({0, 0, 0}, {0.3, 0.1, 1}, 1, minor, 48, 24, cancel);
    CHECK(contacts_of(welded(torus, cancel), 1000, cancel).pairs == 0);
  }
  CHECK(contacts_of(welded(sphere_mesh({1e3, 0, 0}, 1, 40, 20, cancel), cancel), 1000, cancel).pairs == 0);
  const WeldedMesh spindle = welded(torus_mesh({0, 0, 0}, {0, 0, 1}, 1, 1.5, 48, 24, cancel), cancel);
  const Contacts all = contacts_of(spindle, 1'000'000, cancel);
  CHECK(all.pairs > 48);
  REQUIRE(all.place);
  CHECK(std::hypot(all.place->x, all.place->y) < 0.5);
  const Contacts some = contacts_of(spindle, 7, cancel);
  CHECK(some.pairs == 7);
  CHECK(*some.place == *all.place);
  CHECK(contacts_of({}, 10, cancel).pairs == 0);
}

TEST_CASE("The count of pairs is that of all pairs tried one by one") {
  const Cancel& cancel = never_stopped;
  RandomElements random(5);
  WeldedMesh soup;
  for (std::uint32_t i = 0; i < 150; ++i) {
    for (int k = 0; k < 3; ++k) soup.positions.push_back(random.vector());
    soup.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
  }
  std::size_t expected = 0;
  const auto one = [&](std::size_t i) {
    const auto& [a, b, c] = soup.triangles[i];
    return triangle(soup.triangles[i], {soup.positions[a], soup.positions[b], soup.positions[c]});
  };
  for (std::size_t i = 0; i < soup.triangles.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) expected += triangles_meet(one(i), one(k)) ? 1 : 0;
  }
  CHECK(expected > 50);
  CHECK(contacts_of(soup, 1'000'000, cancel).pairs == expected);
}
