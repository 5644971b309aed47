// Figures 8 and 9: what runs along a field and what runs across it.

#include <complex>
#include <optional>

#include "algebra/versor.h"
#include "tests/support/looked_up.h"

using namespace dini;
using namespace dini::support;

namespace {

using Complex = std::complex<double>;

Generator generator_of(const Json& value) {
  const auto triple = [](const Json& v) { return Vector{v[0], v[1], v[2]}; };
  return {triple(value["no_e"]), triple(value["e_e"]), value["no_ni"], triple(value["e_ni"])};
}

/// Velocity of exp(t B) at a place of the xy plane, by central differences: about ten digits.
Complex velocity(const Generator& generator, const Complex& z) {
  constexpr double step = 1e-5;
  const Point at{z.real(), z.imag(), 0};
  const Point ahead = *apply(exponential(step * generator), at), behind = *apply(exponential(-step * generator), at);
  return Complex(ahead.x - behind.x, ahead.y - behind.y) / (2 * step);
}

/// A plane motion dz/dt = p z^2 + q z + r, and its time T(z), the integral of dz over that: along orbits T runs with t
/// and its imaginary part stays, along the curves across them its real part stays.
class PlaneMotion {
 public:
  explicit PlaneMotion(const Generator& generator) {
    r_ = velocity(generator, 0);
    const Complex sum = velocity(generator, 1) - r_, difference = velocity(generator, -1) - r_;
    p_ = (sum + difference) / 2.0;
    q_ = (sum - difference) / 2.0;
    if (std::abs(p_) < 1e-6) p_ = 0;
    const Complex root = std::sqrt(q_ * q_ - 4.0 * p_ * r_);
    double_ = std::abs(root) < 1e-3;
    if (p_ != 0.0) {
      first_ = (-q_ + root) / (2.0 * p_);
      second_ = (-q_ - root) / (2.0 * p_);
    } else {
      first_ = second_ = -r_ / q_;
    }
  }

  double level(const Complex& z) const {
    if (p_ == 0.0) return (std::log(z - first_) / q_).real();
    if (double_) return (-1.0 / (p_ * (z - first_))).real();
    // The argument goes around with the curve when its factor is imaginary, so only the modulus counts then.
    const Complex factor = 1.0 / (p_ * (first_ - second_));
    return (factor * std::log((z - first_) / (z - second_))).real();
  }

  Complex at(const Complex& z) const { return p_ * z * z + q_ * z + r_; }
  double distance_to_fixed(const Complex& z) const { return std::min(std::abs(z - first_), std::abs(z - second_)); }
  /// Whether the level jumps somewhere: around the two fixed points of a turn.
  bool is_many_valued() const { return p_ != 0.0 && !double_ && std::abs((p_ * (first_ - second_)).imag()) > 1e-6; }

 private:
  Complex p_, q_, r_, first_, second_;
  bool double_ = false;
};

std::vector<std::optional<Complex>> curve_of(const Json& answer, std::size_t curve) {
  const std::size_t size = answer["axes"].back()["size"];
  std::vector<std::optional<Complex>> points;
  for (std::size_t i = 0; i < size; ++i) {
    const Json& value = answer["values"][curve * size + i];
    points.push_back(value.is_null() ? std::nullopt : std::optional(Complex(value[0], value[1])));
  }
  return points;
}

std::size_t curves_in(const Json& answer) {
  return answer["values"].size() / answer["axes"].back()["size"].get<std::size_t>();
}

/// Which index of `axis` a curve stands at.
std::size_t index_along(const Json& answer, const std::string& axis, std::size_t curve) {
  for (std::size_t k = answer["axes"].size() - 1; k-- > 0;) {
    const std::size_t size = answer["axes"][k]["size"];
    if (answer["axes"][k]["name"] == axis) return curve % size;
    curve /= size;
  }
  FAIL("no such axis");
  return 0;
}

const std::vector<Json>& settings() {
  static const std::vector<Json> all = {
      Json::object(), {{"split", 0.05}, {"source", 1.3}}, {{"split", 0.9}, {"source", 0.2}}};
  return all;
}

std::vector<PlaneMotion> motions(const Json& graph, const Json& parameters) {
  std::vector<PlaneMotion> all;
  const Json generators = looked_up(graph, "panels", parameters);
  for (const Json& generator : generators["values"]) all.emplace_back(generator_of(generator));
  return all;
}

}  // namespace

TEST_CASE("Fig. 8: orbits are integral curves of the field") {
  const Json graph = example("fig08_critical_points");
  for (const Json& parameters : settings()) {
    const std::vector<PlaneMotion> fields = motions(graph, parameters);
    const Json orbits = looked_up(graph, "orbits", parameters);
    for (std::size_t curve = 0; curve < curves_in(orbits); ++curve) {
      const PlaneMotion& field = fields[index_along(orbits, "panel", curve)];
      const auto points = curve_of(orbits, curve);
      for (std::size_t i = 1; i + 1 < points.size(); ++i) {
        if (!points[i - 1] || !points[i] || !points[i + 1] || std::abs(*points[i]) > 3) continue;
        const Complex along = *points[i + 1] - *points[i - 1], wanted = field.at(*points[i]);
        // Fast and short passes are seen too coarsely for a difference.
        if (std::abs(along) > 0.1 || std::abs(wanted) < 1e-6) continue;
        CHECK(std::abs((along / wanted).imag()) < 2e-2 * std::abs(along / wanted));
      }
    }
  }
}

TEST_CASE("Fig. 8: contours are level sets across the orbits, and close or end at a fixed point or the clip radius") {
  const Json graph = example("fig08_critical_points");
  for (const Json& parameters : settings()) {
    const std::vector<PlaneMotion> fields = motions(graph, parameters);
    const Json contours = looked_up(graph, "dotted", parameters);
    for (std::size_t curve = 0; curve < curves_in(contours); ++curve) {
      const std::size_t panel = index_along(contours, "panel", curve);
      CAPTURE(parameters, panel, curve);
      const PlaneMotion& field = fields[panel];
      const auto points = curve_of(contours, curve);
      const Complex first = *points.front(), last = *points.back();
      const bool closed = first == last;
      const auto ended = [&](const Complex& z) { return field.distance_to_fixed(z) < 1e-3 || std::abs(z) > 1.799; };
      CHECK((closed || (ended(first) && ended(last))));
      if (field.is_many_valued()) continue;
      const double level = field.level(*points[points.size() / 3]);
      for (const auto& point : points) {
        if (field.distance_to_fixed(*point) < 0.05) continue;
        CHECK(std::abs(field.level(*point) - level) < 1e-3 * std::max(1.0, std::abs(level)));
      }
    }
  }
}

TEST_CASE("Fig. 9: contours close for every strength whose field has no pole within reach") {
  const Json graph = example("fig09_two_dipoles");
  for (const Json& parameters : {Json::object(), Json{{"strength", 0.05}, {"softening", 0.1}},
                                 Json{{"strength", 0.6}, {"softening", 1}}, Json{{"strength", 1}, {"softening", 2}}}) {
    for (const char* node : {"contours_sum", "contours_each"}) {
      const Json contours = looked_up(graph, node, parameters);
      for (std::size_t curve = 0; curve < curves_in(contours); ++curve) {
        const auto points = curve_of(contours, curve);
        CAPTURE(parameters, node, curve);
        const bool at_clip = std::abs(*points.front()) > 1.999 && std::abs(*points.back()) > 1.999;
        CHECK((*points.front() == *points.back() || at_clip));
      }
    }
  }
}
