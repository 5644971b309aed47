#include "graph/run_node.h"

#include <algorithm>
#include <cmath>

#include "algebra/extract.h"
#include "geometry/chunks.h"
#include "graph/fixes.h"
#include "graph/literal.h"

namespace dini {

namespace {

/// " at index 3 of axis k, index 0 of axis v" for the sample `index` of a family over `axes`.
std::string place_text(const Axes& axes, std::size_t index) {
  std::string text;
  for (std::size_t k = axes.size(); k-- > 0;) {
    const std::string one = "index " + std::to_string(index % axes[k].size) + " of axis " + axes[k].name;
    text = text.empty() ? one : one + ", " + text;
    index /= axes[k].size;
  }
  return text.empty() ? "" : " at " + text;
}

/// True when a value may stand on a wire: all components finite, or the point at infinity.
template <class T>
bool may_stand(const Column<T>& column, std::size_t index) {
  bool finite = true;
  for (std::size_t k = 0; k < Column<T>::width; ++k) finite = finite && std::isfinite(column.component(k)[index]);
  if (finite) return true;
  if constexpr (std::is_same_v<T, Point>) return column[index] == Point::at_infinity();
  return false;
}

/// The first circle or sphere that is none: smaller than the round-off where it lies, or imaginary.
std::optional<std::size_t> first_unreal(const AnyColumn& any, const Cancel& cancel) {
  return std::visit(
      [&]<class T>(const std::shared_ptr<const Column<T>>& column) -> std::optional<std::size_t> {
        if constexpr (std::is_same_v<T, Circle> || std::is_same_v<T, Sphere>) {
          return first_where(cancel, column->size(), [&](std::size_t i) { return !coordinates((*column)[i]); });
        }
        return std::nullopt;
      },
      any);
}

std::optional<std::size_t> first_bad(const AnyColumn& any, const Cancel& cancel) {
  return std::visit(
      [&]<class T>(const std::shared_ptr<const Column<T>>& column) -> std::optional<std::size_t> {
        if constexpr (Column<T>::numeric) {
          return first_where(cancel, column->size(), [&](std::size_t i) { return !may_stand(*column, i); });
        }
        return std::nullopt;
      },
      any);
}

class NodeRunner {
 public:
  NodeRunner(const PlannedNode& node, const ColumnOf& column_of, const Context& context)
      : node_(node), column_of_(column_of), call_{context, {}, node.lifted, node.consumed, node.made} {}

  Result<std::vector<AnyColumn>> run() {
    for (std::size_t port = 0; port < node_.inputs.size(); ++port) {
      call_.arguments.push_back(argument(port));
      if (auto problem = out_of_range(port)) return *problem;
    }
    LiftedResult lifted = node_.overload->run(call_);
    if (!lifted) {
      const auto& [failure, index] = lifted.error();
      return problem(failure.code, failure.port, failure.detail + place_text(node_.lifted, index));
    }
    std::vector<AnyColumn> columns = *std::move(lifted);
    if (cancel().stopped()) return columns;
    for (std::size_t output = 0; output < columns.size(); ++output) {
      if (const std::optional<std::size_t> bad = first_bad(columns[output], cancel())) {
        return problem("non-finite", "",
                       "output " + node_.type->outputs[output].name + " is not a finite " +
                           std::string(name(node_.outputs[output].type)) +
                           place_text(node_.outputs[output].axes, *bad));
      }
      if (const std::optional<std::size_t> unreal = first_unreal(columns[output], cancel())) {
        return problem("degenerate", "",
                       "output " + node_.type->outputs[output].name + " is no " +
                           std::string(name(node_.outputs[output].type)) +
                           ": it is imaginary, or smaller than the round-off at its place" +
                           place_text(node_.outputs[output].axes, *unreal));
      }
    }
    return columns;
  }

 private:
  const Cancel& cancel() const { return call_.context.cancel(); }

  Problem problem(std::string code, const std::string& port, std::string detail) const {
    return {std::move(code), std::move(detail), node_.id, port, input_pointer(node_.id, port)};
  }

  Argument read(const PlannedItem& item) const {
    if (const auto* source = std::get_if<Source>(&item.from)) return Value{item.shape.axes, column_of_(*source)};
    return std::get<Argument>(item.from);
  }

  Argument argument(std::size_t port) const {
    const PlannedInput& input = node_.inputs[port];
    const bool mixed = node_.overload->inputs[port].is_mixed();
    if (input.items.empty()) return std::monostate{};
    if (!input.list_axis && !mixed) return read(input.items.front());
    Items items;
    for (const PlannedItem& item : input.items) {
      items.values.push_back(std::get<Value>(read(item)));
      if (node_.type->names_parts) items.origins.push_back(item.origin);
    }
    if (mixed) return items;
    return stack(items.values, *input.list_axis, cancel());
  }

  std::optional<Problem> out_of_range(std::size_t port) const {
    const InputPort& card = node_.type->inputs[port];
    const auto* value = std::get_if<Value>(&call_.arguments[port]);
    if (value == nullptr || value->type() != WireType::number || (!card.spec.minimum && !card.spec.maximum))
      return std::nullopt;
    const Column<double>& column = dini::column_of<double>(*value);
    const double least = card.spec.minimum.value_or(-HUGE_VAL);
    const double most = card.spec.maximum.value_or(HUGE_VAL);
    const std::optional<std::size_t> outside =
        first_where(cancel(), column.size(), [&](std::size_t i) { return !(column[i] >= least && column[i] <= most); });
    if (!outside) return std::nullopt;
    return problem("out-of-range", card.name,
                   card.name + " of " + node_.id + " (" + node_.type->title + "): got " + to_text(column[*outside]) +
                       place_text(value->axes, *outside) + ", accepted is " +
                       range_text(card.spec.minimum, card.spec.maximum));
  }

  const PlannedNode& node_;
  const ColumnOf& column_of_;
  Call call_;
};

}  // namespace

Result<std::vector<AnyColumn>> run_node(const PlannedNode& node, const ColumnOf& column_of, const Context& context) {
  return NodeRunner(node, column_of, context).run();
}

}  // namespace dini
