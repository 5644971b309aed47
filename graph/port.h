#pragma once

#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "graph/problem.h"
#include "graph/reading.h"
#include "graph/wire.h"

namespace dini {

/// What a 3D view may offer to set an input with: a position to drag, a direction with its tip at `at` + direction, or
/// the radius of a round about `at`, in the plane of `normal`. `at` and `normal` name inputs of the same node; an empty
/// `at` is the origin, an empty `normal` stands for a sphere.
struct Handle {
  enum class Kind { position, direction, radius };
  Kind kind = Kind::position;
  std::string at = {};
  std::string normal = {};
};

/// What a card says about an input beside its name and text: default, unit, ranges.
/// The hard range is enforced for literals and wired numbers alike; the soft range is only the slider's extent.
class InputSpec {
 public:
  InputSpec() = default;
  explicit InputSpec(Json value) : default_value(std::move(value)) {}

  InputSpec&& hard(double least, double most) && {
    minimum = least;
    maximum = most;
    return std::move(*this);
  }
  InputSpec&& soft(double least, double most) && {
    soft_minimum = least;
    soft_maximum = most;
    return std::move(*this);
  }
  /// What people read beside the socket, where the words of the name are not good enough: "Clip radius".
  InputSpec&& title(std::string text) && {
    title_text = std::move(text);
    return std::move(*this);
  }
  InputSpec&& unit(std::string text) && {
    unit_text = std::move(text);
    return std::move(*this);
  }
  /// Takes a list of links and literals, which share one axis.
  InputSpec&& several() && {
    takes_several = true;
    return std::move(*this);
  }

  /// A text that names an axis: it chooses how axes pair up, but never changes a value.
  InputSpec&& names_axis() && {
    is_axis_name = true;
    return std::move(*this);
  }

  /// A text in a language of its own. `fault` says what is wrong with one, or nothing; it is asked when a graph is
  /// checked, and its answer is a problem with this code.
  InputSpec&& read_by(std::string code, std::function<std::optional<std::string>(const std::string&)> fault) && {
    text_fault_code = std::move(code);
    text_fault = std::move(fault);
    return std::move(*this);
  }

  InputSpec&& position_handle() && { return std::move(*this).handled({Handle::Kind::position}); }
  InputSpec&& direction_handle(std::string at = "") && {
    return std::move(*this).handled({Handle::Kind::direction, std::move(at)});
  }
  InputSpec&& radius_handle(std::string at, std::string normal = "") && {
    return std::move(*this).handled({Handle::Kind::radius, std::move(at), std::move(normal)});
  }

  Json default_value = nullptr;
  std::optional<double> minimum, maximum, soft_minimum, soft_maximum;
  std::string title_text;
  std::string unit_text;
  bool takes_several = false;
  bool is_axis_name = false;
  std::string text_fault_code;
  std::function<std::optional<std::string>(const std::string&)> text_fault;
  std::optional<Handle> handle;

 private:
  InputSpec&& handled(Handle given) && {
    handle = std::move(given);
    return std::move(*this);
  }
};

/// The spec of an input that has a default; `required()` of one that must be given.
inline InputSpec defaults(Json value) { return InputSpec(std::move(value)); }
inline InputSpec required() { return InputSpec(); }

/// One input of a node type, as its card shows it.
struct InputPort {
  std::string name;
  std::string doc;
  InputSpec spec;
  std::vector<WireType> types = {};  ///< One per overload, repeats left out.
  std::vector<std::string> choices = {};
  bool optional = false;     ///< May be absent and has no default.
  bool names_file = false;   ///< A text that stands for a mesh file.
  bool keeps_apart = false;  ///< Takes values of several types at once, from links.
  Readings usual = {};       ///< The default.

  bool required() const { return !optional && spec.default_value.is_null(); }
};

/// One output of a node type.
struct OutputPort {
  std::string name;
  std::string doc;
  std::vector<WireType> types;
};

}  // namespace dini
