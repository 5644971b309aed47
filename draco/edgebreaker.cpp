#include "draco/edgebreaker.h"

namespace dini {
namespace {

class Walk {
 public:
  explicit Walk(const CornerTable& table)
      : table_(table),
        triangle_done_(table.triangles(), false),
        vertex_done_(table.vertices(), false),
        split_symbol_(table.triangles(), absent) {}

  Edgebreaker all() {
    result_.symbols.reserve(table_.triangles());
    result_.corners.reserve(table_.triangles());
    for (Corner corner = 0; corner < table_.corners(); corner += 3) {
      if (!triangle_done_[corner / 3]) begin_piece(corner);
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
    triangle_done_[first / 3] = true;
    for (Corner corner = first; corner < first + 3; ++corner) vertex_done_[table_.vertex(corner)] = true;
    const Corner opposite = table_.opposite(next(first));
    if (!is_done(opposite)) walk(opposite);
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

  bool is_done(Corner corner) const { return corner == absent || triangle_done_[corner / 3]; }

  void walk(Corner start) {
    branches_.assign(1, start);
    while (!branches_.empty()) {
      const Corner corner = branches_.back();
      if (is_done(corner)) {
        branches_.pop_back();
      } else {
        walk_branch(corner);
      }
    }
  }

  void walk_branch(Corner corner) {
    while (true) {
      triangle_done_[corner / 3] = true;
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
      if (is_done(right)) note_split(right, true);
      if (is_done(left)) note_split(left, false);
      if (is_done(right) && is_done(left)) {
        result_.symbols.push_back(Symbol::e);
        branches_.pop_back();
        return;
      }
      if (!is_done(right) && !is_done(left)) return split(corner, left, right);
      result_.symbols.push_back(is_done(right) ? Symbol::r : Symbol::l);
      corner = is_done(right) ? left : right;
    }
  }

  void split(Corner corner, Corner left, Corner right) {
    split_symbol_[corner / 3] = static_cast<std::uint32_t>(result_.symbols.size());
    result_.symbols.push_back(Symbol::s);
    ++result_.split_symbols;
    branches_.back() = left;
    branches_.push_back(right);
  }

  void note_split(Corner neighbor, bool right) {
    if (neighbor == absent || split_symbol_[neighbor / 3] == absent) return;
    result_.splits.push_back({static_cast<std::uint32_t>(result_.symbols.size()), split_symbol_[neighbor / 3], right});
  }

  const CornerTable& table_;
  std::vector<bool> triangle_done_;
  std::vector<bool> vertex_done_;
  std::vector<std::uint32_t> split_symbol_;
  std::vector<Corner> branches_;
  Edgebreaker result_;
};

}  // namespace

Edgebreaker edgebreaker(const CornerTable& table) { return Walk(table).all(); }

}  // namespace dini
