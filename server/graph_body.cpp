#include "server/graph_body.h"

#include "server/graphs.h"
#include "server/handlers.h"

namespace dini::server {
namespace {

Problem unknown_graph(Problem problem) {
  if (problem.code == "not-found") problem.code = "unknown-graph";
  problem.pointer = "/graph";
  problem.in_request = true;
  return problem;
}

}  // namespace

Result<GraphBody> read_graph_body(const Context& context) {
  auto json = read_json(context);
  if (!json) return json.problems();
  const auto graph = json->is_object() ? json->find("graph") : json->end();
  if (graph == json->end() || !graph->is_string()) return GraphBody{*std::move(json)};
  const auto stored = stored_graph(context, graph->get_ref<const std::string&>());
  if (!stored) return unknown_graph(stored.problems().front());
  auto document = parse_json(*stored->document, context.engine().limits());
  if (!document) return document.problems();
  *graph = *std::move(document);
  return GraphBody{*std::move(json), true};
}

}  // namespace dini::server
