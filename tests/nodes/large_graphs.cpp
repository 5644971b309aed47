#include "tests/nodes/large_graphs.h"

#include <algorithm>
#include <cmath>

namespace dini::support {

namespace {

/// A mesh of a family, with its sources, is as much work as so many numbers.
constexpr std::size_t numbers_per_mesh = 50;

/// And so many for a field, which is an object of its own.
constexpr std::size_t numbers_per_field = 2;

bool is_count(const InputPort& port) {
  constexpr double large = 1000;
  return port.types.front() == WireType::integer && port.spec.maximum && *port.spec.maximum >= large &&
         port.name != "seed";
}

/// Quads along each edge of a box, and the like: as many squared as the faces have.
bool is_small_count(const InputPort& port) {
  constexpr double small = 500;
  return port.types.front() == WireType::integer && port.spec.maximum && *port.spec.maximum >= small && !is_count(port);
}

/// All counts alike, so that what they make together is about `size`; nothing for a node without.
Json counts_for(const NodeType& type, std::size_t size) {
  Json counts = Json::object();
  const auto number = std::count_if(type.inputs.begin(), type.inputs.end(), is_count);
  const double each = std::pow(static_cast<double>(size), 1.0 / static_cast<double>(std::max<long>(1, number)));
  for (const InputPort& port : type.inputs) {
    if (is_count(port)) counts[port.name] = static_cast<std::int64_t>(std::min(each, *port.spec.maximum));
    if (is_small_count(port)) {
      const double edge = std::sqrt(static_cast<double>(size) / 6);
      counts[port.name] = static_cast<std::int64_t>(std::max(edge, port.spec.minimum.value_or(1)));
    }
  }
  return counts;
}

bool takes(const Subject& subject, std::size_t port, WireType type) {
  const std::vector<WireType>& types = subject.type->inputs[port].types;
  return subject.overload->inputs[port].is_mixed() ? std::count(types.begin(), types.end(), type) > 0
                                                   : subject.overload->inputs[port].type == type;
}

/// What an input that keeps its values apart can be given besides meshes.
std::vector<Json> mixed_graphs(const Subject& subject, const std::string& port, std::size_t size) {
  std::vector<Json> graphs;
  const auto add = [&](const std::string& id, Json nodes) {
    nodes["subject"] = make(subject.type->id, {{port, from(id)}});
    graphs.push_back(std::move(nodes));
  };
  const Json points = make("random", {{"count", size}});
  if (takes(subject, subject.type->input_index(port), WireType::point)) add("points.points", {{"points", points}});
  if (takes(subject, subject.type->input_index(port), WireType::circle)) {
    add("rings", {{"points", make("random", {{"count", size / numbers_per_mesh}})},
                  {"rings", make("circle", {{"center", from("points.points")}})}});
  }
  return graphs;
}

}  // namespace

std::vector<Json> large_graphs(const Subject& subject, std::size_t size) {
  std::vector<Json> graphs;
  const Json counts = counts_for(*subject.type, size);
  if (!counts.empty()) graphs.push_back(wired_nodes(subject, {.literals = counts}));
  if (subject.overload->consumed_axes() > 0) graphs.push_back(wired_nodes(subject, {.consumed = size}));
  const bool makes_meshes = subject.overload->outputs.front().type == WireType::mesh;
  const bool makes_fields = subject.overload->outputs.front().type == WireType::field;
  bool lifted = false;
  for (std::size_t port = 0; port < subject.type->inputs.size(); ++port) {
    const InputPort& card = subject.type->inputs[port];
    const bool mesh = takes(subject, port, WireType::mesh);
    if (mesh) graphs.push_back(wired_nodes(subject, {.vertices = size}));
    if (subject.overload->inputs[port].is_mixed()) {
      for (Json& graph : mixed_graphs(subject, card.name, size)) graphs.push_back(std::move(graph));
    }
    if (lifted || !can_be_lifted(subject, port) || subject.overload->inputs[port].optional) continue;
    lifted = true;
    const std::size_t values = mesh || makes_meshes ? size / numbers_per_mesh
                               : makes_fields       ? size / numbers_per_field
                                                    : size;
    Json literals = consumed_names(subject);
    if (makes_meshes) literals.update(counts_for(*subject.type, numbers_per_mesh));
    if (makes_fields) literals.update(counts_for(*subject.type, numbers_per_field));
    graphs.push_back(wired_nodes(subject, {.driven = card.name, .drive = {{"count", values}}, .literals = literals}));
  }
  return graphs;
}

}  // namespace dini::support
