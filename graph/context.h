#pragma once

#include <cstddef>
#include <mutex>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "geometry/axis.h"
#include "geometry/cancel.h"
#include "graph/file.h"

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

/// A place along one of the axes that a node consumes. Results are kept apart from the names of axes, so what is said
/// beside a result holds a number, and gets the name when it is told.
struct ConsumedPlace {
  std::size_t axis = 0;
  std::size_t index = 0;

  friend bool operator==(const ConsumedPlace&, const ConsumedPlace&) = default;
};

/// Something a node wants to say although it succeeded.
struct Warning {
  std::string code;
  std::string detail;
  std::string port = {};
  std::optional<ConsumedPlace> place = {};  ///< where, told behind the detail

  friend bool operator==(const Warning&, const Warning&) = default;
};

/// The sentence of a warning of a node that consumes these axes.
inline std::string told(const Warning& warning, const Axes& consumed) {
  if (!warning.place || warning.place->axis >= consumed.size()) return warning.detail;
  return warning.detail + " at index " + std::to_string(warning.place->index) + " of axis " +
         consumed[warning.place->axis].name;
}

/// Why a node cannot give a value: a stable code, one sentence, and the port to blame (may be empty).
struct Failure {
  std::string code;
  std::string detail;
  std::string port = {};
};

/// What a node function may ask about the evaluation it runs in. Shared by all threads that run the node.
class Context {
 public:
  Context(const Cancel& cancel, Quality quality, std::size_t triangle_budget = 0, const WantedFile* file = nullptr)
      : cancel_(cancel), quality_(quality), triangle_budget_(triangle_budget), file_(file) {}

  const Cancel& cancel() const { return cancel_; }
  Quality quality() const { return quality_; }

  /// How many triangles each mesh that this node makes should have at most; 0 is no limit.
  std::size_t triangle_budget() const { return triangle_budget_; }

  /// How the file is wanted that this node writes; null where nobody said.
  const WantedFile* file() const { return file_; }

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
  const WantedFile* file_;
  mutable std::mutex mutex_;
  mutable std::vector<Warning> warnings_;
};

}  // namespace dini
