#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "geometry/grid_lanes.cpp"
// clang-format off: this compiles the file once per instruction set, so it comes before all other headers
#include "hwy/foreach_target.h"  // IWYU pragma: keep
// clang-format on

#include <algorithm>
#include <atomic>

#include "algebra/kernels-inl.h"
#include "geometry/grid_lanes.h"
#include "geometry/grid_normals.h"

HWY_BEFORE_NAMESPACE();
namespace dini::HWY_NAMESPACE {

using Triples = Triple<Lanes>;

HWY_INLINE Triples triples(kernels::ConstPoints points, std::size_t offset, Range range) {
  return {load(points.x + offset, range), load(points.y + offset, range), load(points.z + offset, range)};
}

HWY_INLINE Lanes largest_of(Lanes a, Lanes b, Lanes c) { return hn::Max(hn::Max(a, b), c); }

/// Writes 1 for every lane of a range that the mask leaves out.
HWY_INLINE void doubt_others(LaneMask sure, Range range, std::uint8_t* doubtful) {
  const Tag d;
  if (HWY_LIKELY(hn::AllTrue(d, sure))) return;
  HWY_ALIGN double lanes[most_lanes];
  hn::Store(hn::IfThenElseZero(sure, hn::Set(d, 1.0)), d, lanes);
  for (std::size_t i = 0; i < range.valid; ++i) {
    if (lanes[i] == 0) std::atomic_ref(doubtful[range.first + i]).store(1, std::memory_order_relaxed);
  }
}

grid_lanes::Extent extent_lanes(kernels::ConstPoints points, std::size_t count, double squared_radius) {
  const Tag d;
  LaneMask inside = hn::Eq(hn::Zero(d), hn::Zero(d));
  Lanes largest = hn::Zero(d);
  const Lanes limit = hn::Set(d, squared_radius);
  for_each_range(count, [&](Range range) HWY_ATTR {
    const Triples p = triples(points, 0, range);
    inside = hn::And(inside, hn::Le(dot(p, p), limit));
    largest = hn::Max(largest, largest_of(hn::Abs(p.x), hn::Abs(p.y), hn::Abs(p.z)));
  });
  HWY_ALIGN double lanes[most_lanes];
  hn::Store(largest, d, lanes);
  return {hn::AllTrue(d, inside), *std::max_element(lanes, lanes + hn::Lanes(d))};
}

/// A derivative while its terms are summed, and the largest square of a term.
struct Difference {
  Triples sum;
  Lanes largest;

  HWY_INLINE void add(Lanes weight, const Triples& step) {
    const Triples term = weight * step;
    sum = sum + term;
    largest = hn::Max(largest, dot(term, term));
  }
};

void normals_lanes(kernels::ConstPoints points, std::size_t row, const grid_lanes::RowDifferences& along_rows,
                   const grid_lanes::ColumnDifferences& along_columns, std::size_t begin, std::size_t end,
                   kernels::Points normals, std::uint8_t* doubtful) {
  const Tag d;
  const Lanes zero = hn::Zero(d), one = hn::Set(d, 1.0);
  const Lanes vanishing = hn::Set(d, vanishing_tangent * vanishing_tangent);
  const Lanes parallel = hn::Set(d, parallel_tangents * parallel_tangents);
  for_each_range(end - begin, [&](Range range) HWY_ATTR {
    const std::size_t at = row + begin;
    const Triples p = triples(points, at, range);
    Difference u{{zero, zero, zero}, zero}, v{{zero, zero, zero}, zero};
    for (std::size_t k = 0; k < along_rows.count; ++k) {
      u.add(hn::Set(d, along_rows.weights[k]), triples(points, along_rows.rows[k] + begin, range) - p);
    }
    v.add(load(along_columns[0] + begin, range), triples(points, at - 2, range) - p);
    v.add(load(along_columns[1] + begin, range), triples(points, at - 1, range) - p);
    v.add(load(along_columns[2] + begin, range), triples(points, at + 1, range) - p);
    v.add(load(along_columns[3] + begin, range), triples(points, at + 2, range) - p);
    const Triples normal = cross(u.sum, v.sum);
    const Lanes square = dot(normal, normal), uu = dot(u.sum, u.sum), vv = dot(v.sum, v.sum);
    const LaneMask vanish = hn::Or(hn::Le(uu, vanishing * u.largest), hn::Le(vv, vanishing * v.largest));
    const LaneMask usual = hn::And(hn::Gt(square, hn::Set(d, 1e-280)), hn::Lt(square, hn::Set(d, 1e280)));
    const LaneMask sure = hn::AndNot(vanish, hn::And(usual, hn::Gt(square, parallel * uu * vv)));
    const Lanes scale = hn::IfThenElseZero(sure, one / hn::Sqrt(hn::IfThenElse(sure, square, one)));
    const Triples unit = scale * Triples{hn::IfThenElseZero(sure, normal.x), hn::IfThenElseZero(sure, normal.y),
                                         hn::IfThenElseZero(sure, normal.z)};
    store(unit.x, normals.x + at, range);
    store(unit.y, normals.y + at, range);
    store(unit.z, normals.z + at, range);
    doubt_others(sure, range, doubtful + at);
  });
}

grid_lanes::QuadFacts facts_lanes(kernels::ConstPoints points, kernels::ConstPoints normals,
                                  const grid_lanes::QuadRun& run, const grid_lanes::QuadLimits& limits,
                                  std::uint8_t* doubtful) {
  const Tag d;
  const Lanes zero = hn::Zero(d);
  const LaneMask all = hn::Eq(zero, zero);
  LaneMask even = all, apart = all, near = all;
  // A coordinate of a side that coincides is within the tolerance; its square within three, and a little.
  const Lanes height = hn::Set(d, limits.tolerance * limits.tolerance);
  const Lanes least = hn::Set(d, 4 * limits.tolerance * limits.tolerance);
  const Lanes longest = hn::Set(d, limits.longest_step * limits.longest_step * (1 - 1e-9));
  for_each_range(run.count, [&](Range range) HWY_ATTR {
    const Triples a = triples(points, run.a, range), b = triples(points, run.b, range);
    const Triples c = triples(points, run.c, range), e = triples(points, run.d, range);
    const Triples ab = b - a, ac = c - a, ad = e - a, bc = c - b, cd = e - c;
    const Triples first = cross(ab, ac), second = cross(ac, ad);
    const Lanes ab2 = dot(ab, ab), ac2 = dot(ac, ac), ad2 = dot(ad, ad), bc2 = dot(bc, bc), cd2 = dot(cd, cd);
    const Lanes shortest = hn::Min(hn::Min(ab2, ad2), hn::Min(bc2, cd2));
    apart = hn::And(apart, hn::Gt(shortest, least));
    near = hn::And(near, hn::Le(largest_of(hn::Max(ab2, ad2), bc2, cd2), longest));
    const LaneMask with_area =
        hn::And(hn::Gt(dot(first, first), height * largest_of(ab2, bc2, ac2) * hn::Set(d, 1 + 1e-9)),
                hn::Gt(dot(second, second), height * largest_of(ac2, cd2, ad2) * hn::Set(d, 1 + 1e-9)));
    even = hn::And(even, hn::And(with_area, hn::Gt(dot(first, second), zero)));

    const Triples na = triples(normals, run.a, range), nb = triples(normals, run.b, range);
    const Triples nc = triples(normals, run.c, range), nd = triples(normals, run.d, range);
    const auto front = [&](const Triples& normal, const Triples& area)
                           HWY_ATTR { return hn::Gt(dot(normal, area), zero); };
    const LaneMask sure_a = hn::And(front(na, first), front(na, second));
    const LaneMask sure_c = hn::And(front(nc, first), front(nc, second));
    const LaneMask sure_b = front(nb, first), sure_d = front(nd, second);
    if (HWY_UNLIKELY(!hn::AllTrue(d, hn::And(hn::And(sure_a, sure_b), hn::And(sure_c, sure_d))))) {
      doubt_others(sure_a, range, doubtful + run.a);
      doubt_others(sure_b, range, doubtful + run.b);
      doubt_others(sure_c, range, doubtful + run.c);
      doubt_others(sure_d, range, doubtful + run.d);
    }
  });
  return {!hn::AllTrue(d, hn::And(even, apart)), !hn::AllTrue(d, apart), !hn::AllTrue(d, near)};
}

}  // namespace dini::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace dini {
HWY_EXPORT(extent_lanes);
HWY_EXPORT(normals_lanes);
HWY_EXPORT(facts_lanes);

namespace grid_lanes {

Extent extent_of(kernels::ConstPoints points, std::size_t count, double squared_radius) {
  return HWY_DYNAMIC_DISPATCH(extent_lanes)(points, count, squared_radius);
}

void difference_normals(kernels::ConstPoints points, std::size_t row, const RowDifferences& along_rows,
                        const ColumnDifferences& along_columns, std::size_t begin, std::size_t end,
                        kernels::Points normals, std::uint8_t* doubtful) {
  HWY_DYNAMIC_DISPATCH(normals_lanes)
  (points, row, along_rows, along_columns, begin, end, normals, doubtful);
}

QuadFacts facts_of(kernels::ConstPoints points, kernels::ConstPoints normals, const QuadRun& run,
                   const QuadLimits& limits, std::uint8_t* doubtful) {
  return HWY_DYNAMIC_DISPATCH(facts_lanes)(points, normals, run, limits, doubtful);
}

}  // namespace grid_lanes
}  // namespace dini
#endif
