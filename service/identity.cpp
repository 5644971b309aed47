#include "service/identity.h"

#include <algorithm>

#include "graph/canonical_json.h"

namespace dini {

Digest identity_of(const EvaluateRequest& request) {
  DigestBuilder digest;
  digest.text("evaluate").digest(request.graph->hash).text(canonical_json(request.parameters)).text(request.output);
  digest.integer(static_cast<std::uint64_t>(request.quality)).integer(request.triangle_budget ? 1 : 0);
  digest.integer(static_cast<std::uint64_t>(request.triangle_budget.value_or(0)));
  digest.integer(request.preview.size());
  for (const std::string& place : request.preview) digest.text(place);
  digest.integer(request.measures.size());
  for (const std::string& place : request.measures) digest.text(place);
  digest.integer(request.parts ? 1 : 0).integer(request.without_output ? 1 : 0);
  digest.text(request.format).integer(request.draco ? 1 : 0).integer(request.embed_graph ? 1 : 0);
  if (request.embed_graph) digest.text(canonical_json(request.notes));
  return digest.finish();
}

std::size_t memory_of(const EvaluateRequest& request) {
  constexpr std::size_t per_value = 4;  // of a text, once it is JSON
  std::size_t total = 1024 + request.graph->held;
  total += per_value * (request.parameters.dump().size() + request.notes.dump().size());
  for (const auto* places : {&request.preview, &request.measures}) {
    for (const std::string& place : *places) total += sizeof(std::string) + place.size();
  }
  return total;
}

Digest identity_of(const InspectRequest& request) {
  DigestBuilder digest;
  digest.text("inspect").digest(request.graph->hash).text(canonical_json(request.parameters));
  return digest.text(request.node).text(request.output).integer(request.full ? 1 : 0).finish();
}

}  // namespace dini
