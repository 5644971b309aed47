// Figure 12: the warp of the example against the plainest possible algebra, 32 coefficients at a time.

#include "tests/support/dense.h"
#include "tests/support/looked_up.h"
#include "tests/support/triple.h"

using namespace dini;
using namespace dini::support;

namespace {

using Dense = dense::Multivector<long double>;

struct Pair {
  Vector position, direction;
};

/// exp(strength * sum of weighted pairs) on a point, the result's center: eqs. (13), (16) word by word.
Vector slow_warp(const std::vector<Pair>& pairs, const Vector& p, long double strength, double power, double softening,
                 bool paper) {
  const auto no = dense::vector<long double>(1, 0, 0, 0, 0), ni = dense::vector<long double>(0, 0, 0, 0, 1);
  const auto direction = [](const Vector& v) { return dense::vector<long double>(0, v.x, v.y, v.z, 0); };
  Dense sum;
  for (const Pair& pair : pairs) {
    const Dense translator = dense::scalar(1.0L) + -0.5L * (direction(pair.position) * ni);
    const Dense moved = translator * (no ^ direction(pair.direction)) * dense::reverse(translator);
    const auto away = static_cast<long double>(length(p - pair.position));
    sum = sum + 1 / (std::pow(away, static_cast<long double>(power)) + static_cast<long double>(softening)) * moved;
  }
  const Dense b = strength * sum;
  Dense rotor = dense::exponential(b);
  if (paper) {
    const long double square = (b * b).c[0], root = std::sqrt(std::abs(square));
    const long double cosine = square > 0 ? std::cosh(root) : std::cos(root);
    const long double sine = root == 0 ? 1 : (square > 0 ? std::sinh(root) : std::sin(root)) / root;
    rotor = dense::scalar(cosine) + sine * b;
  }
  const auto moved = dense::apply<long double>(rotor, p.x, p.y, p.z);
  return {static_cast<double>(moved[0]), static_cast<double>(moved[1]), static_cast<double>(moved[2])};
}

}  // namespace

TEST_CASE("Fig. 12: sheet and spheres are warped as the plain algebra says, by both rules") {
  const Json graph = example("fig12_warped_sphere");
  const std::vector<Pair> sheet_pairs = {
      {{-0.7, 0, 0.5}, {0.2, 0.1, 0.9}}, {{0.7, -0.4, 0.2}, {-0.3, 0.5, -0.8}}, {{0.2, 0.8, 0.2}, {0.6, -0.6, 0.3}}};
  const std::vector<Json> settings = {Json{{"rule", "exact"}}, Json{{"rule", "paper"}},
                                      Json{{"strength", -1.1}, {"power", 3.5}, {"softening", 0.2}, {"rule", "exact"}},
                                      Json{{"strength", 1.6}, {"power", 0}, {"softening", 1.5}, {"rule", "paper"}}};
  for (const Json& parameters : settings) {
    const double strength = parameters.value("strength", 0.7), power = parameters.value("power", 2.0),
                 softening = parameters.value("softening", 0.5);
    const bool paper = parameters["rule"] == "paper";
    const Json before = looked_up(graph, "sheet.points", parameters), after = looked_up(graph, "bent", parameters);
    for (std::size_t i = 0; i < before["values"].size(); i += 257) {
      const Vector wanted = slow_warp(sheet_pairs, triple(before["values"][i]), strength, power, softening, paper);
      require_near(after["values"][i], {wanted.x, wanted.y, wanted.z}, 1e-12);
    }
    const Json places = looked_up(graph, "place", parameters), tangents = looked_up(graph, "tangent", parameters);
    const Json ball = looked_up(graph, "ball", parameters, true), warped = looked_up(graph, "warped", parameters, true);
    REQUIRE(places["axes"][0]["name"] == "variant");
    const std::size_t pairs = places["axes"][1]["size"];
    for (std::size_t variant = 0; variant < warped["values"].size(); ++variant) {
      std::vector<Pair> around;
      for (std::size_t k = 0; k < pairs; ++k) {
        around.push_back(
            {triple(places["values"][variant * pairs + k]), triple(tangents["values"][variant * pairs + k])});
      }
      const Json& from = ball["values"][0]["positions"];
      const Json& to = warped["values"][variant]["positions"];
      const bool flat = from[0].is_number();
      const auto position = [flat](const Json& list, std::size_t i) {
        return flat ? Vector{list[3 * i], list[3 * i + 1], list[3 * i + 2]} : triple(list[i]);
      };
      const std::size_t count = flat ? from.size() / 3 : from.size();
      for (std::size_t i = variant; i < count; i += 1501) {
        const Vector wanted = slow_warp(around, position(from, i), strength, power, softening, paper);
        CHECK(length(position(to, i) - wanted) < 1e-12 * std::max(1.0, length(wanted)));
      }
    }
  }
}
