#pragma once

// What the tests of singular inputs share: which kinds there are, and that every card that speaks of one is tested.

#include <functional>
#include <set>

#include "tests/support/catalogue.h"
#include "tests/support/close.h"
#include "tests/support/triple.h"

namespace dini::support {

using Checks = std::map<std::string, std::function<void()>>;

/// Every kind of singular input that a card may speak of.
inline const std::set<std::string> kinds = {"circle to line", "coincident points", "isoclinic generators",
                                            "opposite lines", "parallel lines",    "point at a generator",
                                            "w = -1",         "zero direction",    "zero radius"};

/// Runs the checks of one kind; they must be those of the nodes whose cards list it.
inline void hold(const std::string& kind, const Checks& checks) {
  std::set<std::string> listed, checked;
  for (const auto& [id, type] : catalogue().types()) {
    for (const Degenerate& one : type.degenerate) {
      if (one.input == kind) listed.insert(id);
    }
  }
  for (const auto& [id, check] : checks) {
    checked.insert(id);
    CAPTURE(kind, id);
    check();
  }
  CHECK(checked == listed);
}

/// The node "n" of a graph must fail as degenerate, at a port.
inline void require_degenerate(const Json& nodes, const std::string& port, const std::string& code = "degenerate") {
  const Problems problems = graph_of(nodes).problems("n");
  REQUIRE(problems.size() == 1);
  CHECK(problems[0].code == code);
  CHECK(problems[0].node == "n");
  CHECK(problems[0].port == port);
}

inline Json with(const std::string& type, Json inputs, Json others = Json::object()) {
  others["n"] = make(type, std::move(inputs));
  return others;
}

inline Json value(const Json& nodes, const std::string& place = "n") {
  return graph_of(nodes).json(place)["values"][0];
}
inline Point point(const Json& nodes, const std::string& place = "n") { return graph_of(nodes).one<Point>(place); }
inline std::size_t triangles(const Json& nodes) { return value(nodes)["triangles"]; }

inline void require_line(const Json& circle, const Vector& place, const Vector& direction) {
  REQUIRE(circle.value("line", false));
  require_close(triple(circle["point"]), place, 1e-12);
  require_close(triple(circle["direction"]), direction, 1e-12);
}

inline const Json spot = make("point", {{"position", {1, 0.5, 0.25}}});

inline Json plus(Json nodes, const Json& more) {
  nodes.update(more);
  return nodes;
}

}  // namespace dini::support
