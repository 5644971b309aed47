#pragma once

// What the routes under /v1/graphs share.

#include <optional>
#include <string>
#include <string_view>

#include "server/application.h"
#include "server/operation.h"

namespace dini::server {

/// A graph as an address names it: "chair" is its current version, "chair@3" one of all.
struct GraphName {
  std::string id;
  std::optional<std::int64_t> version = {};
};

/// Nothing when no graph can have that name.
std::optional<GraphName> graph_name(std::string_view text);

Problem no_graph(std::string_view name);

/// The version that an address names, or the problem that there is none.
Result<store::StoredGraph> stored_graph(const Context& context, std::string_view name);

/// The same without its document.
Result<store::GraphVersion> stored_version(const Context& context, std::string_view name);

/// The strong entity tag of a version, with its quotes.
std::string tag_of(const store::GraphVersion& version);

/// What is told of a version.
Json to_json(const Context& context, const store::GraphVersion& version);

/// The part of a path that names a graph.
Parameter graph_parameter(bool with_version);

}  // namespace dini::server
