#include "geometry/normals.h"
#include "graph/node_builder.h"
#include "nodes/all.h"
#include "nodes/choices.h"
#include "nodes/shapes.h"
#include "nodes/sources.h"

namespace dini {

namespace {

/// True for a generator that sits nowhere: a pure direction moves everything alike.
bool is_direction(const Generator& generator) {
  return generator.no_e == Vector{} && generator.e_e == Vector{} && generator.no_ni == 0;
}

}  // namespace

Attempt<std::vector<kernels::WarpSource>> sources_of(const Block<Generator, 1>& generators) {
  std::vector<kernels::WarpSource> sources;
  for (std::size_t i = 0; i < generators.size(); ++i) {
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

std::optional<Failure> warp_point_batch(Batch<Point> shape, const Block<Generator, 1>& generators, const std::string&,
                                        double strength, double power, double softening, Rule rule,
                                        kernels::WarpMethod method, BatchOut<Point> out) {
  const Attempt<std::vector<kernels::WarpSource>> sources = sources_of(generators);
  if (const auto* failure = std::get_if<Failure>(&sources)) return *failure;
  std::vector<double> storage;
  kernels::warp_points(std::get<0>(sources), {strength, power, softening, rule, method},
                       spread(shape, out.size, storage), components(out), out.size);
  return std::nullopt;
}

Attempt<SharedMesh> warp_mesh(const Context& context, const SharedMesh& shape, const Block<Generator, 1>& generators,
                              const std::string&, double strength, double power, double softening, Rule rule,
                              kernels::WarpMethod method) {
  const Attempt<std::vector<kernels::WarpSource>> sources = sources_of(generators);
  if (const auto* failure = std::get_if<Failure>(&sources)) return *failure;
  Column<Point> positions(shape->positions.size());
  for_chunks(context, positions.size(), [&](std::size_t begin, std::size_t end) {
    kernels::warp_points(std::get<0>(sources), {strength, power, softening, rule, method},
                         components(shape->positions, begin), components(positions, begin), end - begin);
  });
  // A warp is not conformal, so normals are made anew from the warped faces.
  const SharedMesh warped = with_positions(context, *shape, std::move(positions), {});
  if (context.cancel().stopped()) return warped;
  auto finished = std::make_shared<Mesh>(*warped);
  finished->normals = smooth_normals(*finished, context.cancel());
  return SharedMesh(finished);
}

}  // namespace

void add_fields(Registry& registry) {
  registry.add(
      node("warp", warp_point_batch, warp_mesh)
          .title("Warp")
          .family("fields")
          .doc("Moves every point by all generators together, each weighted by its distance.")
          .source("Boosted Surfaces, eqs. (13), (16)")
          .details("Weight 1 / (d^power + softening), rotor exp(strength * weighted sum). With power 2 and no "
                   "softening the effect does not fade with distance and has a pole near each generator.")
          .degenerate("point at a generator",
                      "With softening 0 the point stays, whatever the other generators do; where displacements are "
                      "summed, that generator moves it nowhere and the others do.")
          .degenerate("zero direction",
                      "A zero generator does nothing, wherever it sits; a pure direction sits nowhere and is an error.")
          .degenerate("coincident points", "Generators at one place act as their sum.")
          .degenerate("isoclinic generators",
                      "The two equal turns have a closed form of their own; nothing is divided by their difference.")
          .input("shape", "Points or meshes.")
          .input("generators", "Links to one or several, or one family of them.", required().several())
          .input("over", "The axis to sum over; empty means the last of generators.", defaults("").names_axis())
          .input("strength", "Factor of the sum.", defaults(1).hard(-1e9, 1e9).soft(-2, 2))
          .input("power", "Power of the distance.", defaults(2).hard(0, 16).soft(0, 4))
          .input("softening", "Added to the power of the distance.", defaults(0).hard(0, 1e9).soft(0, 2))
          .input("rule", "The true exponential, or the paper's with the scalar part of the square only.",
                 defaults("exact"))
          .input("method", "One rotor from the summed generators, or the sum of what each would do alone.",
                 defaults("sum_generators"))
          .over({"over"})
          .output("shape", "The warped shape."));
}

}  // namespace dini
