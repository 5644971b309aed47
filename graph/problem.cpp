#include "graph/problem.h"

namespace dini {

Problems ProblemCollector::take() && {
  if (unlisted_ > 0) {
    problems_.push_back({"more-problems", "there are " + std::to_string(unlisted_) + " more problems of this graph"});
    unlisted_ = 0;
  }
  return std::move(problems_);
}

}  // namespace dini
