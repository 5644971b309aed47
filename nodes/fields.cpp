#include <algorithm>

#include "geometry/chunks.h"
#include "geometry/field_warp.h"
#include "geometry/normals.h"
#include "nodes/all.h"
#include "nodes/costs.h"
#include "nodes/moved_field.h"
#include "nodes/shapes.h"
#include "nodes/warp_inputs.h"

namespace dini {

namespace {

/// True for a generator that sits nowhere: a pure direction moves everything alike.
bool is_direction(const Generator& generator) {
  return generator.no_e == Vector{} && generator.e_e == Vector{} && generator.no_ni == 0;
}

}  // namespace

Attempt<std::vector<kernels::WarpSource>> sources_of(const Context& context, const Block<Generator, 1>& generators) {
  std::vector<kernels::WarpSource> sources;
  sources.reserve(generators.size());
  CancelEvery steps(context.cancel());
  for (std::size_t i = 0; i < generators.size() && !steps.stopped(); ++i) {
    const Generator generator = generators(i);
    if (generator == Generator{}) continue;
    const kernels::WarpSource source = kernels::warp_source(generator);
    if (is_direction(generator) || !is_finite(source.position)) {
      return Failure{"degenerate",
                     "generator " + std::to_string(i) + " sits nowhere, so no distance to it can be measured",
                     "generators"};
    }
    sources.push_back(source);
  }
  return sources;
}

namespace {

/// Moves points by a field, in chunks that are the smaller the more generators there are.
void warp_chunks(const Context& context, const kernels::WarpField& field, const kernels::WarpSettings& settings,
                 kernels::ConstPoints in, kernels::Points out, std::size_t count) {
  constexpr std::size_t pairs_in_chunk = std::size_t{1} << 20, least_points = 16;
  const std::size_t sources = std::max<std::size_t>(1, field.sources().size());
  const std::size_t chunk = std::clamp(pairs_in_chunk / sources, least_points, usual_chunk);
  for_chunks(context.cancel(), count, chunk, [&](std::size_t begin, std::size_t end) {
    kernels::warp_points(field, settings, {in.x + begin, in.y + begin, in.z + begin},
                         {out.x + begin, out.y + begin, out.z + begin}, end - begin, context.cancel().for_kernels());
  });
}

struct WarpInputs : kernels::WarpSettings {
  Block<Generator, 1> generators;
};

std::optional<Failure> warp_points(const Context& context, const Batch<Point>& shape, const WarpInputs& in,
                                   BatchOut<Point> out) {
  const Attempt<std::vector<kernels::WarpSource>> sources = sources_of(context, in.generators);
  if (!sources) return sources.error();
  const kernels::WarpField field(*sources, context.cancel().for_kernels());
  std::vector<double> storage;
  warp_chunks(context, field, in, spread(shape, out.size, storage), components(out), out.size);
  return std::nullopt;
}

Attempt<SharedMesh> warp_mesh(const Context& context, const SharedMesh& shape, const WarpInputs& in) {
  const Attempt<std::vector<kernels::WarpSource>> sources = sources_of(context, in.generators);
  if (!sources) return sources.error();
  const kernels::WarpField field(*sources, context.cancel().for_kernels());
  Column<Point> positions(shape->positions.size());
  warp_chunks(context, field, in, components(shape->positions, 0), components(positions, 0), positions.size());
  // A warp is not conformal, so normals are made anew from the warped faces.
  const std::shared_ptr<Mesh> warped = with_positions(context, *shape, std::move(positions), {});
  if (!context.cancel().stopped()) warped->normals = smooth_normals(*warped, context.cancel());
  return SharedMesh(warped);
}

Attempt<SharedField> warp_field(const Context& context, const SharedField& shape, const WarpInputs& in) {
  if (in.method != kernels::WarpMethod::sum_generators || in.rule != Rule::exact) {
    return Failure{"degenerate", "fields are warped by one exact rotor: method sum_generators, rule exact", "method"};
  }
  Attempt<std::vector<kernels::WarpSource>> sources = sources_of(context, in.generators);
  if (!sources) return sources.error();
  FieldSize size = shape->size();
  size.operations += sources->size();
  // Before there are as many again.
  if (std::optional<std::string> fault = too_large(size)) return Failure{"limit-exceeded", *fault, "generators"};
  return accepted(warped_field(shape, *std::move(sources), in.strength, in.power, in.softening), "generators");
}

/// Of every point with every generator. Whole powers and null pairs are quicker, but that shows only when they come.
RunCost cost_of_warp(const RunSize& size) {
  const auto sources = static_cast<double>(size.consumed.front().size);
  const double pair_work = text_at(size.literals, "method") == "sum_displacements" ? 10 : 4;
  const double points = std::max(1.0, size.vertices);
  // A field keeps its sources, and a tree over them.
  return {sources * (pair_work * points + 50) + 300 * size.vertices, source_bytes * sources + 80 * size.vertices,
          200 * sources * size.fields};
}

}  // namespace

void add_fields(Registry& registry) {
  registry.add(
      node("warp", warp_points, warp_mesh, warp_field)
          .title("Warp")
          .family("fields")
          .synonyms({"deform", "bend", "displace", "field", "distort", "attract", "magnet", "sculpt"})
          .doc("Moves every point by all generators together, each weighted by its distance.")
          .source("Boosted Surfaces, eqs. (13), (16)")
          .details("Weight 1 / (d^power + softening), rotor exp(strength * weighted sum). With power 2 and no "
                   "softening the effect does not fade with distance and has a pole near each generator. A field is "
                   "pulled back at each place by the opposite of the rotor there, so its weights are those at the "
                   "place that is reached; its values are scaled by the rotor's conformal factor.")
          .degenerate("point at a generator",
                      "With softening 0 the point stays, whatever the other generators do; where displacements are "
                      "summed, that generator moves it nowhere and the others do.")
          .degenerate("zero direction",
                      "A zero generator does nothing, wherever it sits; a pure direction sits nowhere and is an error.")
          .degenerate("coincident points", "Generators at one place act as their sum.")
          .degenerate("isoclinic generators",
                      "The two equal turns have a closed form of their own; nothing is divided by their difference.")
          .input("shape", "Points, meshes or fields.")
          .input("generators", &WarpInputs::generators, "Links to one or several, or one family of them.",
                 required().several())
          .consumed_axis("over", "The axis to sum over; empty means the last of generators.")
          .with(warp_settings<WarpInputs>(1, 2, "Power of the distance."))
          .cost(cost_of_warp)
          .output("shape", "The warped shape."));
}

}  // namespace dini
