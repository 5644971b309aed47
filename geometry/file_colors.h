#pragma once

// Colors as OBJ and PLY files write them: those of pictures, on a scale that nothing but the numbers themselves tells.

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

namespace dini {

/// Of a vertex that the file gives no color: it becomes white.
inline constexpr std::array<float, 4> no_file_color = {-1, -1, -1, -1};

/// A color of a file before its scale is known: what lies below 0 counts as 0.
std::array<float, 4> file_color(double red, double green, double blue, std::optional<double> alpha);

/// Which values may stand for full light, or for an opaque alpha. The largest value of the file tells which one does:
/// up to 2 it is 1 (a bit above 1 is too bright), up to 255 it is 255, and above that `most`; but not below `least`.
struct FullValue {
  double least = 1, most = 65535;
};

/// A share of linear light in [0, 1] as the share that pictures store; the other way round than `make_linear`. What is
/// not above 0 is 0.
double picture_share(double linear);

/// Turns the colors of a file into linear light with alpha in [0, 1] (IEC 61966-2-1). What is not finite stays so.
void make_linear(std::vector<std::array<float, 4>>& colors, const FullValue& light = {}, const FullValue& alpha = {});

}  // namespace dini
