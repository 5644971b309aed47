#include "geometry/sampling.h"
#include "graph/node_builder.h"
#include "nodes/all.h"
#include "nodes/formula.h"

namespace dini {

namespace {

double number_value(double value) { return value; }

struct VectorInputs {
  double x, y, z;
};

Vector vector_of(const VectorInputs& in) { return {in.x, in.y, in.z}; }

struct RangeInputs {
  double from, to;
  std::int64_t count;
  bool closed;
};

Made<double> range_values(const Context& context, const RangeInputs& in) {
  return {spaced(in.from, in.to, static_cast<std::size_t>(in.count), in.closed, context.cancel())};
}

template <class T>
T list_item(const T& item) {
  return item;
}

struct ExpressionInputs {
  std::string formula;
  Batch<double> x, y, z, w;
};

std::optional<Failure> expression_values(const Context& context, const ExpressionInputs& in, BatchOut<double> value) {
  std::string wrong;
  const std::optional<Formula> compiled = Formula::compile(in.formula, wrong);
  if (!compiled) return Failure{"invalid-formula", wrong, "formula"};
  constexpr std::size_t between_looks = 256;  // a long formula takes microseconds
  for (std::size_t i = 0; i < value.size; ++i) {
    if (i % between_looks == 0 && context.cancel().stopped()) break;
    value.set(i, compiled->evaluate({in.x[i], in.y[i], in.z[i], in.w[i]}));
  }
  return std::nullopt;
}

}  // namespace

void add_numbers(Registry& registry) {
  registry.add(node("number", number_value)
                   .title("Number")
                   .family("numbers")
                   .synonyms({"slider", "value", "constant", "scalar", "float", "parameter"})
                   .doc("A number to use in several places.")
                   .input("value", "The number.", defaults(0).soft(-10, 10))
                   .output("value", "The same number."));

  registry.add(
      node("range", range_values)
          .title("Range")
          .family("numbers")
          .synonyms({"series", "sequence", "array", "steps", "linspace", "repeat", "copies", "count", "family"})
          .doc("Evenly spaced numbers along a new axis.")
          .details(
              "An open range holds both ends; a closed one leaves the end value out, because it is the start again.")
          .input("from", &RangeInputs::from, "First value.", defaults(0).soft(-10, 10))
          .input("to", &RangeInputs::to, "Last value, or the value after the last on a closed axis.",
                 defaults(1).soft(-10, 10))
          .input("count", &RangeInputs::count, "How many values.", defaults(32).hard(1, 10'000'000).soft(2, 256))
          .input("closed", &RangeInputs::closed, "Whether the last value joins the first.", defaults(false))
          .made_axis("axis", "Name of the axis; empty means the id of this node.")
          .axes(one_axis("count", "axis", "closed"))
          .output("values", "The numbers, over the new axis."));

  registry.add(node("list", list_item<double>, list_item<Point>, list_item<Vector>, list_item<Generator>,
                    list_item<Circle>, list_item<Sphere>)
                   .title("List")
                   .family("numbers")
                   .synonyms({"array", "values", "table", "sequence", "items"})
                   .doc("Values given one by one, along a new axis.")
                   .details("Literal triples are read as points.")
                   .input("items", "Links or literals, all of one type; three numbers are a point, vectors are linked.",
                          required().several())
                   .passes_on()
                   .lists_along("axis")
                   .made_axis("axis", "Name of the axis; empty means the id of this node.")
                   .output("items", "The values, over the new axis."));

  registry.add(node("vector", vector_of)
                   .title("Vector")
                   .family("numbers")
                   .synonyms({"xyz", "offset", "displacement", "arrow", "combine"})
                   .doc("A free direction from its three coordinates.")
                   .input("x", &VectorInputs::x, "Along the first axis.", defaults(0).soft(-2, 2).unit("m"))
                   .input("y", &VectorInputs::y, "Along the second axis.", defaults(0).soft(-2, 2).unit("m"))
                   .input("z", &VectorInputs::z, "Along the third axis, up.", defaults(0).soft(-2, 2).unit("m"))
                   .output("vector", "The direction."));

  registry.add(
      node("expression", expression_values)
          .title("Expression")
          .family("numbers")
          .synonyms({"formula", "math", "function", "equation", "calculate", "multiply", "divide", "subtract", "sine",
                     "cosine", "wave"})
          .doc("A formula over x, y, z and w, evaluated for every combination of their axes.")
          .details(
              "Operators + - * / ^ < <= > >= == != && || ? :, constants pi and e, functions " +
              Formula::function_names() +
              ". Angles are in radians. The same result on every machine; a result that is not finite is an error.")
          .input("formula", &ExpressionInputs::formula, "For example sin(2*pi*x) + y/2.",
                 required().read_by("invalid-formula", Formula::fault))
          .input("x", &ExpressionInputs::x, "First variable.", defaults(0).soft(-10, 10))
          .input("y", &ExpressionInputs::y, "Second variable.", defaults(0).soft(-10, 10))
          .input("z", &ExpressionInputs::z, "Third variable.", defaults(0).soft(-10, 10))
          .input("w", &ExpressionInputs::w, "Fourth variable.", defaults(0).soft(-10, 10))
          .cost([](const RunSize& size) {
            constexpr double work_of_character = 5, parser_bytes = 32'000;
            return RunCost{work_of_character * static_cast<double>(text_at(size.literals, "formula").size()),
                           parser_bytes};
          })
          .output("value", "The value of the formula."));
}

}  // namespace dini
