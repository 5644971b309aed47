#include "golden/compare.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "golden/nearest_place.h"

namespace dini {
namespace {

std::string number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.5g", value);
  return text;
}

std::string place(const Vector& at) { return "(" + number(at.x) + ", " + number(at.y) + ", " + number(at.z) + ")"; }

double largest_extent(const ModelFacts& facts) {
  const Vector size = facts.high - facts.low;
  return std::max({size.x, size.y, size.z});
}

/// Files keep positions in single precision, golden results in seven digits.
double round_off(const ModelFacts& facts) {
  constexpr double seven_digits = 5e-7;
  return seven_digits * std::max(length(facts.low), length(facts.high));
}

class Differences {
 public:
  Differences(const ModelFacts& golden, const Model& model, double accepted)
      : golden_(golden), model_(model), accepted_(accepted) {}

  std::vector<std::string> all(double& deviation) {
    counts();
    measures();
    kept_points(deviation);
    new_parts();
    return std::move(found_);
  }

 private:
  template <class Number>
  void count(const char* what, Number now, Number before) {
    if (now != before) found_.push_back(what + (": " + std::to_string(now)) + ", was " + std::to_string(before));
  }

  void measure(const char* what, double now, double before, double accepted, const char* unit) {
    if (std::abs(now - before) <= accepted) return;
    found_.push_back(what + (": " + number(now)) + " " + unit + ", was " + number(before) +
                     " (accepted is a difference of " + number(accepted) + ")");
  }

  void counts() {
    const ModelFacts& now = model_.facts;
    count("triangles", now.triangles, golden_.triangles);
    count("segments of curves", now.segments, golden_.segments);
    count("points", now.points, golden_.points);
    count("Euler number", now.euler, golden_.euler);
    if (now.closed != golden_.closed) found_.push_back(now.closed ? "closed, was open" : "open, was closed");
  }

  void measures() {
    const ModelFacts& now = model_.facts;
    const auto bound = [&](const char* what, double Vector::*axis) {
      measure((std::string("least ") + what).c_str(), now.low.*axis, golden_.low.*axis, accepted_, "m");
      measure((std::string("largest ") + what).c_str(), now.high.*axis, golden_.high.*axis, accepted_, "m");
    };
    bound("x", &Vector::x);
    bound("y", &Vector::y);
    bound("z", &Vector::z);
    // To first order, corners that move by d change the area by at most d times half of all edges, and the volume by at
    // most d times the area.
    constexpr double second_order = 1.1;
    measure("area", now.area, golden_.area, second_order * accepted_ * std::max(now.edges, golden_.edges), "m²");
    if (!now.closed || !golden_.closed) return;
    measure("volume", now.volume, golden_.volume, second_order * accepted_ * std::max(now.area, golden_.area), "m³");
  }

  void kept_points(double& deviation) {
    constexpr double accepted_color = 1.0 / 64, least_cosine = 0.5;
    std::size_t turned = 0, facing = 0;
    double most_recolored = accepted_color;
    Vector farthest;
    std::string recolored;
    const NearestPlaces places(model_.shape);
    for (const Sample& sample : golden_.samples) {
      const NearestPlace near = places.to(sample, accepted_);
      if (near.distance > deviation) {
        deviation = near.distance;
        farthest = sample.position;
      }
      if (near.distance > accepted_) continue;  // what is elsewhere has no color or normal to compare
      if (near.recolored > most_recolored) {
        most_recolored = near.recolored;
        recolored = "color at " + place(sample.position) + ": " + color(near.color) + ", was " + color(sample.color);
      }
      if (sample.normal == Vector{}) continue;
      ++facing;
      if (near.turned < least_cosine) ++turned;
    }
    if (deviation > accepted_) {
      found_.push_back("shape: " + place(farthest) + " was on the model and is " + number(deviation) +
                       " m away from it (accepted is " + number(accepted_) + " m)");
    }
    if (!recolored.empty()) found_.push_back(recolored);
    // A few tiny triangles may turn when their corners are rounded otherwise.
    constexpr std::size_t one_of = 20;
    if (turned * one_of > facing) {
      found_.push_back("normals: " + std::to_string(turned) + " of " + std::to_string(facing) +
                       " points face another way");
    }
  }

  void new_parts() {
    if (golden_.samples.empty()) return;
    const Farthest farthest = farthest_from(model_.shape, golden_.samples);
    if (farthest.distance <= golden_.spacing + accepted_) return;
    found_.push_back("shape: " + place(farthest.position) + " is on the model and was not: it is " +
                     number(farthest.distance) + " m from every kept point, and nothing was farther than " +
                     number(golden_.spacing) + " m");
  }

  static std::string color(const std::array<float, 4>& color) {
    return number(color[0]) + " " + number(color[1]) + " " + number(color[2]) + " " + number(color[3]);
  }

  const ModelFacts& golden_;
  const Model& model_;
  const double accepted_;
  std::vector<std::string> found_;
};

}  // namespace

Comparison compare(const ModelFacts& golden, const Model& model, double tolerance) {
  using enum Comparison::Verdict;
  if (golden.sha256 == model.facts.sha256) return {};
  const double accepted = tolerance * largest_extent(golden) + golden.position_error + model.facts.position_error +
                          round_off(golden) + round_off(model.facts);
  Comparison comparison{.verdict = within, .accepted = accepted};
  comparison.differences = Differences(golden, model, accepted).all(comparison.deviation);
  if (!comparison.differences.empty()) comparison.verdict = changed;
  return comparison;
}

}  // namespace dini
