#pragma once

// The parts of a model: what each is, and of meshes whether they are solids, for reports that ask for it.

#include <vector>

#include "graph/evaluate.h"
#include "graph/limits.h"
#include "service/prepared.h"

namespace dini {

/// What a report tells of the parts, kept for others who ask.
struct ToldParts {
  Json list;
};

/// Of self-intersections no more are counted than these pairs, for each part.
inline constexpr std::size_t most_told_intersections = 1000;

/// The nodes that make the parts of an export, by index into the plan; what telling of them needs is added to the
/// plan's cost. Problem: `limit-exceeded` for more parts than values may be measured, and for more work or memory than
/// a request may need.
Result<std::vector<std::size_t>> plan_parts(Plan& plan, std::size_t exported, const Limits& limits);

/// Everything that the list depends on, before anything is computed.
Digest parts_digest(const Plan& plan, std::size_t exported);

/// The list, from an evaluation of the nodes that make the parts: see `parts` of a report in docs/http.md. Stopped
/// early: meaningless.
Json parts_of(const Plan& plan, std::size_t exported, const Evaluation& evaluation, const Cancel& cancel);

}  // namespace dini
