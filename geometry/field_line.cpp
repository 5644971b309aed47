#include "geometry/field_line.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace dini {

namespace {

constexpr double most_change = 0.1;        ///< of a change of direction, by going half a step along it
constexpr double no_change = 1e-12;        ///< of directions, below which that cannot be told
constexpr double least_cosine = 0.995;     ///< of the turn within a step: a tenth of a radian
constexpr double smallest_step = 1e-7;     ///< of the largest
constexpr double vanishing_step = 1e-5;    ///< of the way so far: the line runs into a fixed point
constexpr double most_growth = 4;          ///< at most, from one step to the next
constexpr double shortest_rest = 1e-8;     ///< of the largest step; less is round-off
constexpr double steps_per_point = 4;      ///< at least
constexpr double closing_distance = 0.02;  ///< of the way

class Tracer {
 public:
  Tracer(const DirectionField& field, const Vector& start, const FieldLineOptions& options, const Cancel& cancel)
      : field_(field), start_(start), options_(options), cancel_(cancel) {
    const double way = std::abs(options.length);
    // A line that needs more winds around something without end.
    most_steps_ = 20'000 + 16 * options.count;
    sense_ = options.length < 0 ? -1 : 1;
    largest_ = options.count > 1 ? way / (steps_per_point * static_cast<double>(options.count - 1)) : 0;
  }

  FieldLine run() {
    FieldLine line;
    line.points.assign(options_.count, start_);
    if (options_.count < 2 || largest_ == 0 || !(length(start_) <= options_.clip_radius)) return line;
    const End ahead = find_end();
    double behind = 0;
    if (options_.both_ways && !ahead.closed) {
      sense_ = -sense_;
      behind = find_end().length;
      sense_ = -sense_;
    }
    line.length = behind + ahead.length;
    line.closed = ahead.closed;
    if (line.length > 0) place_points(line, behind);
    if (cancel_.stopped()) line.points.assign(options_.count, start_);
    return line;
  }

 private:
  struct Step {
    Vector place;
    double length = 0;
  };

  struct End {
    double length = 0;
    bool closed = false;
  };

  Vector direction(const Vector& place) const { return sense_ * field_(place); }

  void start_over() {
    taken_ = 0;
    last_ = largest_;
    gone_ = 0;
  }

  /// One step of the classical Runge-Kutta method; nothing where there is no direction or it turns too much.
  std::optional<Vector> step_of(const Vector& place, double h) const {
    const Vector first = direction(place);
    const Vector second = direction(place + (0.5 * h) * first);
    const Vector third = direction(place + (0.5 * h) * second);
    const Vector last = direction(place + h * third);
    if (first == Vector{} || second == Vector{} || third == Vector{} || last == Vector{}) return std::nullopt;
    if (dot(first, last) < least_cosine || dot(first, second) < least_cosine) return std::nullopt;
    if (length(third - second) > most_change * length(second - first) + no_change) return std::nullopt;
    const Vector moved = place + (h / 6) * (first + 2 * second + 2 * third + last);
    return is_finite(moved) ? std::optional<Vector>(moved) : std::nullopt;
  }

  /// A step as long as the field allows, at most `h`.
  std::optional<Step> step(const Vector& place, double h) {
    for (double tried = std::min(h, most_growth * last_); taken_++ < most_steps_ && !cancel_.stopped(); tried /= 2) {
      if (const std::optional<Vector> moved = step_of(place, tried)) {
        last_ = tried;
        gone_ += tried;
        return Step{*moved, tried};
      }
      if (tried <= std::max(smallest_step * largest_, vanishing_step * gone_)) break;
    }
    return std::nullopt;
  }

  /// Part of a step, found by its ends' signs: where `side` changes from below zero to zero or above.
  template <class Side>
  Step where(const Vector& place, const Step& whole, const Side& side) const {
    double low = 0, high = whole.length;
    Step found = whole;
    for (int i = 0; i < 40 && high - low > 1e-14 * whole.length; ++i) {
      const double middle = 0.5 * (low + high);
      const Step part{step_of(place, middle).value_or(place + (middle / whole.length) * (whole.place - place)), middle};
      if (side(part.place) >= 0) {
        high = middle;
        found = part;
      } else {
        low = middle;
      }
    }
    return found;
  }

  /// How far the line goes from its start.
  End find_end() {
    const Vector ahead = direction(start_);
    const double whole = std::abs(options_.length);
    const auto beyond = [&](const Vector& place) { return length(place) - options_.clip_radius; };
    const auto past_start = [&](const Vector& place) { return dot(place - start_, ahead); };
    double way = 0;
    start_over();
    for (Vector place = start_; way < whole;) {
      const std::optional<Step> next = step(place, std::min(largest_, whole - way));
      if (!next) break;
      if (past_start(place) < 0 && past_start(next->place) >= 0) {
        const Step back = where(place, *next, past_start);
        if (length(back.place - start_) <= closing_distance * (way + back.length)) return {way + back.length, true};
      }
      if (beyond(next->place) >= 0) return {way + where(place, *next, beyond).length, false};
      way += next->length;
      place = next->place;
    }
    return {way, false};
  }

  /// Goes `distance` along the line, or as far as it can.
  Vector advanced(Vector place, double distance) {
    while (distance > shortest_rest * largest_) {
      const std::optional<Step> next = step(place, std::min(largest_, distance));
      if (!next) break;
      place = next->place;
      distance -= next->length;
    }
    return place;
  }

  /// The points of a line that begins `behind` its start.
  void place_points(FieldLine& line, double behind) {
    const auto gaps = static_cast<double>(options_.count - 1);
    const auto way_to = [&](std::size_t i) { return line.length * (static_cast<double>(i) / gaps) - behind; };
    const std::size_t size = options_.count;
    std::size_t first_ahead = 0;
    while (first_ahead < size && way_to(first_ahead) < 0) ++first_ahead;
    start_over();
    Vector place = start_;
    for (std::size_t i = first_ahead; i < size && !cancel_.stopped(); ++i) {
      place = advanced(place, way_to(i) - (i > first_ahead ? way_to(i - 1) : 0));
      line.points[i] = place;
    }
    if (line.closed) return close(line, start_ - place);
    sense_ = -sense_;
    place = start_;
    for (std::size_t i = first_ahead; i-- > 0 && !cancel_.stopped();) {
      place = advanced(place, (i + 1 < first_ahead ? way_to(i + 1) : 0) - way_to(i));
      line.points[i] = place;
    }
    sense_ = -sense_;
  }

  /// Spreads what is missing over the points of a closed line.
  void close(FieldLine& line, const Vector& missing) const {
    const auto gaps = static_cast<double>(options_.count - 1);
    for (std::size_t i = 1; i < options_.count; ++i) {
      line.points[i] = line.points[i] + (static_cast<double>(i) / gaps) * missing;
    }
    line.points.back() = start_;
  }

  const DirectionField& field_;
  const Vector start_;
  const FieldLineOptions& options_;
  const Cancel& cancel_;
  double sense_ = 1;
  double largest_ = 0;
  double last_ = 0;  ///< the step before
  double gone_ = 0;  ///< since the start
  std::size_t taken_ = 0;
  std::size_t most_steps_ = 0;
};

}  // namespace

FieldLine field_line(const DirectionField& field, const Vector& start, const FieldLineOptions& options,
                     const Cancel& cancel) {
  return Tracer(field, start, options, cancel).run();
}

}  // namespace dini
