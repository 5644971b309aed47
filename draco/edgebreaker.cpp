#include "draco/edgebreaker.h"

#include "draco/triangle_walk.h"

namespace dini {
namespace {

class Walk {
 public:
  explicit Walk(const CornerTable& table)
      : table_(table),
        triangles_(table.triangles()),
        vertex_done_(table.vertices(), false),
        split_symbol_(table.triangles(), absent) {}

  Edgebreaker all() {
    result_.symbols.reserve(table_.triangles());
    result_.corners.reserve(table_.triangles());
    for (Corner corner = 0; corner < table_.corners(); corner += 3) {
      if (!triangles_.is_done(corner)) begin_piece(corner);
    }
    return std::move(result_);
  }

 private:
  // A walk begins at a boundary if the first triangle of the piece touches one, else beside a triangle without a
  // symbol.
  void begin_piece(Corner first) {
    for (Corner corner = first; corner < first + 3; ++corner) {
      const Corner start = boundary_gate(corner);
      if (start == absent) continue;
      result_.closed.push_back(false);
      return walk(start);
    }
    result_.closed.push_back(true);
    result_.closing.push_back(next(first));
    triangles_.mark(first);
    for (Corner corner = first; corner < first + 3; ++corner) vertex_done_[table_.vertex(corner)] = true;
    walk(table_.opposite(next(first)));
  }

  // The corner that faces a boundary edge at the vertex of `corner`, or its own edge; absent when there is none.
  Corner boundary_gate(Corner corner) const {
    if (table_.opposite(corner) == absent) return corner;
    if (!table_.on_boundary(table_.vertex(corner))) return absent;
    for (Corner across = table_.left(corner);; across = table_.left(corner)) {
      if (across == absent) return previous(corner);
      corner = previous(across);
    }
  }

  void walk(Corner start) {
    triangles_.from(start, [this](Corner corner) { walk_branch(corner); });
  }

  void walk_branch(Corner corner) {
    while (true) {
      triangles_.mark(corner);
      result_.corners.push_back(corner);
      const std::uint32_t tip = table_.vertex(corner);
      const Corner right = table_.right(corner);
      const Corner left = table_.left(corner);
      if (!vertex_done_[tip] && !table_.on_boundary(tip)) {
        vertex_done_[tip] = true;
        result_.symbols.push_back(Symbol::c);
        corner = right;
        continue;
      }
      const bool right_is_done = triangles_.is_done(right);
      const bool left_is_done = triangles_.is_done(left);
      if (right_is_done) note_split(right, true);
      if (left_is_done) note_split(left, false);
      if (right_is_done && left_is_done) {
        result_.symbols.push_back(Symbol::e);
        return triangles_.end();
      }
      if (!right_is_done && !left_is_done) {
        split_symbol_[corner / 3] = static_cast<std::uint32_t>(result_.symbols.size());
        result_.symbols.push_back(Symbol::s);
        ++result_.split_symbols;
        return triangles_.split(left, right);
      }
      result_.symbols.push_back(right_is_done ? Symbol::r : Symbol::l);
      corner = right_is_done ? left : right;
    }
  }

  void note_split(Corner neighbor, bool right) {
    if (neighbor == absent || split_symbol_[neighbor / 3] == absent) return;
    result_.splits.push_back({static_cast<std::uint32_t>(result_.symbols.size()), split_symbol_[neighbor / 3], right});
  }

  const CornerTable& table_;
  TriangleWalk triangles_;
  std::vector<bool> vertex_done_;
  std::vector<std::uint32_t> split_symbol_;
  Edgebreaker result_;
};

}  // namespace

Edgebreaker edgebreaker(const CornerTable& table) { return Walk(table).all(); }

}  // namespace dini
