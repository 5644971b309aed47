// Simplex noise as a number, and as a displacement.

#include "geometry/noise.h"

#include "geometry/chunks.h"
#include "geometry/normals.h"
#include "graph/node_builder.h"
#include "nodes/all.h"
#include "nodes/shapes.h"

namespace dini {

namespace {

struct NoiseInputs {
  double frequency;
  std::int64_t octaves;
  double roughness;
  std::int64_t seed;

  NoiseSettings settings() const {
    return {frequency, static_cast<int>(octaves), roughness, static_cast<std::uint64_t>(seed)};
  }
};

struct NoiseAtInputs : NoiseInputs {
  Point point;
};

std::tuple<double, Vector> noise_at(const NoiseAtInputs& in) {
  const Vector place = to_vector(in.point);
  return {layered_noise(place, in.settings()), layered_noise_vector(place, in.settings())};
}

struct RoughenInputs : NoiseInputs {
  double amplitude;
};

Point roughened_point(const Point& shape, const RoughenInputs& in) {
  const Vector place = to_vector(shape) + in.amplitude * layered_noise_vector(to_vector(shape), in.settings());
  return is_finite(place) ? to_point(place) : Point::at_infinity();
}

SharedMesh roughened_mesh(const Context& context, const SharedMesh& shape, const RoughenInputs& in) {
  // Normals that vertices at one place share: along the own ones of a box its faces would come apart.
  const Column<Vector> ways = smooth_normals(*shape, context.cancel());
  if (context.cancel().stopped()) return shape;
  const NoiseSettings settings = in.settings();
  Column<Point> positions(ways.size());
  for_chunks(context.cancel(), ways.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const Vector place = to_vector(shape->positions[i]);
      positions.set(i, to_point(place + in.amplitude * layered_noise(place, settings) * ways[i]));
    }
  });
  if (context.cancel().stopped()) return shape;
  const std::shared_ptr<Mesh> moved = with_positions(context, *shape, std::move(positions), Column<Vector>(ways));
  moved->normals = smooth_normals(*moved, context.cancel());
  return moved;
}

/// The inputs that both nodes have.
template <class In>
auto noise_inputs() {
  return [](auto builder) {
    return std::move(builder)
        .input("frequency", &In::frequency, "How fine: about so many bumps to a meter.",
               defaults(2).hard(0, 1e6).soft(0, 10).unit("1/m"))
        .input("octaves", &In::octaves, "Layers, each twice as fine as the one before it.",
               defaults(3).hard(1, 16).soft(1, 8))
        .input("roughness", &In::roughness, "How high each layer is against the one before it.",
               defaults(0.5).hard(0, 1))
        .input("seed", &In::seed, "Another seed, other noise.",
               defaults(1).hard(0, 9'007'199'254'740'991).soft(0, 100));
  };
}

}  // namespace

void add_noise(Registry& registry) {
  registry.add(
      node("noise", noise_at)
          .title("Noise")
          .family("fields")
          .synonyms({"perlin", "simplex", "turbulence", "random field", "fractal", "clouds"})
          .doc("Smooth seeded noise at a point: a number, and a vector of three more.")
          .source("Perlin, Noise hardware (2001); Gustavson, Simplex noise demystified (2005)")
          .details("The same on every machine. All values are between -1 and 1, and 0 on average. At points at "
                   "infinity, and farther than 1e12 bumps from the origin, there is no noise: 0.")
          .input("point", &NoiseAtInputs::point, "Where.", defaults({0, 0, 0}).unit("m").position_handle())
          .with(noise_inputs<NoiseAtInputs>())
          .cost([](const RunSize& size) {
            return RunCost{200 * static_cast<double>(integer_at(size.literals, "octaves")), 0};
          })
          .output("value", "A number from -1 to 1.")
          .output("vector", "Three numbers from -1 to 1, for moving things about."));

  registry.add(
      node("roughen", roughened_point, roughened_mesh)
          .title("Roughen")
          .family("fields")
          .synonyms({"noise", "displace", "bumps", "terrain", "rock", "organic", "jitter", "wobble"})
          .doc("Moves a mesh along its normals, or points about, by smooth seeded noise.")
          .source("Perlin, Noise hardware (2001); Gustavson, Simplex noise demystified (2005)")
          .details("Vertices of a mesh at one place move together, so that a closed mesh stays closed; normals "
                   "are computed anew, smooth. Nothing moves farther than the amplitude along its normal, a "
                   "point not farther along each axis. A mesh needs several vertices to a bump: subdivide it "
                   "first where it has not.")
          .input("shape", "Meshes or points.")
          .input("amplitude", &RoughenInputs::amplitude, "How far at most; below 0 hills are hollows.",
                 defaults(0.1).hard(-1e6, 1e6).soft(-1, 1).unit("m"))
          .with(noise_inputs<RoughenInputs>())
          .cost([](const RunSize& size) {
            const auto octaves = static_cast<double>(integer_at(size.literals, "octaves"));
            return RunCost{(300 + 60 * octaves) * size.vertices + 150 * octaves, 200 * size.vertices};
          })
          .output("shape", "The moved shape."));
}

}  // namespace dini
