// Networks of weighted points that carry one another.

#include <algorithm>
#include <map>
#include <set>

#include "geometry/network.h"
#include "geometry/point_tree.h"
#include "graph/kept_axes.h"
#include "graph/node_builder.h"
#include "nodes/all.h"
#include "nodes/links.h"

namespace dini {

/// Which points of a network are neighbors.
enum class NeighborKind { nearest, all, chain, links };

template <>
struct ChoiceNames<NeighborKind> {
  static constexpr std::array<std::string_view, 4> names = {"nearest", "all", "chain", "links"};
};

namespace {

struct EvolveInputs : kernels::NetworkSettings {
  Block<Point, 1> points;
  Block<double, 1> weights;
  std::int64_t steps;
  NeighborKind neighbors;
  std::int64_t count;
  std::string links;
};

/// What links say, each pair once whichever way round and however often it is written. A point is no neighbor of
/// itself.
Links different_links(const std::string& text) {
  Links different;
  std::set<std::pair<std::uint32_t, std::uint32_t>> seen;
  for (const auto& [first, second] : read_links(text).value_or(Links{})) {
    if (first != second && seen.insert(std::minmax({first, second})).second) different.push_back({first, second});
  }
  return different;
}

/// How many neighbors the point has that has most of them.
std::size_t most_links(const std::string& text) {
  std::map<std::uint32_t, std::size_t> counts;
  std::size_t most = 0;
  for (const auto& [first, second] : different_links(text)) most = std::max({most, ++counts[first], ++counts[second]});
  return most;
}

Attempt<NeighborTable> table_of_links(const std::string& text, std::size_t size) {
  std::vector<std::vector<std::uint32_t>> found(size);
  for (const auto& [first, second] : read_links(text).value_or(Links{})) {
    if (std::max(first, second) < size) continue;
    return Failure{"out-of-range",
                   "the link " + std::to_string(first) + "-" + std::to_string(second) + " names a point of " +
                       std::to_string(size) + ", which count from 0",
                   "links"};
  }
  for (const auto& [first, second] : different_links(text)) {
    found[first].push_back(second);
    found[second].push_back(first);
  }
  std::size_t most = 0;
  for (const auto& neighbors : found) most = std::max(most, neighbors.size());
  if (most > PointTree::most_neighbors) {
    return Failure{"out-of-range",
                   "a point has " + std::to_string(most) + " links, at most " +
                       std::to_string(PointTree::most_neighbors) + " are accepted",
                   "links"};
  }
  NeighborTable table(size, most);
  for (std::size_t i = 0; i < size; ++i) {
    for (std::size_t m = 0; m < found[i].size(); ++m) table.indices[m * size + i] = found[i][m];
  }
  return table;
}

/// The neighbors that are the same at every step; nothing in the table for those that are found anew.
Attempt<NeighborTable> lasting_neighbors(const EvolveInputs& in) {
  const std::size_t size = in.points.size();
  switch (in.neighbors) {
    case NeighborKind::chain:
      return chain_of(size, in.points.axis().closed);
    case NeighborKind::links:
      return table_of_links(in.links, size);
    default:
      return NeighborTable(size, in.neighbors == NeighborKind::nearest ? static_cast<std::size_t>(in.count) : 0);
  }
}

NeighborSearch search_of(NeighborKind kind) {
  if (kind == NeighborKind::nearest) return NeighborSearch::nearest;
  return kind == NeighborKind::all ? NeighborSearch::all : NeighborSearch::table;
}

Attempt<Made<Point>> evolved(const Context& context, const EvolveInputs& in) {
  const std::size_t size = in.points.size();
  Attempt<NeighborTable> table = lasting_neighbors(in);
  if (!table) return table.error();
  Column<Point> start(size);
  std::vector<double> weights(size);
  CancelEvery looks(context.cancel());
  for (std::size_t i = 0; i < size && !looks.stopped(); ++i) {
    const Point point = in.points(i);
    if (!is_finite(point)) {
      return Failure{"degenerate", "point " + std::to_string(i) + " is at infinity, where it has no neighbors",
                     "points"};
    }
    start.set(i, point);
    weights[i] = in.weights(i);
  }
  return Made<Point>{evolve(start, weights, in, search_of(in.neighbors), *std::move(table),
                            static_cast<std::size_t>(in.steps), context.cancel())};
}

RunCost cost_of_evolve(const RunSize& size) {
  const auto points = static_cast<double>(size.consumed.front().size);
  const std::string& kind = text_at(size.literals, "neighbors");
  const auto count = static_cast<double>(integer_at(size.literals, "count"));
  const auto linked = static_cast<double>(kind == "links" ? most_links(text_at(size.literals, "links")) : 0);
  const double neighbors = kind == "all" ? points : kind == "nearest" ? count : kind == "links" ? linked : 2;
  const double search = kind == "nearest" ? 400 + 60 * count : 0;
  // All points have as much room in the table as the one that has most neighbors; links are lists of their own before.
  const double table = kind == "all" ? 0 : 4 * neighbors + (kind == "links" ? 64 : 0);
  return {size.values * (60 + search + 6 * neighbors), points * (120 + table)};
}

std::vector<Axes> axes_of_evolve(const Literals& literals, const std::string& id) {
  std::vector<Axes> axes = one_axis("steps", "axis")(literals, id);
  axes.front().push_back(kept_axes());
  return axes;
}

}  // namespace

void add_evolve(Registry& registry) {
  using In = EvolveInputs;
  registry.add(
      node("evolve", evolved)
          .title("Evolve")
          .family("fields")
          .synonyms({"simulation", "swarm", "growth", "particles", "network", "coral", "relax"})
          .doc("A network of weighted points, step by step: each is carried by the products with its neighbors.")
          .source("Boosted Surfaces, section 7, eqs. (19), (20)")
          .details(
              "The product of two points, seen from the middle between them, moves a point towards its neighbor when "
              "its own weight is below 1 and away from it above 1; at 1 it rests, being a pole of the pair. One "
              "rotor, exp(strength * sum of products), carries each point, all at once. A product is weighted by "
              "1 / (d^power + softening), d the distance, and by 1 - (rest / d)^2: points nearer than rest act the "
              "other way. Without damping a point goes on as it went. No step is longer than longest_step, and no "
              "point leaves the ball of the given center and radius. The first row is what is given. Nearest "
              "neighbors are found anew at each step.")
          .degenerate("coincident points", "Points at one place do nothing to one another.")
          .degenerate("w = -1", "A weight as any other: the point is drawn twice as fast as with weight 0.")
          .input("points", &In::points, "The points, over one axis.", required().title("Points"))
          .input("weights", &In::weights, "One weight of the no coefficient for all, or one for each point.",
                 defaults(0).hard(-1e6, 1e6).soft(-1, 3).title("Weights"))
          .input("steps", &In::steps, "How many rows there are, the first one included.",
                 defaults(60).hard(1, 100'000).soft(2, 200).title("Steps"))
          .input("neighbors", &In::neighbors,
                 "The nearest points, all points, those before and behind along the axis, or what links says.",
                 defaults("nearest").title("Neighbors"))
          .input("count", &In::count, "How many of the nearest.", defaults(6).hard(1, 64).soft(1, 16).title("How many"))
          .input("links", &In::links, "Pairs of points that are neighbors, by number from 0: 0-1 1-2.",
                 defaults("").title("Links").read_by("invalid-links", fault_of_links))
          .input("strength", &In::strength, "Factor of the products.",
                 defaults(0.2).hard(-1e6, 1e6).soft(-1, 1).title("Strength"))
          .input("power", &In::power, "Power of the distance.",
                 defaults(2).hard(0, 16).soft(0, 4).title("Falloff power"))
          .input("softening", &In::softening, "Added to the power of the distance.",
                 defaults(0.1).hard(0, 1e9).soft(0, 2).title("Softening"))
          .input("rest", &In::rest, "The distance at which neighbors leave one another alone.",
                 defaults(0).hard(0, 1e6).soft(0, 1).unit("m").title("Rest distance"))
          .input("damping", &In::damping, "How much of its last step a point loses: 1 all of it.",
                 defaults(1).hard(0, 1).soft(0, 1).title("Damping"))
          .input("longest_step", &In::longest_step, "The longest way of a point in one step.",
                 defaults(0.1).hard(0, 1e6).soft(0, 1).unit("m").title("Longest step"))
          .input("center", &In::center, "Middle of the ball that no point leaves.",
                 defaults({0, 0, 0}).unit("m").title("Center of the bound").position_handle())
          .input("radius", &In::radius, "Radius of that ball.",
                 defaults(100).hard(1e-6, 1e6).soft(1, 100).unit("m").title("Bound").radius_handle("center"))
          .consumed_axis("over", "The axis of the points; empty means the last.")
          .made_axis("axis", "Name of the axis of the steps; empty means the id of this node.")
          .axes(axes_of_evolve)
          .cost(cost_of_evolve)
          .output("points", "The points, over the steps and their own axis."));
}

}  // namespace dini
