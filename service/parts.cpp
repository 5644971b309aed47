#include "service/parts.h"

#include <algorithm>

#include "geometry/measure.h"
#include "geometry/solid_facts.h"
#include "graph/cost.h"
#include "graph/request_problem.h"
#include "graph/value_json.h"
#include "nodes/costs.h"
#include "nodes/drawn_scene.h"
#include "service/version.h"

namespace dini {

namespace {

const std::vector<PlannedItem>& models_of(const Plan& plan, std::size_t exported) {
  return plan.nodes[exported].inputs.front().items;
}

Source source_of(const PlannedItem& model) { return std::get<Source>(model.from); }  // an export takes wires only

Json mesh_json(const Mesh& mesh, const Cancel& cancel) {
  const Measures measures = measure(mesh, cancel);
  const SolidFacts facts = solid_facts(mesh, most_told_intersections, cancel);
  const Vector &center = facts.mass.center, &inertia = facts.mass.inertia;
  return {{"vertices", measures.vertices},
          {"triangles", measures.triangles},
          {"area", measures.area},
          {"volume", measures.volume},
          {"watertight", facts.sound.watertight},
          {"boundary_loops", facts.sound.borders},
          {"components", facts.sound.components},
          {"self_intersections", facts.contacts},
          {"least_thickness", facts.least_thickness},
          {"center_of_mass", {center.x, center.y, center.z}},
          {"inertia", {inertia.x, inertia.y, inertia.z}}};
}

Json part_json(const Part& part, const Cancel& cancel) {
  Json json = {{"name", part.name}};
  if (const auto* mesh = std::get_if<SharedMesh>(&part.shape)) {
    json["type"] = name(WireType::mesh);
    json.update(mesh_json(**mesh, cancel));
  } else if (const auto* curves = std::get_if<CurveSource>(&part.shape)) {
    json["type"] = name(WireType::circle);
    json["count"] = curves->count;
  } else {
    json["type"] = name(WireType::point);
    json["count"] = std::get<SharedColumn<Point>>(part.shape)->size();
  }
  return json;
}

}  // namespace

Result<std::vector<std::size_t>> plan_parts(Plan& plan, std::size_t exported, const Limits& limits) {
  std::vector<std::size_t> nodes;
  std::size_t parts = 0, largest = 0;
  for (const PlannedItem& model : models_of(plan, exported)) {
    nodes.push_back(source_of(model).node);
    const bool is_mesh = model.shape.type == WireType::mesh;
    const std::size_t meshes = is_mesh ? std::max<std::size_t>(1, sample_count(model.shape.axes)) : 1;
    parts += meshes;
    largest = std::max(largest, model.shape.vertices / meshes);
    plan.cost.work += static_cast<std::size_t>(work_of_solid_facts) * model.shape.vertices;
  }
  plan.cost.bytes += static_cast<std::size_t>(bytes_of_solid_facts) * largest;
  const auto refused = [](std::string detail) {
    return request_problem("/parts", "limit-exceeded", std::move(detail));
  };
  if (parts > limits.measured_values) {
    return refused("the model has " + std::to_string(parts) + " parts, of at most " +
                   std::to_string(limits.measured_values) + " a report can tell");
  }
  if (const auto problem = over_limits(plan.cost, limits, "telling of the parts too, the request")) {
    return refused(problem->detail);
  }
  return nodes;
}

Digest parts_digest(const Plan& plan, std::size_t exported) {
  DigestBuilder digest;
  digest.text("parts").text(engine_version);
  for (const PlannedItem& model : models_of(plan, exported)) {
    const Source source = source_of(model);
    const PlannedNode& node = plan.nodes[source.node];
    digest.digest(plan.nodes[standing_at(plan, source.node)].fingerprint);
    digest.integer(node.bypass ? std::get<Source>(node.bypass->from).output : source.output).text(model.origin.part);
  }
  return digest.finish();
}

Json parts_of(const Plan& plan, std::size_t exported, const Evaluation& evaluation, const Cancel& cancel) {
  Items models;
  for (const PlannedItem& model : models_of(plan, exported)) {
    const Source source = source_of(model);
    models.values.push_back(evaluation.value(plan, source.node, source.output));
    models.origins.push_back(model.origin);
  }
  Json list = Json::array();
  for (const Part& part : scene_of(models, cancel).parts) {
    if (cancel.stopped()) break;
    list.push_back(part_json(part, cancel));
  }
  return list;
}

}  // namespace dini
