#include "geometry/contours.h"

#include <algorithm>
#include <numeric>
#include <queue>
#include <unordered_map>

#include "geometry/weld.h"

namespace dini {

namespace {

/// An edge of the mesh, by its two vertices, the lower one in the upper half.
using Edge = std::uint64_t;

/// From where the plane enters a triangle to where it leaves it.
struct Cut {
  Edge from, to;
};

Edge edge_of(std::uint32_t a, std::uint32_t b) { return std::uint64_t{std::min(a, b)} << 32 | std::max(a, b); }

class Section {
 public:
  Section(const Mesh& mesh, const Vector& normal, double height, const Cancel& cancel)
      : mesh_(mesh), normal_(normal), height_(height), looks_(cancel) {
    const std::vector<std::uint32_t> labels = position_labels(mesh.positions, cancel);
    for (const auto& [i, j, k] : *mesh.triangles) {
      if (looks_.stopped()) return;
      cut(labels[i], labels[j], labels[k]);
    }
    by_start_.resize(cuts_.size());
    std::iota(by_start_.begin(), by_start_.end(), std::size_t{0});
    std::sort(by_start_.begin(), by_start_.end(), [&](std::size_t a, std::size_t b) {
      return cuts_[a].from != cuts_[b].from ? cuts_[a].from < cuts_[b].from : a < b;
    });
  }

  std::vector<Contour> contours() {
    std::vector<Contour> found;
    std::vector<bool> used(cuts_.size());
    // What nothing leads to starts an open contour; what is left then goes around.
    std::vector<Edge> ends;
    for (const Cut& cut : cuts_) ends.push_back(cut.to);
    std::sort(ends.begin(), ends.end());
    for (const bool open : {true, false}) {
      for (std::size_t i = 0; i < cuts_.size() && !looks_.stopped(); ++i) {
        if (used[i] || (open && std::binary_search(ends.begin(), ends.end(), cuts_[i].from))) continue;
        Contour contour = follow(i, used);
        if (contour.points.size() > 1) found.push_back(std::move(contour));
      }
    }
    std::stable_sort(found.begin(), found.end(),
                     [](const Contour& a, const Contour& b) { return a.length > b.length; });
    return found;
  }

 private:
  double above(std::uint32_t vertex) const { return dot(normal_, to_vector(mesh_.positions[vertex])) - height_; }

  void cut(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    if (a == b || b == c || c == a) return;
    std::array<std::uint32_t, 3> corners = {a, b, c};
    std::array<bool, 3> up{};
    for (std::size_t k = 0; k < 3; ++k) up[k] = above(corners[k]) >= 0;
    if (up[0] == up[1] && up[1] == up[2]) return;
    // The corner that is alone on its side, first.
    const std::size_t alone = up[1] == up[2] ? 0 : up[0] == up[2] ? 1 : 2;
    const std::uint32_t tip = corners[alone], next = corners[(alone + 1) % 3], last = corners[(alone + 2) % 3];
    const Edge one = edge_of(tip, next), other = edge_of(tip, last);
    // Seen from outside with the normal up the contour runs to the right: what is to its left is inside.
    cuts_.push_back(up[alone] ? Cut{one, other} : Cut{other, one});
  }

  Vector place_of(Edge edge) const {
    const auto a = static_cast<std::uint32_t>(edge >> 32), b = static_cast<std::uint32_t>(edge);
    const double at_a = above(a), at_b = above(b);
    const Vector from = to_vector(mesh_.positions[a]), to = to_vector(mesh_.positions[b]);
    return from + (at_a / (at_a - at_b)) * (to - from);
  }

  /// The first cut that starts at an edge and was not used yet; none is cuts_.size().
  std::size_t next_from(Edge edge, const std::vector<bool>& used) {
    const auto place = std::lower_bound(by_start_.begin(), by_start_.end(), edge,
                                        [&](std::size_t i, Edge wanted) { return cuts_[i].from < wanted; });
    auto at = static_cast<std::size_t>(place - by_start_.begin());
    // Many triangles may share an edge: what is used is skipped at once the next time.
    std::size_t& known = skip_to_.try_emplace(edge, at).first->second;
    for (at = known; at < by_start_.size() && used[by_start_[at]] && cuts_[by_start_[at]].from == edge;) ++at;
    known = at;
    return at < by_start_.size() && cuts_[by_start_[at]].from == edge ? by_start_[at] : cuts_.size();
  }

  Contour follow(std::size_t start, std::vector<bool>& used) {
    Contour contour;
    std::vector<Vector>& points = contour.points;
    points.push_back(place_of(cuts_[start].from));
    for (std::size_t at = start; at < cuts_.size() && !looks_.stopped();) {
      used[at] = true;
      const Vector place = place_of(cuts_[at].to);
      if (place != points.back()) points.push_back(place);
      contour.closed = cuts_[at].to == cuts_[start].from;
      at = contour.closed ? cuts_.size() : next_from(cuts_[at].to, used);
    }
    if (contour.closed) {
      while (points.size() > 1 && points.back() == points.front()) points.pop_back();
      const Vector direction = any_perpendicular(normal_);
      std::rotate(
          points.begin(),
          std::max_element(points.begin(), points.end(),
                           [&](const Vector& a, const Vector& b) { return dot(direction, a) < dot(direction, b); }),
          points.end());
    }
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (!contour.closed && i + 1 == points.size()) break;
      const Vector& next = points[(i + 1) % points.size()];
      contour.length += length(next - points[i]);
      if (contour.closed) contour.area += 0.5 * dot(normal_, cross(points[i] - points[0], next - points[0]));
    }
    return contour;
  }

  const Mesh& mesh_;
  Vector normal_;
  double height_;
  CancelEvery looks_;
  std::vector<Cut> cuts_;
  std::vector<std::size_t> by_start_;
  std::unordered_map<Edge, std::size_t> skip_to_;
};

/// How many of `count` steps each side gets: one, and the rest by length, the longest steps first.
std::vector<std::size_t> steps_of_sides(const std::vector<double>& lengths, std::size_t count, CancelEvery& looks) {
  std::vector<std::size_t> steps(lengths.size(), 1);
  const double total = std::accumulate(lengths.begin(), lengths.end(), 0.0);
  const auto spare = static_cast<double>(count - lengths.size());
  std::size_t given = lengths.size();
  using Longest = std::pair<double, std::size_t>;
  std::priority_queue<Longest> waiting;
  for (std::size_t k = 0; k < lengths.size() && !looks.stopped(); ++k) {
    const auto more = total > 0 ? static_cast<std::size_t>(spare * (lengths[k] / total)) : 0;
    const std::size_t taken = std::min(more, count - given);
    steps[k] += taken;
    given += taken;
    waiting.emplace(lengths[k] / static_cast<double>(steps[k]), lengths.size() - k);
  }
  for (; given < count && !looks.stopped(); ++given) {
    const std::size_t number = waiting.top().second;
    waiting.pop();
    const std::size_t k = lengths.size() - number;
    ++steps[k];
    waiting.emplace(lengths[k] / static_cast<double>(steps[k]), number);
  }
  return steps;
}

}  // namespace

std::vector<Contour> contours_of(const Mesh& mesh, const Vector& normal, double height, const Cancel& cancel) {
  return Section(mesh, normal, height, cancel).contours();
}

Column<Point> contour_points(const Contour& contour, std::size_t count, const Cancel& cancel) {
  std::vector<Vector> around = contour.points;
  if (!contour.closed) {
    for (std::size_t i = contour.points.size() - 1; i-- > 1;) around.push_back(contour.points[i]);
  }
  CancelEvery looks(cancel);
  const std::size_t corners = around.size();
  std::vector<double> lengths(corners);
  for (std::size_t i = 0; i < corners && !looks.stopped(); ++i) {
    lengths[i] = length(around[(i + 1) % corners] - around[i]);
  }
  Column<Point> points(count);
  if (corners <= count) {
    const std::vector<std::size_t> steps = steps_of_sides(lengths, count, looks);
    std::size_t at = 0;
    for (std::size_t i = 0; i < corners; ++i) {
      const Vector way = around[(i + 1) % corners] - around[i];
      for (std::size_t k = 0; k < steps[i] && at < count && !looks.stopped(); ++k) {
        points.set(at++, to_point(around[i] + (static_cast<double>(k) / static_cast<double>(steps[i])) * way));
      }
    }
    return points;
  }
  const double step = std::accumulate(lengths.begin(), lengths.end(), 0.0) / static_cast<double>(count);
  std::size_t side = 0;
  double before = 0;
  for (std::size_t i = 0; i < count && !looks.stopped(); ++i) {
    const double wanted = step * static_cast<double>(i);
    while (side + 1 < corners && before + lengths[side] <= wanted) before += lengths[side++];
    const double share = lengths[side] > 0 ? std::clamp((wanted - before) / lengths[side], 0.0, 1.0) : 0;
    points.set(i, to_point(around[side] + share * (around[(side + 1) % corners] - around[side])));
  }
  return points;
}

}  // namespace dini
