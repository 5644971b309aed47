#pragma once

#include <string_view>

#include "algebra/generator_kind.h"
#include "service/control_lines.h"

namespace dini {

/// The word for a kind in the extras of a preview.
std::string_view word_for(GeneratorKind kind);

/// Draws a generator as control geometry: a null pair as an arrow at its place; a real pair as its two poles, what
/// joins them, and the circle between them; an imaginary pair as its circle, dashed; a flat point, a direction, and a
/// rotation as mark, arrow, and axis with the sense of the turn; any other as its two commuting parts.
void draw(const Generator& generator, GeneratorKind kind, ControlLines& lines);

}  // namespace dini
