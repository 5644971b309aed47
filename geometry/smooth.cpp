#include "geometry/smooth.h"

#include <algorithm>
#include <span>

#include "geometry/chunks.h"
#include "geometry/weld.h"
#include "geometry/zeroed.h"

namespace dini {

namespace {

constexpr double longest_way = 2.0 / 3;  ///< Both steps together then make nothing rougher.
constexpr double pass_band = 0.02;  ///< of frequencies that stay, where 2 is a zigzag; they grow by 5 % in 1000 steps

/// The vertices that each vertex is drawn to, by the label of its position; none for those that stay.
class Neighbors {
 public:
  Neighbors(const Mesh& mesh, const std::vector<std::uint32_t>& labels, bool keeps_border, const Cancel& cancel)
      : begins_(labels.size() + 1), counts_(labels.size()) {
    gather(mesh, labels, cancel);
    // Sorting the neighbors takes some times as long as what chunks usually have.
    for_chunks(cancel, labels.size(), usual_chunk / 4, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) choose(i, keeps_border);
    });
  }

  std::span<const std::uint32_t> of(std::size_t vertex) const {
    return {all_.data() + begins_[vertex], counts_[vertex]};
  }

 private:
  /// Both other corners of each triangle around a vertex: a neighbor stands there once for each triangle on the edge.
  void gather(const Mesh& mesh, const std::vector<std::uint32_t>& labels, const Cancel& cancel) {
    CancelEvery looks(cancel);
    const auto for_each_corner = [&](const auto& take) {
      for (const auto& [i, j, k] : *mesh.triangles) {
        if (looks.stopped()) return;
        const std::uint32_t a = labels[i], b = labels[j], c = labels[k];
        if (a == b || b == c || c == a) continue;
        take(a, b, c);
        take(b, c, a);
        take(c, a, b);
      }
    };
    for_each_corner([&](std::uint32_t at, std::uint32_t, std::uint32_t) { begins_[at + 1] += 2; });
    for (std::size_t i = 1; i < begins_.size() && !looks.stopped(); ++i) begins_[i] += begins_[i - 1];
    if (cancel.stopped()) return;
    all_ = Zeroed<std::uint32_t>::unwritten(begins_.back());
    for_each_corner([&](std::uint32_t at, std::uint32_t one, std::uint32_t two) {
      std::uint32_t* const place = all_.data() + begins_[at] + counts_[at];
      place[0] = one;
      place[1] = two;
      counts_[at] += 2;
    });
  }

  /// Leaves each neighbor once, and of a vertex on the border those on it.
  void choose(std::size_t vertex, bool keeps_border) {
    std::uint32_t* const own = all_.data() + begins_[vertex];
    std::uint32_t* const end = own + counts_[vertex];
    std::sort(own, end);
    const auto each = [&](const auto& take) {
      for (std::uint32_t* run = own; run != end;) {
        std::uint32_t* const after = std::find_if(run, end, [&](std::uint32_t other) { return other != *run; });
        take(*run, after - run != 2);
        run = after;
      }
    };
    std::uint32_t borders = 0;
    each([&](std::uint32_t, bool on_border) { borders += on_border ? 1 : 0; });
    counts_[vertex] = 0;
    if (borders > 0 && (keeps_border || borders != 2)) return;
    std::uint32_t left = 0;
    each([&](std::uint32_t neighbor, bool on_border) {
      if (borders == 0 || on_border) own[left++] = neighbor;
    });
    counts_[vertex] = left;
  }

  std::vector<std::size_t> begins_;
  std::vector<std::uint32_t> counts_;
  Zeroed<std::uint32_t> all_;
};

/// One step of all vertices by a factor of the way to the middle of their neighbors.
void step(const Neighbors& neighbors, double factor, const Column<Point>& from, Column<Point>& to,
          const Cancel& cancel) {
  for_chunks(cancel, from.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const Vector place = to_vector(from[i]);
      const std::span<const std::uint32_t> around = neighbors.of(i);
      Vector way;
      for (const std::uint32_t neighbor : around) way = way + (to_vector(from[neighbor]) - place);
      to.set(i, around.empty() ? from[i] : to_point(place + (factor / static_cast<double>(around.size())) * way));
    }
  });
}

}  // namespace

Column<Point> smoothed_positions(const Mesh& mesh, const SmoothOptions& options, const Cancel& cancel) {
  const std::vector<std::uint32_t> labels = position_labels(mesh.positions, cancel);
  if (cancel.stopped()) return *mesh.positions;
  const Neighbors neighbors(mesh, labels, options.keeps_border, cancel);
  if (cancel.stopped()) return *mesh.positions;
  Column<Point> now = *mesh.positions, next(now.size());
  const double forward = longest_way * options.strength;
  const double backward = forward > 0 ? 1 / (pass_band - 1 / forward) : 0;
  for (std::size_t k = 0; k < options.iterations && !cancel.stopped(); ++k) {
    step(neighbors, forward, now, next, cancel);
    std::swap(now, next);
    if (!options.keeps_volume) continue;
    step(neighbors, backward, now, next, cancel);
    std::swap(now, next);
  }
  if (cancel.stopped()) return now;
  for (std::size_t i = 0; i < labels.size(); ++i) {
    if (labels[i] != i) now.set(i, now[labels[i]]);
  }
  return now;
}

}  // namespace dini
