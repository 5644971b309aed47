#pragma once

#include <atomic>
#include <cmath>
#include <new>
#include <stdexcept>

#include "graph/node_builder.h"
#include "graph/registry.h"

namespace dini {

namespace toy {
enum class Word { first, second };
}  // namespace toy

template <>
struct ChoiceNames<toy::Word> {
  static constexpr std::array<std::string_view, 2> names = {"first", "second"};
};

}  // namespace dini

namespace dini::toy {

/// How often `count_runs` has run since the program started.
inline std::atomic<int> runs = 0;

inline double constant(double value) { return value; }

inline double chosen(Word word) { return word == Word::first ? 1 : 2; }

struct SumInputs {
  double a, b;
};

inline double sum(const SumInputs& in) { return in.a + in.b; }

inline double count_runs(double value) {
  ++runs;
  return value + 1;
}

inline Attempt<double> root(double value) {
  if (value < 0) return Failure{"degenerate", "no root of a negative number", "value"};
  return std::sqrt(value);
}

inline double reciprocal(double value) { return 1 / value; }

struct RampInputs {
  std::int64_t count;
  bool closed;
};

inline Made<double> ramp(const RampInputs& in) {
  Column<double> values(static_cast<std::size_t>(in.count));
  for (std::size_t i = 0; i < values.size(); ++i) values.set(i, static_cast<double>(i));
  return {std::move(values)};
}

struct TotalInputs {
  Block<double, 1> values, weights;
};

inline double total(const TotalInputs& in) {
  double result = 0;
  for (std::size_t i = 0; i < in.values.size(); ++i) result += in.values(i) * in.weights(i);
  return result;
}

template <class T>
T same(const T& item) {
  return item;
}

struct ShiftedInputs {
  Vector by;
};

inline Point shifted(const Point& point, const ShiftedInputs& in) { return to_point(to_vector(point) + in.by); }

struct DoubledInputs {
  double offset;
};

inline void doubled(const Batch<double>& value, const DoubledInputs& in, BatchOut<double> result) {
  for (std::size_t i = 0; i < result.size; ++i) result.set(i, 2 * value[i] + in.offset);
}

inline double slow_sum(const SumInputs& in) {
  double same = in.a;
  for (int i = 0; i < 50; ++i) same = std::sqrt(same * same);
  return same + in.b;
}

inline double no_memory(double) { throw std::bad_alloc(); }
inline double throws(double) { throw std::runtime_error("a toy that is broken"); }

inline double warns(const Context& context, double value) {
  context.warn({"toy", "this toy always says so", "value"});
  return value;
}

/// Waits until it is cancelled.
inline double endless(const Context& context, double value) {
  while (!context.cancel().stopped()) {
  }
  return value;
}

/// A registry of nodes that test the engine and nothing else.
inline Registry registry() {
  Registry nodes;
  const auto value_node = [](NodeBuilder<Nothing> builder) -> NodeType {
    return std::move(builder)
        .title("Toy")
        .family("toys")
        .doc("A toy.")
        .input("value", "A number.", defaults(1).hard(-100, 1e6))
        .output("value", "A number.");
  };
  nodes.add(value_node(node("constant", constant)));
  nodes.add(value_node(node("count_runs", count_runs)));
  nodes.add(value_node(node("root", root)));
  nodes.add(value_node(node("reciprocal", reciprocal)));
  nodes.add(value_node(node("endless", endless)));
  nodes.add(value_node(node("no_memory", no_memory)));
  nodes.add(value_node(node("throws", throws)));
  nodes.add(value_node(node("warns", warns)));
  const auto sum_node = [](NodeBuilder<SumInputs> builder) -> NodeType {
    return std::move(builder)
        .title("Sum")
        .family("toys")
        .doc("Adds.")
        .input("a", &SumInputs::a, "First.")
        .input("b", &SumInputs::b, "Second.", defaults(10))
        .output("value", "The sum.");
  };
  nodes.add(sum_node(node("sum", sum)));
  nodes.add(sum_node(node("slow_sum", slow_sum)));
  nodes.add(node("chooser", chosen)
                .title("Chooser")
                .family("toys")
                .doc("1 or 2.")
                .input("word", "Which.", defaults("first"))
                .output("value", "The number."));
  nodes.add(node("ramp", ramp)
                .title("Ramp")
                .family("toys")
                .doc("0, 1, 2, ...")
                .input("count", &RampInputs::count, "How many.", defaults(3).hard(1, 1'000'000'000))
                .input("closed", &RampInputs::closed, "Whether it closes.", defaults(false))
                .made_axis("axis", "Name.")
                .axes(one_axis("count", "axis", "closed"))
                .output("values", "The numbers."));
  nodes.add(node("total", total)
                .title("Total")
                .family("toys")
                .doc("Sums along an axis.")
                .input("values", &TotalInputs::values, "Numbers.", required().several())
                .input("weights", &TotalInputs::weights, "Weights.", defaults(1).several())
                .consumed_axis("over", "The axis.")
                .output("value", "The sum."));
  nodes.add(node("list", same<double>, same<Point>)
                .title("List")
                .family("toys")
                .doc("Items.")
                .input("items", "Items.", required().several())
                .lists_along("axis")
                .made_axis("axis", "Name.")
                .output("items", "Items."));
  nodes.add(node("shifted", shifted)
                .title("Shifted")
                .family("toys")
                .doc("Moves.")
                .input("point", "P.")
                .input("by", &ShiftedInputs::by, "V.", defaults({0, 0, 1}))
                .output("point", "P."));
  nodes.add(node("doubled", doubled)
                .title("Doubled")
                .family("toys")
                .doc("Twice.")
                .input("value", "N.")
                .input("offset", &DoubledInputs::offset, "N.", defaults(0))
                .output("value", "N."));
  return nodes;
}

}  // namespace dini::toy
