#include "service/document_graph.h"

namespace dini {

namespace {

Result<Document> document_of(const Json& json, const Limits& limits, const Registry& registry) {
  Result<Document> document = read_document(json, limits, registry);
  if (document) {
    document->schema = std::nullopt;
    document->meta = nullptr;
    document->ui = nullptr;
  }
  return document;
}

std::size_t memory_of(const WrittenLiteral& literal) {
  constexpr std::size_t per_reading = 256;
  return per_reading + 2 * literal.written.dump().size();
}

std::size_t memory_of(const Document& document) {
  constexpr std::size_t per_node = 256, per_item = 128, per_parameter = 1024;
  std::size_t total = per_parameter * document.parameters.size();
  for (const auto& [id, node] : document.nodes) {
    total += per_node;
    for (const auto& [port, input] : node.inputs) {
      for (const InputItem& item : input.items) {
        const auto* literal = std::get_if<WrittenLiteral>(&item);
        total += per_item + (literal != nullptr ? memory_of(*literal) : 0);
      }
    }
  }
  return total;
}

}  // namespace

DocumentGraph::DocumentGraph(const Json& json, const Digest& known_hash, const Limits& limits, const Registry& registry)
    : document(document_of(json, limits, registry)) {
  hash = known_hash;
  held = sizeof(DocumentGraph) + (document ? memory_of(*document) : 0);
}

}  // namespace dini
