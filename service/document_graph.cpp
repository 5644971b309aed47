#include "service/document_graph.h"

#include "graph/groups.h"
#include "graph/literal.h"

namespace dini {

namespace {

/// The unit that the notes of a document say is one, or they say none.
Result<Document> with_right_unit(Result<Document> document) {
  if (!document || !document->meta.is_object() || !document->meta.contains("unit")) return document;
  if (unit_of(document->meta)) return document;
  return Problem{.code = "not-in-choices",
                 .detail = "got " + excerpt(document->meta["unit"]) +
                           ", accepted are \"m\", \"cm\", \"mm\" and \"in\": what coordinates count",
                 .pointer = "/meta/unit"};
}

Result<Document> without_notes(Result<Document> document) {
  if (document) {
    document->schema = std::nullopt;
    document->meta = nullptr;
    document->ui = nullptr;
  }
  return document;
}

Result<Document> without_groups(Result<Document> document, const Limits& limits, const Registry& registry) {
  return document ? expanded(*std::move(document), limits, registry) : document;
}

std::size_t memory_of(const WrittenLiteral& literal) {
  constexpr std::size_t per_reading = 256;
  return per_reading + 2 * literal.written.dump().size();
}

std::size_t memory_of(const std::map<std::string, NodeEntry>& nodes) {
  constexpr std::size_t per_node = 256, per_item = 128;
  std::size_t total = 0;
  for (const auto& [id, node] : nodes) {
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

std::size_t memory_of(const Document& document) {
  constexpr std::size_t per_parameter = 1024, per_place = 512, per_socket = 512;
  std::size_t total = per_parameter * document.parameters.size() + memory_of(document.nodes);
  total += per_place * (document.places.size() + document.instances.size());
  for (const auto& [name, group] : document.groups) {
    total += per_socket * (1 + group.inputs.size() + group.outputs.size()) + memory_of(group.nodes);
  }
  return total;
}

}  // namespace

DocumentGraph::DocumentGraph(const Json& json, const Digest& known_hash, const Limits& limits, const Registry& registry)
    : DocumentGraph(without_notes(with_right_unit(read_document(json, limits, registry))),
                    unit_of(json.is_object() ? json.value("meta", Json()) : Json()), known_hash, limits, registry) {}

DocumentGraph::DocumentGraph(Result<Document> read, std::optional<LengthUnit> known_unit, const Digest& known_hash,
                             const Limits& limits, const Registry& registry)
    : with_groups(read && !read->groups.empty() ? std::optional(*read) : std::nullopt),
      document(without_groups(std::move(read), limits, registry)),
      unit(known_unit) {
  hash = known_hash;
  held = sizeof(DocumentGraph) + (document ? memory_of(*document) : 0) + (with_groups ? memory_of(*with_groups) : 0);
}

}  // namespace dini
