#include "geometry/cap.h"

#include <algorithm>

#include "geometry/validate.h"
#include "graph/node_builder.h"
#include "nodes/all.h"
#include "nodes/mesh_reach.h"

namespace dini {

template <>
struct ChoiceNames<CapKind> {
  static constexpr std::array<std::string_view, 2> names = {"flat", "dome"};
};

namespace {

/// Caps that add no more than this are never refused.
constexpr double few_cap_vertices = 16'384;

struct CapInputs {
  CapKind kind;
  std::int64_t rings;
};

Attempt<std::tuple<SharedMesh, double>> closed_by_caps(const Context& context, const SharedMesh& shape,
                                                       const CapInputs& in) {
  // Flat caps have at most a third more vertices than a border, so they are never too large.
  const std::size_t vertices = shape->positions.size() * (in.kind == CapKind::flat ? 2 : 1);
  const std::size_t most = std::max(vertices, static_cast<std::size_t>(few_cap_vertices));
  CappedMesh result = capped(*shape, {in.kind, static_cast<std::size_t>(in.rings), most}, context.cancel());
  if (context.cancel().stopped()) return std::tuple(shape, 0.0);
  if (result.fault) return Failure{"degenerate", "no cap can close this mesh: " + *result.fault, "shape"};
  if (result.too_large) {
    return Failure{"limit-exceeded",
                   "the caps would have more than " + std::to_string(most) + " vertices; take fewer rings", "rings"};
  }
  if (result.caps == 0) return std::tuple(shape, 0.0);
  if (!is_mesh_within_reach(result.mesh, context.cancel())) {
    return Failure{"out-of-range", "a cap would reach beyond 1e18 m", "shape"};
  }
  return std::tuple(SharedMesh(std::make_shared<const Mesh>(std::move(result.mesh))), static_cast<double>(result.caps));
}

/// All that a mesh may get: a vertex for each of its border's, and one for a cap; a dome has as many rings as are not
/// refused.
std::size_t most_vertices_of_capped(const Literals& literals, std::size_t given) {
  if (text_at(literals, "kind") != "dome") return 3 * given;
  const auto rings = static_cast<std::size_t>(integer_at(literals, "rings"));
  return given + std::min((rings + 1) * given, given + static_cast<std::size_t>(few_cap_vertices));
}

/// A flat cap has a vertex for each of its border's and one more, which is little beside a mesh that is not nearly all
/// border, and a mesh without borders is passed on as it is; a dome has its rings of them.
RunCost cost_of_cap(const RunSize& size) {
  RunCost cost{400 * size.given_vertices, 360 * size.given_vertices, -30 * size.given_vertices};
  if (text_at(size.literals, "kind") == "dome") {
    const auto rings = static_cast<double>(integer_at(size.literals, "rings"));
    const double most = std::min((rings + 1) * size.given_vertices, std::max(size.given_vertices, few_cap_vertices));
    cost.kept_bytes = 104 * most;
  }
  return cost;
}

}  // namespace

void add_cap(Registry& registry) {
  registry.add(
      node("cap", closed_by_caps)
          .title("Cap")
          .family("meshes")
          .synonyms({"close", "fill hole", "lid", "end cap", "watertight"})
          .doc("Closes the borders of a mesh, flat or with domes.")
          .details(
              "A flat cap is a fan about the middle of its border; a border that is not seen whole from there is cut "
              "into ears, one that is not flat gets a cap as flat as it can be. A dome goes on from the surface as it "
              "comes: along circles that are tangent to it and meet in one apex, so that on a round border it is a "
              "part of a sphere. Vertices at one position count as one. A mesh without borders stays as it is. An edge "
              "with more than two triangles, or with two that run the same way, and borders that meet in one vertex, "
              "are errors.")
          .input("shape", "The mesh.")
          .input("kind", &CapInputs::kind, "What closes a border.", defaults("flat"))
          .input("rings", &CapInputs::rings, "Rings of triangles from the border to the apex of a dome.",
                 defaults(8).hard(1, 256).soft(2, 32))
          .most_of_given(most_vertices_of_capped)
          .cost(cost_of_cap)
          .output("shape", "The mesh with its caps.")
          .output("caps", "How many borders were closed."));
}

}  // namespace dini
