// What every node of the catalogue must do, whichever it is.

#include <catch2/catch.hpp>
#include <cmath>

#include "graph/card.h"
#include "graph/node_builder.h"
#include "tests/nodes/node_inputs.h"

using namespace dini;
using namespace dini::support;

namespace {

bool is_sentence(const std::string& text) { return !text.empty() && text.ends_with('.'); }

std::vector<AnyColumn> outputs_of(CatalogueGraph& graph) {
  std::vector<AnyColumn> columns;
  for (const OutputPort& port : graph.planned("subject").type->outputs)
    columns.push_back(graph.value("subject." + port.name).column);
  return columns;
}

/// Requires that a graph has no problem, and says which it has.
void require_right(CatalogueGraph& graph) {
  for (const Problem& problem : graph.problems("subject")) {
    FAIL_CHECK(problem.code << " at " << problem.node << "." << problem.port << ": " << problem.detail);
  }
}

/// Numbers to lift an input over.
std::vector<double> drives_of(const Subject& subject, const std::string& port) {
  // A check fails when what is checked is below its least value.
  if (subject.type->id == "check" && port == "minimum") return {-0.5, 0.1, 0.3};
  return {0.35, 0.5, 0.85};
}

struct DoubledInputs {
  double value;
};

double doubled(const DoubledInputs& in) { return 2 * in.value; }

}  // namespace

TEST_CASE("Every card is complete") {
  for (const auto& [id, type] : catalogue().types()) {
    CAPTURE(id);
    CHECK(std::isupper(static_cast<unsigned char>(type.title.front())));
    CHECK(is_sentence(type.doc));
    CHECK((type.details.empty() || is_sentence(type.details)));
    for (const std::string& word : type.synonyms) {
      CAPTURE(word);
      CHECK_FALSE(word.empty());
      CHECK(std::none_of(word.begin(), word.end(), [](unsigned char c) { return std::isupper(c) || c == '_'; }));
      CHECK(std::count(type.synonyms.begin(), type.synonyms.end(), word) == 1);
    }
    CHECK(type.version >= 1);
    CHECK_FALSE(type.outputs.empty());
    const Json families = family_titles();
    CHECK(std::any_of(families.begin(), families.end(),
                      [&](const Json& family) { return family["name"] == type.family; }));
    for (const InputPort& port : type.inputs) {
      CAPTURE(port.name);
      const InputSpec& spec = port.spec;
      CHECK(is_sentence(port.doc));
      CHECK_FALSE(port.types.empty());
      CHECK(spec.minimum.has_value() == spec.maximum.has_value());
      CHECK(spec.soft_minimum.has_value() == spec.soft_maximum.has_value());
      if (spec.minimum) CHECK(*spec.minimum < *spec.maximum);
      if (spec.soft_minimum) CHECK(*spec.soft_minimum < *spec.soft_maximum);
      if (spec.minimum && spec.soft_minimum) CHECK(*spec.soft_minimum >= *spec.minimum);
      if (spec.maximum && spec.soft_maximum) CHECK(*spec.soft_maximum <= *spec.maximum);
      CHECK((port.types.front() == WireType::choice) == !port.choices.empty());
    }
    for (const OutputPort& port : type.outputs) {
      CAPTURE(port.name);
      CHECK(is_sentence(port.doc));
    }
  }
}

TEST_CASE("Every card tells in JSON what the declaration says") {
  for (const auto& [id, type] : catalogue().types()) {
    CAPTURE(id);
    const Json shown = card(type);
    CHECK(shown["id"] == id);
    CHECK(shown["synonyms"] == type.synonyms);
    REQUIRE(shown["inputs"].size() == type.inputs.size());
    for (std::size_t port = 0; port < type.inputs.size(); ++port) {
      const Json& input = shown["inputs"][port];
      CHECK(input["required"] == type.inputs[port].required());
      CHECK(input["several"] == type.inputs[port].spec.takes_several);
      CHECK(input.contains("default") == !type.inputs[port].spec.default_value.is_null());
      CHECK(input.contains("min") == type.inputs[port].spec.minimum.has_value());
    }
    CHECK(shown["outputs"].size() == type.outputs.size());
  }
}

TEST_CASE("The title of an input is the words of its name unless the card has better ones") {
  const NodeType& type = *catalogue().find("surface");
  const Json inputs = card(type)["inputs"];
  CHECK(inputs[type.input_index("clip_radius")]["title"] == "Clip radius");
  const NodeType better = node("doubled", doubled)
                              .title("Doubled")
                              .family("numbers")
                              .doc("Twice a number.")
                              .input("value", &DoubledInputs::value, "A number.", defaults(1).title("Half of it"))
                              .output("value", "Twice the number.");
  CHECK(card(better)["inputs"][0]["title"] == "Half of it");
  CHECK(card(better)["outputs"][0]["title"] == "Value");
}

TEST_CASE("A card tells which text names an axis that the node makes, and what an empty one means") {
  const auto input = [](const std::string& id, const std::string& name) {
    const NodeType& type = *catalogue().find(id);
    return card(type)["inputs"][type.input_index(name)];
  };
  CHECK(input("range", "axis")["makes_axis"] == true);
  CHECK(input("range", "axis")["empty_means"] == "the id of this node");
  CHECK(input("grid", "axis_u")["makes_axis"] == true);
  CHECK_FALSE(input("grid", "axis_u").contains("empty_means"));
  CHECK_FALSE(input("warp", "over").contains("makes_axis"));
  CHECK(input("warp", "over")["empty_means"] == "the last axis that is left");
  CHECK_FALSE(input("circle", "radius").contains("empty_means"));
  for (const auto& [id, type] : catalogue().types()) {
    CAPTURE(id);
    const Json shown = card(type);
    std::size_t made = 0;
    for (const Json& one : shown["inputs"]) made += one.contains("makes_axis") ? 1 : 0;
    // Copies along a curve run over the axis of the curve, which somebody else has named.
    if (type.axes && id != "array_along") CHECK(made > 0);
  }
}

TEST_CASE("Every handle sets a point, a vector or a number and stands at inputs of the same node") {
  std::size_t handles = 0;
  for (const auto& [id, type] : catalogue().types()) {
    for (const InputPort& port : type.inputs) {
      if (!port.spec.handle) continue;
      CAPTURE(id, port.name);
      ++handles;
      const auto takes = [&](const std::string& name, WireType wanted) {
        const InputPort* found = type.find_input(name);
        REQUIRE(found != nullptr);
        return std::count(found->types.begin(), found->types.end(), wanted) == 1;
      };
      const auto& [kind, at, normal] = *port.spec.handle;
      CHECK(takes(port.name, kind == Handle::Kind::position    ? WireType::point
                             : kind == Handle::Kind::direction ? WireType::vector
                                                               : WireType::number));
      if (!at.empty()) CHECK(takes(at, WireType::point));
      if (!normal.empty()) CHECK(takes(normal, WireType::vector));
      CHECK_FALSE(port.spec.takes_several);
      CHECK(card(type)["inputs"][type.input_index(port.name)]["handle"]["kind"].is_string());
    }
  }
  CHECK(handles > 40);
  CHECK(card(*catalogue().find("circle"))["inputs"][2]["handle"] ==
        Json({{"kind", "radius"}, {"at", "center"}, {"normal", "normal"}}));
  CHECK_FALSE(card(*catalogue().find("twist"))["inputs"][2].contains("handle"));
}

namespace {

struct MoveInputs {
  Point a;
  Vector b;
};

Point moved(const MoveInputs& in) { return in.a; }

/// Of a function whose inputs have a base.
struct CarryInputs : MoveInputs {
  double amount;
};

double carried(const Point&, const CarryInputs& in) { return in.amount; }

/// A card that lacks nothing but inputs.
template <class... Functions>
auto toy(Functions... functions) {
  return node("toy", functions...).title("Toy").family("toys").doc("A toy.").output("result", "R.");
}

}  // namespace

TEST_CASE("A card whose handle stands at no place is refused") {
  const auto add = [](InputSpec spec) {
    Registry registry;
    registry.add(toy(moved).input("a", &MoveInputs::a, "P.").input("b", &MoveInputs::b, "V.", std::move(spec)));
  };
  CHECK_NOTHROW(add(required().direction_handle("a")));
  CHECK_THROWS_AS(add(required().direction_handle("b")), std::logic_error);
  CHECK_THROWS_AS(add(required().direction_handle("c")), std::logic_error);
  CHECK_THROWS_AS(add(required().position_handle()), std::logic_error);
  CHECK_THROWS_AS(add(required().radius_handle("a")), std::logic_error);
}

TEST_CASE("A card that leaves out what a function takes, or gives it twice, is refused") {
  const auto refusal = [](auto builder) {
    try {
      Registry registry;
      registry.add(std::move(builder));
    } catch (const std::logic_error& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  CHECK(refusal(toy(moved).input("a", &MoveInputs::a, "P.").input("b", &MoveInputs::b, "V.")).empty());
  CHECK(refusal(toy(moved).input("a", &MoveInputs::a, "P.")) ==
        "node type \"toy\": the card describes 1 of the 2 members of a function's inputs");
  CHECK(refusal(toy(moved).input("a", &MoveInputs::a, "P.").input("c", &MoveInputs::a, "V.")) ==
        "node type \"toy\": two inputs go to one member");
  const auto carry = [] { return toy(carried).input("shape", "P."); };
  CHECK(refusal(carry()
                    .input("a", &CarryInputs::a, "P.")
                    .input("b", &CarryInputs::b, "V.")
                    .input("amount", &CarryInputs::amount, "A."))
            .empty());
  CHECK(refusal(carry().input("a", &CarryInputs::a, "P.").input("amount", &CarryInputs::amount, "A.")) ==
        "node type \"toy\": the card describes 2 of the 3 members of a function's inputs");
  CHECK(refusal(carry().input("amount", &CarryInputs::amount, "A.")) ==
        "node type \"toy\": the card describes 1 of the 2 members of a function's inputs");
  CHECK(refusal(toy(carried)
                    .input("a", &CarryInputs::a, "P.")
                    .input("b", &CarryInputs::b, "V.")
                    .input("amount", &CarryInputs::amount, "A.")) ==
        "node type \"toy\": the card does not describe the value that a function takes by itself");
  CHECK_THROWS_AS(toy(moved).input("shape", "P."), std::logic_error);
  CHECK_THROWS_AS(carry().input("again", "P."), std::logic_error);
}

TEST_CASE("Every function of every node runs with its defaults, and with everything wired") {
  for (const Subject& subject : all_subjects()) {
    for (const bool everything : {false, true}) {
      CAPTURE(subject.name(), everything);
      CatalogueGraph graph = graph_of(wired_nodes(subject, {.everything = everything}));
      require_right(graph);
      CHECK(graph.planned("subject").overload == subject.overload);
    }
  }
}

TEST_CASE("Every node in draft quality runs too") {
  for (const Subject& subject : all_subjects()) {
    CAPTURE(subject.name());
    CatalogueGraph graph = graph_of(wired_nodes(subject, {}), Quality::draft);
    require_right(graph);
  }
}

TEST_CASE("Every node gives the same result twice") {
  for (const Subject& subject : all_subjects()) {
    CAPTURE(subject.name());
    const Json nodes = wired_nodes(subject, {.everything = true});
    CatalogueGraph first = graph_of(nodes), second = graph_of(nodes);
    const std::vector<AnyColumn> a = outputs_of(first), b = outputs_of(second);
    for (std::size_t output = 0; output < a.size(); ++output) CHECK(same_content(a[output], b[output]));
  }
}

TEST_CASE("Every node lifted over one more axis equals the loop of single calls") {
  for (const Subject& subject : all_subjects()) {
    for (std::size_t port = 0; port < subject.type->inputs.size(); ++port) {
      if (!can_be_lifted(subject, port) || subject.overload->inputs[port].is_mixed())
        continue;  // mixed inputs keep their values apart
      const std::string& driven = subject.type->inputs[port].name;
      const std::vector<double> drives = drives_of(subject, driven);
      CAPTURE(subject.name(), driven);
      // Inputs that may be left out can depend on one another, so they are wired all or none.
      const bool everything = subject.overload->inputs[port].optional;
      const Json over = consumed_names(subject);
      CatalogueGraph lifted = graph_of(
          wired_nodes(subject, {.everything = everything, .driven = driven, .drive = drives, .literals = over}));
      const std::vector<AnyColumn> whole = outputs_of(lifted);
      for (std::size_t output = 0; output < whole.size(); ++output) {
        REQUIRE(lifted.planned("subject").outputs[output].axes.front() == Axis{"extra", 3, false});
      }
      for (std::size_t i = 0; i < drives.size(); ++i) {
        CAPTURE(i);
        CatalogueGraph single = graph_of(
            wired_nodes(subject, {.everything = everything, .driven = driven, .drive = drives[i], .literals = over}));
        const std::vector<AnyColumn> part = outputs_of(single);
        for (std::size_t output = 0; output < whole.size(); ++output) {
          const std::size_t size = sample_count(single.planned("subject").outputs[output].axes);
          CHECK(same_content(whole[output], i * size, size, part[output]));
        }
      }
    }
  }
}

TEST_CASE("Every node's fingerprint depends on every literal, but not on the names of axes") {
  for (const Subject& subject : all_subjects()) {
    const CatalogueGraph usual = graph_of(wired_nodes(subject, {}));
    for (const InputPort& port : subject.type->inputs) {
      const std::optional<Json> literal = other_literal(port);
      if (!literal) continue;
      CAPTURE(subject.name(), port.name, *literal);
      if (port.spec.is_axis_name) {
        if (!std::count(subject.type->over.begin(), subject.type->over.end(), port.name)) {
          const CatalogueGraph renamed = graph_of(wired_nodes(subject, {.literals = {{port.name, "other"}}}));
          CHECK(renamed.planned("subject").fingerprint == usual.planned("subject").fingerprint);
        }
        continue;
      }
      const CatalogueGraph changed = graph_of(wired_nodes(subject, {.literals = {{port.name, *literal}}}));
      for (const Problem& problem : changed.static_problems()) FAIL_CHECK(problem.detail);
      CHECK(changed.planned("subject").fingerprint != usual.planned("subject").fingerprint);
    }
  }
}
