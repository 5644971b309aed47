#include "draco/valence_contexts.h"

#include <algorithm>

namespace dini {
namespace {

constexpr std::uint32_t smallest_valence = 2;
constexpr std::uint32_t largest_valence = 7;

/// The vertices as a decoder has them while it rebuilds: pieces of the vertices of the mesh, which `s` joins.
class RebuiltVertices {
 public:
  explicit RebuiltVertices(std::size_t corners) : piece_of_corner_(corners, absent) {}

  std::uint32_t of(Corner corner) {
    std::uint32_t piece = piece_of_corner_[corner];
    while (joined_to_[piece] != piece) piece = joined_to_[piece] = joined_to_[joined_to_[piece]];
    return piece;
  }
  std::uint32_t valence_at(Corner corner) { return valences_[of(corner)]; }

  void share(Corner corner, Corner with) { piece_of_corner_[corner] = of(with); }
  void create(Corner corner) {
    piece_of_corner_[corner] = static_cast<std::uint32_t>(valences_.size());
    joined_to_.push_back(piece_of_corner_[corner]);
    valences_.push_back(0);
  }
  void join(Corner into, Corner from) {
    const std::uint32_t target = of(into);
    const std::uint32_t source = of(from);
    valences_[target] += valences_[source];
    joined_to_[source] = target;
  }
  void add(Corner corner, std::uint32_t edges) { valences_[of(corner)] += edges; }

 private:
  std::vector<std::uint32_t> piece_of_corner_;
  std::vector<std::uint32_t> joined_to_;
  std::vector<std::uint32_t> valences_;
};

// Adds the triangle of `tip` as a decoder does: joined at its right edge, its left edge, both or none.
void rebuild(const CornerTable& table, Symbol symbol, Corner tip, RebuiltVertices& vertices) {
  const Corner after = next(tip);
  const Corner before = previous(tip);
  const Corner right = table.right(tip);
  const Corner left = table.left(tip);
  switch (symbol) {
    case Symbol::e:
      for (const Corner corner : {tip, after, before}) {
        vertices.create(corner);
        vertices.add(corner, 2);
      }
      return;
    case Symbol::r:
      vertices.share(tip, previous(left));
      vertices.share(after, next(left));
      vertices.create(before);
      break;
    case Symbol::l:
      vertices.share(tip, next(right));
      vertices.share(before, previous(right));
      vertices.create(after);
      break;
    case Symbol::s:
      vertices.join(previous(left), next(right));
      [[fallthrough]];
    case Symbol::c:
      vertices.share(tip, previous(left));
      vertices.share(after, next(left));
      vertices.share(before, previous(right));
      break;
  }
  const bool tip_gains = symbol == Symbol::r || symbol == Symbol::l;
  vertices.add(tip, tip_gains ? 1 : 0);
  vertices.add(after, symbol == Symbol::l ? 2 : 1);
  vertices.add(before, symbol == Symbol::r ? 2 : 1);
}

}  // namespace

std::array<std::vector<Symbol>, valence_context_count> valence_contexts(const CornerTable& table,
                                                                        const Edgebreaker& walk) {
  std::array<std::vector<Symbol>, valence_context_count> contexts;
  RebuiltVertices vertices(table.corners());
  for (std::size_t i = walk.symbols.size(); i-- > 0;) {
    rebuild(table, walk.symbols[i], walk.corners[i], vertices);
    if (i == 0) break;
    const std::uint32_t valence = vertices.valence_at(next(walk.corners[i]));
    contexts[std::clamp(valence, smallest_valence, largest_valence) - smallest_valence].push_back(walk.symbols[i - 1]);
  }
  for (auto& context : contexts) std::reverse(context.begin(), context.end());
  return contexts;
}

}  // namespace dini
