#include "draco/vertex_order.h"

#include "draco/triangle_walk.h"

namespace dini {
namespace {

class Traversal {
 public:
  explicit Traversal(const CornerTable& table)
      : table_(table), triangles_(table.triangles()), position_(table.vertices(), absent) {
    order_.vertices.reserve(table.vertices());
    order_.parallelograms.reserve(table.vertices());
  }

  void from(Corner start) {
    if (triangles_.is_done(start)) return;
    visit(next(start));
    visit(previous(start));
    triangles_.from(start, [this](Corner corner) { follow(corner); });
  }

  VertexOrder take() { return std::move(order_); }

 private:
  void follow(Corner corner) {
    while (true) {
      triangles_.mark(corner);
      const Corner right = table_.right(corner);
      const Corner left = table_.left(corner);
      if (visit(corner) && !table_.on_boundary(table_.vertex(corner))) {
        corner = right;
        continue;
      }
      const bool right_is_done = triangles_.is_done(right);
      const bool left_is_done = triangles_.is_done(left);
      if (right_is_done && left_is_done) return triangles_.end();
      if (!right_is_done && !left_is_done) return triangles_.split(left, right);
      corner = right_is_done ? left : right;
    }
  }

  // True when the vertex was not met before.
  bool visit(Corner corner) {
    const std::uint32_t vertex = table_.vertex(corner);
    if (position_[vertex] != absent) return false;
    const Parallelogram parallelogram = prediction(corner);
    position_[vertex] = static_cast<std::uint32_t>(order_.vertices.size());
    order_.vertices.push_back(vertex);
    order_.parallelograms.push_back(parallelogram);
    return true;
  }

  Parallelogram prediction(Corner corner) const {
    const Corner opposite = table_.opposite(corner);
    if (opposite != absent) {
      const Parallelogram result = {table_.vertex(next(opposite)), table_.vertex(previous(opposite)),
                                    table_.vertex(opposite)};
      const auto known = [this](std::uint32_t vertex) { return position_[vertex] != absent; };
      if (known(result.after) && known(result.before) && known(result.across)) return result;
    }
    const std::uint32_t last = order_.vertices.empty() ? table_.vertex(corner) : order_.vertices.back();
    return {last, last, last};
  }

  const CornerTable& table_;
  TriangleWalk triangles_;
  std::vector<std::uint32_t> position_;
  VertexOrder order_;
};

}  // namespace

VertexOrder vertex_order(const CornerTable& table, const Edgebreaker& walk) {
  Traversal traversal(table);
  for (auto corner = walk.corners.rbegin(); corner != walk.corners.rend(); ++corner) traversal.from(*corner);
  for (const Corner corner : walk.closing) traversal.from(corner);
  return traversal.take();
}

}  // namespace dini
