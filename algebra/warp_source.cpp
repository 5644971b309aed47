#include "algebra/warp_source.h"

#include <cmath>

#include "algebra/construct.h"
#include "algebra/tolerance.h"

namespace dini::kernels {

WarpSource warp_source(const Generator& g) {
  const auto at = [&](const Vector& position) {
    return WarpSource{g, is_finite(position) ? to_point(position) : Point{}};
  };
  const double pair = squared_length(g.no_e), line = squared_length(g.e_e);
  // W = c x t and e = c.t give back c
  if (pair > 0) return at((g.no_ni * g.no_e + cross(g.no_e, g.e_e)) / pair);
  if (g.no_ni != 0) return at(g.e_ni / g.no_ni);
  if (line > 0) return at(cross(g.e_e, g.e_ni) / line);
  return at({});
}

bool is_null_pair(const WarpSource& source) {
  const Generator& g = source.generator;
  const Generator pair = null_pair(source.position, g.no_e);
  const double reach = length(to_vector(source.position)), size = length(g.no_e);
  const double noise = tolerance::null_pair * size;
  return length(g.e_e - pair.e_e) <= noise * reach && std::abs(g.no_ni - pair.no_ni) <= noise * reach &&
         length(g.e_ni - pair.e_ni) <= noise * reach * reach;
}

}  // namespace dini::kernels
