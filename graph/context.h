#pragma once

#include <cstddef>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include "geometry/cancel.h"

namespace dini {

/// How much detail an evaluation asks for: `draft` while a value is being dragged, `final` otherwise.
enum class Quality { draft, final };

/// How fine an evaluation is. A draft keeps all its meshes together within about `triangle_budget` triangles; a final
/// answer is never thinned.
struct Detail {
  static constexpr std::size_t usual_triangle_budget = 20'000;

  Detail(Quality asked = Quality::final, std::size_t budget = usual_triangle_budget)
      : quality(asked), triangle_budget(budget) {}

  Quality quality;
  std::size_t triangle_budget;
};

/// Something a node wants to say although it succeeded.
struct Warning {
  std::string code;
  std::string detail;
  std::string port = {};

  friend bool operator==(const Warning&, const Warning&) = default;
};

/// Why a node cannot give a value: a stable code, one sentence, and the port to blame (may be empty).
struct Failure {
  std::string code;
  std::string detail;
  std::string port = {};
};

/// What a node function may ask about the evaluation it runs in. Shared by all threads that run the node.
class Context {
 public:
  Context(const Cancel& cancel, Quality quality, std::size_t triangle_budget = 0)
      : cancel_(cancel), quality_(quality), triangle_budget_(triangle_budget) {}

  const Cancel& cancel() const { return cancel_; }
  Quality quality() const { return quality_; }

  /// How many triangles each mesh that this node makes should have at most; 0 is no limit.
  std::size_t triangle_budget() const { return triangle_budget_; }

  /// Adds a warning, once.
  void warn(Warning warning) const {
    const std::lock_guard lock(mutex_);
    for (const Warning& known : warnings_) {
      if (known == warning) return;
    }
    warnings_.push_back(std::move(warning));
  }

  std::vector<Warning> take_warnings() const {
    const std::lock_guard lock(mutex_);
    return std::exchange(warnings_, {});
  }

 private:
  const Cancel& cancel_;
  Quality quality_;
  std::size_t triangle_budget_;
  mutable std::mutex mutex_;
  mutable std::vector<Warning> warnings_;
};

}  // namespace dini
