#include "geometry/tube.h"

#include <algorithm>

#include "geometry/angle.h"
#include "geometry/clip.h"
#include "geometry/frames.h"
#include "geometry/tiles.h"

namespace dini {

namespace {

/// Writes the tubes of pieces one after another into one mesh that has room for all of them.
class TubeWriter {
 public:
  TubeWriter(const TubeOptions& options, std::size_t sides, std::size_t vertices, const Cancel& cancel)
      : radius_(options.radius), sides_(sides), capped_(options.capped), cancel_(cancel) {
    mesh_.positions = Column<Point>(vertices);
    mesh_.normals = Column<Vector>(vertices);
    mesh_.uvs.reserve(vertices);
    mesh_.triangles.reserve(2 * vertices);
    for (std::size_t side = 0; side < sides; ++side) {
      around_.push_back(sine_cosine(static_cast<double>(side) / static_cast<double>(sides)));
    }
  }

  static std::size_t vertices_of(const CurvePiece& piece, std::size_t sides, bool capped) {
    return piece.points.size() * sides + (piece.closed || !capped ? 0 : 2 * (sides + 1));
  }

  void add(const CurvePiece& piece) {
    double total = 0;
    const std::vector<Frame> frames = frames_along(piece, total, cancel_);
    if (cancel_.stopped()) return;
    const std::size_t base = mesh_.uvs.size();
    CancelEvery looks(cancel_);
    for (const Frame& frame : frames) {
      for (std::size_t side = 0; side < sides_; ++side) {
        if (looks.stopped()) return;
        const Vector normal = direction(frame, side);
        add_vertex(frame.position + radius_ * normal, normal, frame.along / total, coordinate(side));
      }
    }
    const bool capped = capped_ && !piece.closed;
    const std::size_t stations = frames.size();
    const std::size_t steps = piece.closed ? stations : stations - 1;
    for_each_tile(steps, sides_,
                  [&](std::size_t row_begin, std::size_t row_end, std::size_t side_begin, std::size_t side_end) {
                    if (capped && row_begin == 0 && side_begin == 0) add_cap(frames.front(), 0);
                    for (std::size_t row = row_begin; row < row_end; ++row) {
                      for (std::size_t side = side_begin; side < side_end; ++side) {
                        const std::size_t next = (side + 1) % sides_;
                        const std::size_t here = base + row * sides_;
                        const std::size_t there = base + (row + 1) % stations * sides_;
                        add_triangle(here + side, here + next, there + next);
                        add_triangle(here + side, there + next, there + side);
                      }
                    }
                    if (capped && row_end == steps && side_end == sides_) add_cap(frames.back(), 1);
                    mesh_.tile_ends.push_back(mesh_.triangles.size());
                    return !cancel_.stopped();
                  });
  }

  Mesh take() { return std::move(mesh_); }

 private:
  Vector direction(const Frame& frame, std::size_t side) const {
    return normalized(around_[side].cosine * frame.across + around_[side].sine * cross(frame.tangent, frame.across));
  }

  double coordinate(std::size_t side) const { return static_cast<double>(side) / static_cast<double>(sides_); }

  /// A flat fan at the start (u = 0) or the end (u = 1) of a piece.
  void add_cap(const Frame& frame, double u) {
    const Vector normal = u == 0 ? -frame.tangent : frame.tangent;
    const std::size_t center = mesh_.uvs.size();
    add_vertex(frame.position, normal, u, 0.5);
    for (std::size_t side = 0; side < sides_; ++side) {
      add_vertex(frame.position + radius_ * direction(frame, side), normal, u, coordinate(side));
    }
    for (std::size_t side = 0; side < sides_; ++side) {
      const std::size_t a = center + 1 + side;
      const std::size_t b = center + 1 + (side + 1) % sides_;
      add_triangle(center, u == 0 ? b : a, u == 0 ? a : b);
    }
  }

  void add_vertex(const Vector& position, const Vector& normal, double u, double v) {
    const std::size_t index = mesh_.uvs.size();
    mesh_.positions.set(index, to_point(position));
    mesh_.normals.set(index, normal);
    mesh_.uvs.push_back({u, v});
  }

  void add_triangle(std::size_t a, std::size_t b, std::size_t c) {
    mesh_.triangles.push_back(
        {static_cast<std::uint32_t>(a), static_cast<std::uint32_t>(b), static_cast<std::uint32_t>(c)});
  }

  double radius_;
  std::size_t sides_;
  bool capped_;
  const Cancel& cancel_;
  std::vector<SineCosine> around_;
  Mesh mesh_;
};

}  // namespace

Mesh tube(const Polyline& curve, const TubeOptions& options, const Cancel& cancel) {
  if (!(options.radius > 0 && options.radius <= largest_clip_radius)) return {};
  const std::size_t sides = std::max<std::size_t>(options.sides, 3);
  const std::vector<CurvePiece> pieces = curve_pieces(curve, options.clip_radius, cancel);
  std::size_t vertices = 0;
  for (const CurvePiece& piece : pieces) vertices += TubeWriter::vertices_of(piece, sides, options.capped);
  TubeWriter writer(options, sides, vertices, cancel);
  for (const CurvePiece& piece : pieces) {
    writer.add(piece);
    if (cancel.stopped()) return {};
  }
  return writer.take();
}

}  // namespace dini
