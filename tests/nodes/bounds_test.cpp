// The hard ranges on the cards of all nodes are what the engine accepts: all of it, and nothing beyond. Within them,
// and where there are none, the largest, the smallest and the flattest numbers give whole values or a clear problem.

#include <catch2/catch.hpp>
#include <cmath>

#include "algebra/extract.h"
#include "geometry/validate.h"
#include "tests/nodes/node_inputs.h"

using namespace dini;
using namespace dini::support;

namespace {

/// Graphs that would make more values than this, or be more work, are only checked: the point is what is accepted.
constexpr std::size_t most_evaluated = 3'000'000;
constexpr std::size_t most_work = 300'000'000;
/// The same for extreme numbers, of which there are many.
constexpr std::size_t most_of_an_extreme = 200'000;

bool is_integer(const InputPort& port) { return port.types.front() == WireType::integer; }

Json literal_of(const InputPort& port, double value) {
  return is_integer(port) ? Json(static_cast<std::int64_t>(value)) : Json(value);
}

Json beyond(const InputPort& port, double bound, double direction) {
  return is_integer(port) ? Json(static_cast<std::int64_t>(bound + direction))
                          : Json(std::nextafter(bound, direction * HUGE_VAL));
}

/// The other counts of a node at their least, so that one bound at a time decides how much there is to compute.
Json least_counts(const Subject& subject) {
  Json literals = Json::object();
  for (const InputPort& port : subject.type->inputs) {
    if (is_integer(port) && port.spec.minimum) literals[port.name] = literal_of(port, *port.spec.minimum);
  }
  return literals;
}

/// Counts of a node that are usually many, few: there are many extreme numbers to try, and each value meets them.
Json few_counts(const Subject& subject) {
  constexpr double few = 8;
  Json literals = Json::object();
  for (const InputPort& port : subject.type->inputs) {
    const bool many =
        is_integer(port) && port.spec.minimum && port.spec.default_value.is_number() && port.spec.default_value > few;
    if (many) literals[port.name] = literal_of(port, std::max(few, *port.spec.minimum));
  }
  return literals;
}

/// Calls `test` with every input of every node that has a hard range, and that range.
template <class Test>
void for_every_bound(Test test) {
  for (const Subject& subject : all_subjects()) {
    for (const InputPort& port : subject.type->inputs) {
      if (!port.spec.minimum) continue;
      CAPTURE(subject.name(), port.name);
      test(subject, port, *port.spec.minimum, -1.0);
      test(subject, port, *port.spec.maximum, 1.0);
    }
  }
}

const std::vector<double>& extremes() {
  static const std::vector<double> numbers = [] {
    std::vector<double> both;
    for (const double size : {0.0, 5e-324, 1e-308, 1e-160, 1e-20, 1e-9, 1e9, 1e18, 1e100, 1e155, 1e300,
                              std::numeric_limits<double>::max()}) {
      both.push_back(size);
      both.push_back(-size);
    }
    return both;
  }();
  return numbers;
}

template <class T>
bool is_whole(const T& value) {
  if constexpr (std::is_same_v<T, SharedMesh>) {
    const auto shade = [](double c) { return c >= 0 && c <= 1; };
    return value != nullptr && !mesh_defect(*value) && std::all_of(value->color.begin(), value->color.end(), shade);
  } else if constexpr (std::is_same_v<T, SharedFile>) {
    return value != nullptr && value->bytes->starts_with("glTF");
  } else if constexpr (std::is_same_v<T, SharedField>) {
    return value != nullptr && !std::isnan(value_at(*value, {0.3, -0.2, 0.5}));
  } else if constexpr (std::is_same_v<T, Point>) {
    return is_finite(value) || value == Point::at_infinity();
  } else if constexpr (std::is_same_v<T, Circle> || std::is_same_v<T, Sphere>) {
    return coordinates(value).has_value();
  } else if constexpr (std::is_same_v<T, double>) {
    return std::isfinite(value);
  } else if constexpr (std::is_same_v<T, Vector>) {
    return is_finite(value);
  } else {
    return is_finite(value.no_e) && is_finite(value.e_e) && is_finite(value.e_ni) && std::isfinite(value.no_ni);
  }
}

/// Every value of a node is whole, or there is a problem with a place and a reason.
void require_whole_or_refused(const Json& nodes) {
  CatalogueGraph graph = graph_of(nodes);
  if (graph.static_problems().empty() && graph.plan().cost.samples > most_of_an_extreme) return;
  for (const Problem& problem : graph.problems("subject")) {
    CAPTURE(problem.code, problem.detail, problem.node, problem.pointer.value_or(""));
    static const std::set<std::string> codes = {"degenerate",     "at-infinity",  "out-of-range", "non-finite",
                                                "limit-exceeded", "check-failed", "encode-failed"};
    CHECK(codes.contains(problem.code));
    CHECK_FALSE(problem.node.empty());
    CHECK(problem.pointer.value_or("").starts_with("/nodes/" + problem.node));
    CHECK_FALSE(problem.detail.empty());
    return;
  }
  for (const OutputPort& output : graph.planned("subject").type->outputs) {
    const Value value = graph.value("subject." + output.name);
    const bool whole = std::visit(
        [](const auto& column) {
          for (std::size_t i = 0; i < column->size(); ++i) {
            if (!is_whole((*column)[i])) return false;
          }
          return true;
        },
        value.column);
    CAPTURE(output.name, nodes.dump());
    CHECK(whole);
  }
}

std::vector<Json> extreme_literals(const InputPort& port) {
  std::vector<Json> literals;
  for (const WireType type : port.types) {
    for (const double number : extremes()) {
      if (type == WireType::number) literals.push_back(number);
      if (type == WireType::vector || type == WireType::point) {
        literals.push_back({number, 0, 0});
        literals.push_back({0.3, 0.4, number});
        literals.push_back({number, number, number});
      }
    }
  }
  return literals;
}

}  // namespace

TEST_CASE("Every node runs at every hard bound") {
  for_every_bound([](const Subject& subject, const InputPort& port, double bound, double) {
    CAPTURE(bound);
    Json literals = least_counts(subject);
    literals[port.name] = literal_of(port, bound);
    CatalogueGraph graph = graph_of(wired_nodes(subject, {.literals = literals}));
    const bool sound = graph.static_problems().empty();
    const bool small = sound && graph.plan().cost.samples <= most_evaluated && graph.plan().cost.work <= most_work;
    for (const Problem& problem : small ? graph.problems("subject") : graph.static_problems()) {
      // A circle may be made smaller than its coefficients can hold, and a field be moved farther than can be undone.
      const WireType made = subject.overload->outputs.front().type;
      const bool may_vanish = made == WireType::circle || made == WireType::sphere || made == WireType::field;
      if (problem.code == "degenerate" && may_vanish) continue;
      FAIL_CHECK(problem.code << " at " << problem.node << "." << problem.port << ": " << problem.detail);
    }
  });
}

TEST_CASE("Every node refuses a literal just outside a hard bound, and says what it takes") {
  for_every_bound([](const Subject& subject, const InputPort& port, double bound, double direction) {
    const CatalogueGraph graph =
        graph_of(wired_nodes(subject, {.literals = {{port.name, beyond(port, bound, direction)}}}));
    REQUIRE(codes(graph.static_problems()) == std::multiset<std::string>{"out-of-range subject." + port.name});
    const Problem& problem = graph.static_problems().front();
    CHECK(problem.pointer == "/nodes/subject/inputs/" + port.name);
    CHECK(problem.fix[0]["value"] == literal_of(port, bound));
  });
}

TEST_CASE("Every node refuses a wired number just outside a hard bound") {
  for_every_bound([](const Subject& subject, const InputPort& port, double bound, double direction) {
    if (is_integer(port)) return;
    Json nodes = wired_nodes(subject, {});
    nodes["outside"] = make("number", {{"value", beyond(port, bound, direction)}});
    nodes["subject"]["inputs"][port.name] = from("outside");
    CatalogueGraph graph = graph_of(nodes);
    CHECK(codes(graph.problems("subject")) == std::multiset<std::string>{"out-of-range subject." + port.name});
  });
}

TEST_CASE("Every node makes whole values of extreme literals, or says why not") {
  for (const Subject& subject : all_subjects()) {
    for (const InputPort& port : subject.type->inputs) {
      if (port.required()) continue;
      for (const Json& literal : extreme_literals(port)) {
        CAPTURE(subject.name(), port.name, literal.dump());
        Json literals = few_counts(subject);
        literals[port.name] = literal;
        require_whole_or_refused(wired_nodes(subject, {.literals = literals}));
      }
    }
  }
}

TEST_CASE("Every node makes whole values of elements with extreme numbers, or says why not") {
  for (const Subject& subject : all_subjects()) {
    for (std::size_t port = 0; port < subject.type->inputs.size(); ++port) {
      if (!can_be_lifted(subject, port)) continue;
      const std::string& driven = subject.type->inputs[port].name;
      const bool everything = subject.overload->inputs[port].optional;
      Json literals = few_counts(subject);
      literals.erase(driven);
      for (const double number : extremes()) {
        CAPTURE(subject.name(), driven, number);
        require_whole_or_refused(
            wired_nodes(subject, {.everything = everything, .driven = driven, .drive = number, .literals = literals}));
      }
    }
  }
}

TEST_CASE("A color by number of the ends of all numbers is a color") {
  for (const double value : {-1e308, 0.0, 1e308, 1.7e308}) {
    for (const char* palette : {"cyclic", "diverging", "sequential"}) {
      for (const auto& [least, most] :
           std::vector<std::pair<double, double>>{{-1e308, 1e308}, {1e308, -1e308}, {0, 5e-324}, {-1.7e308, -1e308}}) {
        CAPTURE(value, palette, least, most);
        require_whole_or_refused({{"ball", make("sphere_mesh", {{"segments", 6}, {"rings", 4}})},
                                  {"subject", make("color_by", {{"shape", from("ball")},
                                                                {"value", value},
                                                                {"minimum", least},
                                                                {"maximum", most},
                                                                {"palette", palette}})}});
      }
    }
  }
}
