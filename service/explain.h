#pragma once

#include "graph/cache.h"
#include "service/history.h"
#include "service/prepared.h"

namespace dini {

/// Which nodes an evaluation would run and why, what they are predicted to make and to take: the schema `Explanation`.
Json explanation(const PreparedGraph& prepared, const std::vector<std::size_t>& targets, const Cache& cache,
                 const History& history);

}  // namespace dini
