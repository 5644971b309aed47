#include "service/measures.h"

#include <algorithm>

#include "graph/groups.h"
#include "graph/value_json.h"
#include "service/places.h"

namespace dini {

namespace {

Result<MeasureName> read_place(const Registry& registry, const Document& document, const std::string& place,
                               const std::string& pointer) {
  const auto& [id, output, has_output] = place_name(places_behind(document, place).front());
  MeasureName name{place, id};
  const auto node = document.nodes.find(id);
  if (node == document.nodes.end()) return unknown_node(document, place_name(place), pointer);
  const NodeType* type = registry.find(node->second.type);
  if (type == nullptr || !has_output) return name;  // the check of the graph reports an unknown type
  if (type->find_output(output) == nullptr) return unknown_output(*type, name.node, output, pointer);
  name.output = type->output_index(output);
  if (node->second.bypass && name.output > 0) return bypassed_output(name.node, output, pointer);
  return name;
}

Problem too_many(std::size_t count, std::size_t most, const std::string& what, std::string pointer) {
  return {.code = "limit-exceeded",
          .detail =
              "there are " + std::to_string(count) + " " + what + ", at most " + std::to_string(most) + " are accepted",
          .pointer = std::move(pointer),
          .in_request = true};
}

}  // namespace

Result<std::vector<MeasureName>> read_measures(const Registry& registry, const Document& document,
                                               const std::vector<std::string>& asked, const Limits& limits) {
  if (asked.size() > limits.measures) return too_many(asked.size(), limits.measures, "entries", "/measures");
  std::vector<MeasureName> names;
  Problems problems;
  for (std::size_t i = 0; i < asked.size(); ++i) {
    Result<MeasureName> read = read_place(registry, document, asked[i], "/measures/" + std::to_string(i));
    if (!read) {
      problems.push_back(read.problems().front());
    } else if (std::ranges::find(names, asked[i], &MeasureName::place) == names.end()) {
      names.push_back(*std::move(read));
    }
  }
  if (!problems.empty()) return problems;
  return names;
}

Result<std::vector<Measure>> plan_measures(const Plan& plan, const std::vector<MeasureName>& names,
                                           const Limits& limits) {
  std::vector<Measure> measures;
  for (const MeasureName& name : names) {
    const std::size_t node = plan.index.at(name.node);
    const std::size_t count = sample_count(plan.nodes[node].outputs[name.output].axes);
    if (count > limits.measured_values) {
      return too_many(count, limits.measured_values, "values of " + name.place, "/measures");
    }
    measures.push_back({name.place, node, name.output});
  }
  return measures;
}

Json measures_of(const PreparedGraph& prepared, const Evaluation& evaluation) {
  Json told = Json::object();
  for (const Measure& measure : prepared.measures) {
    const Value value = evaluation.value(prepared.plan, measure.node, measure.output);
    Json values = std::move(to_json(value)["values"]);
    told[measure.place] = value.axes.empty() ? std::move(values.front()) : std::move(values);
  }
  return told;
}

}  // namespace dini
