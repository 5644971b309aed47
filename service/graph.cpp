#include "service/graph.h"

#include <array>

#include "graph/canonical_json.h"
#include "graph/document.h"

namespace dini {

namespace {

constexpr std::array<std::string_view, 3> notes = {"$schema", "meta", "ui"};

}  // namespace

bool is_graph_id(std::string_view text) { return is_identifier(text); }

bool is_node_id(std::string_view text) { return is_path(text); }

Digest graph_hash(const Json& document) {
  const auto meta = document.find("meta");
  if (meta == document.end() || !meta->is_object() || !meta->contains("unit")) {
    return sha256(canonical_json(document, notes));
  }
  Json with_unit = document;
  with_unit["meta"] = {{"unit", (*meta)["unit"]}};
  return sha256(canonical_json(with_unit, std::array<std::string_view, 2>{notes[0], notes[2]}));
}

Json notes_of(const Json& document) {
  Json found = Json::object();
  for (const std::string_view name : notes) {
    const auto note = document.find(name);
    if (note != document.end() && !note->is_null()) found[std::string(name)] = *note;
  }
  return found;
}

}  // namespace dini
