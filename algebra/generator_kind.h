#pragma once

// What a generator is: which motions it makes, and the simple parts of one that makes two at once.

#include <array>

#include "algebra/elements.h"

namespace dini {

/// The kinds of simple generators (B^B = 0), and everything else. Pairs have poles: one for a null pair, two for a real
/// one; an imaginary pair turns about a circle.
enum class GeneratorKind { zero, null_pair, real_pair, imaginary_pair, flat_point, direction, rotation, general };

/// The kind of a generator. What is below `noise` of the products that it is the difference of counts as zero.
GeneratorKind kind_of(const Generator& generator, double noise = 1e-12);

/// Two simple generators that commute and whose sum is the generator, to 1e-9 of its size; a simple one is its own
/// first part, and the second is zero. The part that moves apart (or nowhere) comes first, the one that turns second.
/// Isoclinic generators have infinitely many such pairs; they get one that is within 1e-4 of their size of such a pair,
/// chosen by a fixed rule. (Dorst and Valkenburg 2011.)
std::array<Generator, 2> commuting_parts(const Generator& generator);

}  // namespace dini
