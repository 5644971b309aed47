#pragma once

// Small graphs of real nodes: written in one line each, evaluated, and looked at.

#include "geometry/obj_reader.h"
#include "graph/value_json.h"
#include "nodes/all.h"
#include "tests/support/graphs.h"

namespace dini::support {

/// The whole catalogue, built once.
inline const Registry& catalogue() {
  static const Registry registry = [] {
    Registry filled;
    add_all_nodes(filled);
    return filled;
  }();
  return registry;
}

/// A strip of all gray values of 8 bits: vertex i has the value i and stands at x = i.
inline std::string gray_strip() {
  std::string text;
  for (int i = 0; i < 256; ++i) {
    const std::string gray = std::to_string(i);
    text += "v " + gray + (i % 2 == 0 ? " 0 0 " : " 9 0 ") + gray + " " + gray + " " + gray + "\n";
    if (i >= 2) text += i % 2 == 0 ? "f -3 -1 -2\n" : "f -3 -2 -1\n";
  }
  return text;
}

/// The files that the graphs of the tests may name: `gray`, `triangle`, `square` with colors and texture coordinates,
/// `far` with a texture coordinate far off, and `short` with things that are left out.
inline SharedAssetFile test_file(std::string_view name) {
  const std::string text = name == "gray"       ? gray_strip()
                           : name == "triangle" ? "v 0 0 0\nv 1 0 0\nv 0 1 0.5\nf 1 2 3\n"
                           : name == "square"   ? "v 0 0 0 1 0 0\nv 1 0 0 0 1 0\nv 1 1 0 0 0 1\nv 0 1 0 1 1 1\n"
                                                  "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nf 1/1 2/2 3/3 4/4\n"
                           : name == "far"      ? "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 1\nvt 1 1\nvt 1 -1e5\n"
                                                  "f 1/1 2/2 3/3\n"
                           : name == "short"    ? "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 1 2\nl 1 2\n"
                                                : "";
  if (text.empty()) return nullptr;
  return std::make_shared<const AssetFile>(AssetFile{sha256(text), text.size(), *read_obj(text, {}), nullptr});
}

class CatalogueGraph;
CatalogueGraph graph_of(const Json& nodes, Quality quality);

/// A graph of catalogue nodes, evaluated place by place as it is asked for.
class CatalogueGraph {
 public:
  /// What is wrong before anything is computed.
  const Problems& static_problems() const { return report_.problems; }
  const Plan& plan() const { return report_.plan; }
  const PlannedNode& planned(const std::string& node) const { return plan().nodes[plan().index.at(node)]; }

  /// Everything the evaluation of a node says: its problems, those before it included, or none.
  Problems problems(const std::string& node) {
    if (!static_problems().empty()) return static_problems();
    const Result<Evaluation> evaluation = run(node);
    return evaluation ? Problems{} : evaluation.problems();
  }

  /// The value at "node" or "node.output" of a graph that is right.
  Value value(const std::string& place) {
    const std::string node = place.substr(0, place.find('.'));
    for (const Problem& problem : static_problems()) {
      FAIL(problem.code << " at " << problem.node << "." << problem.port << ": " << problem.detail);
    }
    const Result<Evaluation> evaluation = run(node);
    for (const Problem& problem : evaluation ? Problems{} : evaluation.problems()) {
      FAIL(problem.code << " at " << problem.node << "." << problem.port << ": " << problem.detail);
    }
    const std::size_t index = plan().index.at(node);
    warnings_.clear();
    for (const auto& said : evaluation->run(plan().nodes[index])->result->warnings) {
      if (said->fingerprint == plan().nodes[index].fingerprint) warnings_ = said->warnings;
    }
    return evaluation->value(plan(), index, output_index(node, place));
  }

  /// The warnings of the node that was asked for last.
  const std::vector<Warning>& warnings() const { return warnings_; }

  Json json(const std::string& place, bool full = false) { return to_json(value(place), full); }

  /// The only value at a place.
  template <class T>
  T one(const std::string& place) {
    return all<T>(place).at(0);
  }

  template <class T>
  std::vector<T> all(const std::string& place) {
    const Value found = value(place);
    const Column<T>& column = column_of<T>(found);
    std::vector<T> values;
    for (std::size_t i = 0; i < column.size(); ++i) values.push_back(column[i]);
    return values;
  }

 private:
  friend CatalogueGraph graph_of(const Json& nodes, Quality quality);

  CatalogueGraph(const Json& nodes, Quality quality) {
    const Result<Document> read = read_document(document(nodes), Limits{}, catalogue());
    for (const Problem& problem : read ? Problems{} : read.problems())
      FAIL(problem.pointer.value_or("") << ": " << problem.detail);
    report_ = check(catalogue(), *read, {}, quality, {}, test_file);
  }

  Result<Evaluation> run(const std::string& node) { return evaluate(plan(), {plan().index.at(node)}, cache_, job_); }

  std::size_t output_index(const std::string& node, const std::string& place) const {
    if (place == node) return 0;
    const NodeType& type = *planned(node).type;
    return type.output_index(place.substr(node.size() + 1));
  }

  CheckReport report_;
  Cache cache_{std::size_t{256} << 20};
  Job job_;
  std::vector<Warning> warnings_;
};

inline CatalogueGraph graph_of(const Json& nodes, Quality quality = Quality::final) { return {nodes, quality}; }

}  // namespace dini::support
