#include "geometry/thicken.h"

#include <algorithm>

#include "geometry/border_strips.h"
#include "geometry/place_text.h"
#include "geometry/validate.h"
#include "graph/node_builder.h"
#include "nodes/all.h"
#include "nodes/mesh_reach.h"
#include "nodes/wall_shares.h"
#include "nodes/wall_side.h"

namespace dini {

namespace {

struct ThickenInputs : WallThickness {
  WallSide side;
  bool find_contact;
};

/// Two sheets, and strips with four vertices for a side of the border, of which there are at most as many as vertices;
/// in large meshes the strips have fewer.
std::size_t most_vertices_of_wall(const Literals&, std::size_t given) {
  return std::min(6 * given, 4 * given + 2 * few_strip_vertices);
}

Attempt<std::tuple<SharedMesh, double>> thickened(const Context& context, const SharedMesh& shape,
                                                  const ThickenInputs& in) {
  const auto thinnest = least_thickness(in, context.cancel());
  if (!thinnest) return thinnest.error();
  const double least = least_change(*shape, context.cancel());
  if (*thinnest < least) {
    return Failure{"out-of-range",
                   "the mesh reaches so far from the origin that its coordinates tell no wall below " +
                       short_text(least) + " m from none",
                   "thickness"};
  }
  const WallSurface surface = wall_surface(*shape, context.cancel());
  if (context.cancel().stopped()) return std::tuple(shape, 0.0);
  if (surface.fault) return Failure{"degenerate", "no wall can stand along this mesh: " + *surface.fault, "shape"};
  auto shares = shares_of_wall(in, surface, context.cancel());
  if (!shares) return shares.error();
  const double front = in.side == WallSide::inside ? 0 : in.side == WallSide::both ? 0.5 : 1;
  const Wall wall{front * in.thickness, (1 - front) * in.thickness, *std::move(shares)};
  auto mesh = std::make_shared<const Mesh>(wall_along(surface, wall, context.cancel()));
  if (context.cancel().stopped()) return std::tuple(shape, 0.0);
  if (!is_mesh_within_reach(*mesh, context.cancel())) {
    return Failure{"out-of-range", "the wall would reach beyond 1e18 m", "thickness"};
  }
  double fits = in.thickness;
  if (in.find_contact && !mesh->triangles.empty()) {
    if (const std::optional<WallContact> contact = contact_of(surface, wall, context.cancel())) {
      fits = contact->fits * in.thickness;
      const std::string there = "the wall meets itself near " + place_text(contact->place);
      context.warn({"self-contact",
                    there + (fits > 0 ? "; a thickness of " + short_text(fits) + " m would fit"
                                      : ", as the surface does without a wall"),
                    "thickness"});
    }
  }
  return std::tuple(SharedMesh(std::move(mesh)), fits);
}

}  // namespace

void add_thicken(Registry& registry) {
  registry.add(
      node("thicken", thickened)
          .title("Thicken")
          .family("meshes")
          .synonyms({"solidify", "shell", "wall", "thickness", "extrude", "hollow", "print"})
          .doc("A wall along a surface: a closed mesh that can be printed.")
          .details(
              "The surface, its parallel surface turned around, and strips that join them along borders. Each edge has "
              "two triangles, and V - E + F is twice that of the surface. Vertices at one position count as one. "
              "Smooth "
              "surfaces keep their normals; between flat faces the wall is as thick as it says. With a field the "
              "thickness goes smoothly to another one where the field grows; factors make it another one from place to "
              "place, linear between them. Where the wall meets itself a warning "
              "tells the place and what would fit. An edge with more than two triangles, or with two that run the same "
              "way, and borders that meet in one vertex, are errors. A mesh without triangles stays empty.")
          .input("shape", "The mesh.")
          .input("thickness", &ThickenInputs::thickness, "Of the wall.",
                 defaults(0.1).hard(1e-6, 1e6).soft(0.01, 0.5).unit("m"))
          .input(
              "factors", &ThickenInputs::factors,
              "Numbers over the mesh that the thickness is multiplied by, over one axis or two: the first runs along "
              "u of the mesh, as the rows of a surface do, the second along v. Without them the wall is even.",
              required().soft(0, 2))
          .input("side", &ThickenInputs::side,
                 "On which side of the surface the wall is; outside is where its normals point.", defaults("inside"))
          .input(
              "field", &ThickenInputs::field,
              "A solid in which the wall has its thickness; away from it the other one. Without it the wall is even.")
          .input("far_thickness", &ThickenInputs::far_thickness, "Of the wall beyond the fade of the field.",
                 defaults(0.2).hard(1e-6, 1e6).soft(0.01, 0.5).unit("m"))
          .input("fade", &ThickenInputs::fade, "Distance from the solid within which one goes into the other.",
                 defaults(1).hard(1e-6, 1e6).soft(0.1, 4).unit("m"))
          .input("find_contact", &ThickenInputs::find_contact, "Whether to look where the wall meets itself.",
                 defaults(true))
          .consumed_axis("over", "The axis of factors along u; empty means the last that along leaves.")
          .consumed_axis("along", "The axis of factors along v; empty means the last of two.")
          .vertex_factor([](const Literals&) { return std::size_t{2}; })
          .most_of_given(most_vertices_of_wall)
          .cost([](const RunSize& size) {
            return RunCost{12'000 * size.given_vertices, 900 * size.given_vertices, 104 * size.given_vertices};
          })
          .output("shape", "The wall.")
          .output("fits", "The greatest thickness up to the asked one at which the wall does not meet itself."));
}

}  // namespace dini
