#pragma once

#include <array>
#include <vector>

#include "draco/edgebreaker.h"

namespace dini {

/// How many contexts there are: one for each valence from 2 (or less) to 7 (or more).
inline constexpr std::size_t valence_context_count = 6;

/// The symbols by the valence, in what a decoder has rebuilt before, of the vertex that the next triangle shares. On
/// most surfaces each context holds nearly one symbol only. Decoders read every list from its end and know that the
/// first symbol is `e`, so it is in none (Szymczak 2002; Draco bitstream 2.2, "EdgeBreaker Traversal Valence").
std::array<std::vector<Symbol>, valence_context_count> valence_contexts(const CornerTable& table,
                                                                        const Edgebreaker& walk);

}  // namespace dini
