#include <atomic>
#include <functional>
#include <tbb/global_control.h>
#include <tbb/task_arena.h>

#include "geometry/implicit_mesh.h"
#include "tests/geometry/fields.h"
#include "tests/geometry/grids.h"

using namespace dini;
using namespace dini::support;

namespace {

constexpr std::size_t any_number = 10'000'000;

ImplicitOptions cube(double half, std::size_t resolution) {
  return {{-half, -half, -half}, {half, half, half}, resolution, any_number, any_number};
}

ImplicitSurface surface_of_field(const SharedField& field, const ImplicitOptions& options) {
  ImplicitSurface surface = implicit_mesh(field, options, never_stopped);
  const auto defect = mesh_defect(surface.mesh);
  INFO(defect.value_or("no defect"));
  CHECK(!defect);
  return surface;
}

/// The largest distance of the middles of triangles from the surface that `distance(place)` tells.
template <class Distance>
double face_error(const Mesh& mesh, Distance distance) {
  double error = 0;
  for (const auto& [i, j, k] : mesh.triangles) {
    const Vector middle =
        (to_vector(mesh.positions[i]) + to_vector(mesh.positions[j]) + to_vector(mesh.positions[k])) / 3;
    error = std::max(error, std::abs(distance(middle)));
  }
  return error;
}

template <class Distance>
double vertex_error(const Mesh& mesh, Distance distance) {
  double error = 0;
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    error = std::max(error, std::abs(distance(to_vector(mesh.positions[i]))));
  }
  return error;
}

}  // namespace

TEST_CASE("The mesh of an implicit sphere is within a third of cell^2 / radius, its vertices within a fiftieth") {
  for (const std::size_t resolution : {7u, 24u, 61u}) {
    const ImplicitSurface surface = surface_of_field(sphere_field({0.1, 0.2, -0.1}, 0.7), cube(1, resolution));
    const double step = 2.0 / static_cast<double>(resolution);
    const auto distance = [](const Vector& place) { return length(place - Vector{0.1, 0.2, -0.1}) - 0.7; };
    CHECK(vertex_error(surface.mesh, distance) < 0.02 * step * step / 0.7);
    CHECK(face_error(surface.mesh, distance) < 0.33 * step * step / 0.7);
    CHECK(normal_error(surface.mesh, [](const Point& p) {
            return normalized(to_vector(p) - Vector{0.1, 0.2, -0.1});
          }) < 1e-9);
    const Measures measures = measured(surface.mesh);
    CHECK(measures.closed);
    CHECK(measures.euler == 2);
    CHECK_FALSE(surface.capped);
  }
}

TEST_CASE("The meshes of an implicit torus and of a boosted one are as near to them") {
  const SharedField torus = ring_field({0.1, 0, 0}, normalized(Vector{0.2, 0.3, 1}), 0.6, 0.2);
  const auto distance = [&](const Vector& place) { return value_at(*torus, place); };
  const ImplicitSurface plain = surface_of_field(torus, cube(1, 48));
  CHECK(vertex_error(plain.mesh, distance) < 0.02 * std::pow(2.0 / 48, 2) / 0.2);
  CHECK(face_error(plain.mesh, distance) < 0.33 * std::pow(2.0 / 48, 2) / 0.2);
  CHECK(measured(plain.mesh).closed);
  CHECK(measured(plain.mesh).euler == 0);

  const Versor boost = exponential(null_pair({0.3, 0.2, 1.2}, {0.05, -0.05, 0.2}));
  const ImplicitSurface boosted = surface_of_field(moved(torus, boost), cube(3, 96));
  CHECK(vertex_error(boosted.mesh, [&](const Vector& place) {
          return distance(to_vector(apply(reverse(boost), to_point(place)).value()));
        }) < 0.02 * std::pow(6.0 / 96, 2) / 0.2);
  CHECK(measured(boosted.mesh).closed);
  CHECK(measured(boosted.mesh).euler == 0);
  CHECK_FALSE(boosted.capped);
}

TEST_CASE("Edges and corners of a solid are kept") {
  // A cube that stands askew, from six planes.
  const Vector u = normalized(Vector{1, 0.3, 0.2}), v = normalized(cross(u, {0.1, 0.2, 1})), w = cross(u, v);
  std::vector<SharedField> sides;
  for (const Vector& normal : {u, v, w}) {
    sides.push_back(plane_field(normal, 0.5));
    sides.push_back(plane_field(-normal, 0.5));
  }
  const SharedField askew = intersection_field(sides, 0);
  const ImplicitSurface surface = surface_of_field(askew, cube(1, 20));
  const Measures measures = measured(surface.mesh);
  CHECK(measures.closed);
  CHECK(measures.euler == 2);
  CHECK(measures.volume == Approx(1).epsilon(2e-3));
  CHECK(measures.area == Approx(6).epsilon(5e-3));
  for (int corner = 0; corner < 8; ++corner) {
    const auto side = [&](int bit) { return (corner >> bit & 1) != 0 ? 0.5 : -0.5; };
    const Vector place = side(0) * u + side(1) * v + side(2) * w;
    double nearest = 1;
    for (std::size_t i = 0; i < surface.mesh.positions.size(); ++i) {
      nearest = std::min(nearest, length(to_vector(surface.mesh.positions[i]) - place));
    }
    CHECK(nearest < 0.3 * 2 / 20);  // a tip that no edge of its cell meets is cut off
  }
  // Every normal is that of a side, also along edges.
  for (std::size_t i = 0; i < surface.mesh.normals.size(); ++i) {
    double nearest = 2;
    for (const Vector& side : {u, v, w, -u, -v, -w})
      nearest = std::min(nearest, length(side - surface.mesh.normals[i]));
    CHECK(nearest < 1e-6);
  }
}

TEST_CASE("A solid that leaves the box is closed on its sides") {
  const ImplicitSurface surface = surface_of_field(plane_field({0, 0, 1}, 0.25), cube(1, 10));
  CHECK(surface.capped);
  const Measures measures = measured(surface.mesh);
  CHECK(measures.closed);
  CHECK(measures.euler == 2);
  CHECK(measures.volume == Approx(2 * 2 * 1.25).epsilon(1e-9));
}

TEST_CASE("Every mesh is closed and two-manifold, however little the cells resolve") {
  RandomElements random(11);
  int ambiguous = 0;
  for (int round = 0; round < 60; ++round) {
    SharedField field;
    if (round % 2 == 0) {
      field = random_field(random, 3);
    } else {
      // Balls and bubbles about as large as a cell.
      Column<Point> centers(60);
      for (std::size_t i = 0; i < 60; ++i) centers.set(i, random.point(0.9));
      field = balls_field(std::move(centers), 0.16, 0, Cancel());
      if (round % 4 == 1) field = complement_field(field);
      ++ambiguous;
    }
    CAPTURE(round);
    const ImplicitSurface surface = surface_of_field(field, cube(1, 9 + static_cast<std::size_t>(round % 5)));
    if (surface.mesh.triangles.empty()) continue;
    const Measures measures = measured(surface.mesh);
    CHECK(measures.closed);
    CHECK(measures.volume > 0);
    CHECK(measures.euler % 2 == 0);
  }
  CHECK(ambiguous > 0);
}

TEST_CASE("A mesh is the same on one thread and on two") {
  RandomElements random(12);
  const SharedField field = random_field(random, 4);
  const auto made = [&](std::size_t threads) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    tbb::task_arena arena(static_cast<int>(threads));
    return arena.execute([&] { return implicit_mesh(field, cube(2, 28), never_stopped).mesh; });
  };
  const Mesh one = made(1), two = made(2);
  CHECK(one.positions.size() > 100);
  CHECK(*one.positions == *two.positions);
  CHECK(*one.normals == *two.normals);
  CHECK((one.triangles == two.triangles));
}

namespace {

/// What was asked of a field that is folded everywhere, and how many parts of it there were at once.
struct Asked {
  std::atomic<std::size_t> values = 0, parts = 0, most_parts = 0;
  std::function<void()> when_asked = [] {};
};

/// Of which nothing is known but its values; as heavy as it says.
class FoldedField : public ScalarField {
 public:
  static constexpr std::size_t part_bytes = 1000;

  FoldedField(Asked& asked, std::size_t operations)
      : ScalarField({operations, 1, part_bytes}, std::nullopt), asked_(asked) {
    std::size_t most = asked_.most_parts, parts = ++asked_.parts;
    while (most < parts && !asked_.most_parts.compare_exchange_weak(most, parts)) {
    }
  }
  ~FoldedField() override { --asked_.parts; }

  void values(const Places& at, double* out) const override {
    asked_.values += at.count;
    asked_.when_asked();
    for (std::size_t i = 0; i < at.count; ++i) {
      out[i] = std::sin(50 * at.x[i]) * std::sin(50 * at.y[i]) * std::sin(50 * at.z[i]);
    }
  }
  Slope slope(const Vector&) const override { return {0, {0, 0, 1}}; }
  Narrowed narrowed(const SolidBall&, const SharedField&) const override {
    return {{}, std::make_shared<FoldedField>(asked_, size().operations)};
  }
  std::string formula() const override { return "folded"; }

 private:
  Asked& asked_;
};

}  // namespace

TEST_CASE("A surface that is too large is left before all of it is made") {
  Asked all, few;
  ImplicitOptions options = cube(1, 24);
  implicit_mesh(std::make_shared<FoldedField>(all, 1), options, never_stopped);
  options.most_vertices = 100;
  const ImplicitSurface surface = implicit_mesh(std::make_shared<FoldedField>(few, 1), options, never_stopped);
  CHECK(surface.too_large);
  CHECK(surface.mesh.positions.empty());
  CHECK(few.values < all.values / 4);
}

TEST_CASE("What is left of a field in parts of the box takes so much memory and no more, and changes nothing") {
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, 2);
  Asked wide, narrow;
  ImplicitOptions options = cube(1, 24);
  const Mesh free = implicit_mesh(std::make_shared<FoldedField>(wide, 1), options, never_stopped).mesh;
  options.most_field_bytes = 3 * FoldedField::part_bytes;
  const Mesh bounded = implicit_mesh(std::make_shared<FoldedField>(narrow, 1), options, never_stopped).mesh;
  // The whole, three on the way and three that are kept, and one more on each thread, which is thrown away at once.
  CHECK(narrow.most_parts <= 1 + 3 + 3 + 2);
  CHECK(wide.most_parts > narrow.most_parts);
  CHECK(*free.positions == *bounded.positions);
  CHECK((free.triangles == bounded.triangles));
}

TEST_CASE("A mesh of a heavy field is stopped between places") {
  const Cancel canceled;
  Asked asked;
  asked.when_asked = [&] {
    if (asked.values > 5000) canceled.stop(StopReason::canceled);
  };
  implicit_mesh(std::make_shared<FoldedField>(asked, std::size_t{1} << 17), cube(1, 64), canceled);
  CHECK(asked.values > 5000);
  CHECK(asked.values < 5100);
}

TEST_CASE("An empty solid has no mesh, one that is too large is told, and a stopped one ends") {
  CHECK(surface_of_field(sphere_field({5, 0, 0}, 1), cube(1, 20)).mesh.triangles.empty());
  ImplicitOptions few = cube(1, 40);
  few.most_vertices = 100;
  const ImplicitSurface large = surface_of_field(sphere_field({}, 0.8), few);
  CHECK(large.too_large);
  CHECK(large.mesh.positions.empty());
  const Cancel stopped;
  stopped.stop(StopReason::canceled);
  implicit_mesh(sphere_field({}, 0.8), cube(1, 512), stopped);
}
