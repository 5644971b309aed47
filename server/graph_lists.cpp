// What is kept: the list of graphs, the versions of one, and what differs between two of them.

#include <algorithm>

#include "server/graphs.h"
#include "server/handlers.h"
#include "server/query.h"
#include "server/responses.h"
#include "server/text.h"
#include "service/graph_difference.h"
#include "service/requests/schema.h"

namespace dini::server {
namespace {

constexpr std::int64_t usual_page = 100;
constexpr std::int64_t largest_page = 1000;

Parameter query(std::string name, std::string doc, Json schema, Json example) {
  return {.place = Parameter::Place::query,
          .name = std::move(name),
          .doc = std::move(doc),
          .schema = std::move(schema),
          .example = std::move(example)};
}

std::string text_of(const std::map<std::string, std::string>& values, const std::string& name) {
  const auto found = values.find(name);
  return found != values.end() ? found->second : "";
}

/// A whole number of a query; left out, the usual one.
Result<std::int64_t> number_of(const std::map<std::string, std::string>& values, const std::string& name,
                               std::int64_t usual, std::int64_t most) {
  const auto found = values.find(name);
  if (found == values.end()) return usual;
  const auto number = whole_number(found->second);
  if (!number || *number < 1 || *number > static_cast<std::size_t>(most)) {
    return Problem{.code = "out-of-range",
                   .detail = "'" + name + "' in the query is a whole number from 1 to " + std::to_string(most) + "."};
  }
  return static_cast<std::int64_t>(*number);
}

Reply listed(const Json& json) {
  Reply reply = json_reply(json);
  reply.headers.emplace_back("Cache-Control", "no-cache");
  return reply;
}

Json list_of(const Context& context, const std::vector<store::GraphVersion>& versions) {
  Json list = Json::array();
  for (const store::GraphVersion& version : versions) list.push_back(to_json(context, version));
  return list;
}

std::vector<Parameter> list_parameters() {
  return {query("after", "Only graphs whose names come after this one: the `next` of the page before.",
                {{"type", "string"}}, "chair"),
          query("limit", "How many graphs a page has at most.",
                {{"type", "integer"}, {"minimum", 1}, {"maximum", largest_page}, {"default", usual_page}}, usual_page),
          query("query", "Only graphs whose name or title has this in it.", {{"type", "string"}}, "example")};
}

std::vector<Parameter> difference_parameters() {
  const Json schema = {{"type", "integer"}, {"minimum", 1}};
  return {graph_parameter(false), query("from", "The number of a version; left out, the one before `to`.", schema, 1),
          query("to", "The number of a version; left out, the newest.", schema, 1)};
}

}  // namespace

Operation describe_graph_list() {
  return {.id = "listGraphs",
          .group = "Stored graphs",
          .title = "The graphs that are kept",
          .doc = "Answers with the current versions of graphs by name, a page at a time.",
          .parameters = list_parameters(),
          .answers = {{.doc = "A page. `next` is there when more graphs come after it.",
                       .contents = {{.type = "application/json", .schema = schema::reference("GraphPage")}},
                       .headers = {"Cache-Control"}}},
          .problems = {"out-of-range", "storage-failed"}};
}

Reply graph_list(const Context& context) {
  const auto values = read_query(context.request(), query_names(list_parameters()));
  if (!values) return problem_reply(values.problems(), context.exchange());
  const auto limit = number_of(*values, "limit", usual_page, largest_page);
  if (!limit) return problem_reply(limit.problems(), context.exchange());
  const auto page = context.application.graphs.list(text_of(*values, "after"), text_of(*values, "query"),
                                                    static_cast<std::size_t>(*limit));
  if (!page) return problem_reply(page.problems(), context.exchange());
  Json answer = {{"graphs", list_of(context, page->graphs)}};
  if (page->more) answer["next"] = page->graphs.back().id;
  return listed(answer);
}

Operation describe_graph_versions() {
  return {.id = "listGraphVersions",
          .group = "Stored graphs",
          .title = "Every version of a graph",
          .doc = "The newest first; those of a deleted graph too.",
          .parameters = {graph_parameter(false)},
          .answers = {{.doc = "All versions.",
                       .contents = {{.type = "application/json", .schema = schema::reference("GraphVersions")}},
                       .headers = {"Cache-Control"}}},
          .problems = {"not-found", "storage-failed"}};
}

Reply graph_versions(const Context& context) {
  const std::string& id = context.arguments.front();
  const auto versions = context.application.graphs.versions(id);
  if (!versions) return problem_reply(versions.problems(), context.exchange());
  if (versions->empty()) return problem_reply(no_graph(id), context.exchange());
  return listed({{"versions", list_of(context, *versions)}});
}

Operation describe_graph_difference() {
  return {
      .id = "compareGraphVersions",
      .group = "Stored graphs",
      .title = "What differs between two versions of a graph",
      .doc = "Nodes, parameters and groups that were added, removed and changed; of what changed, what it was and is.",
      .parameters = difference_parameters(),
      .answers = {{.doc = "The difference.",
                   .contents = {{.type = "application/json", .schema = schema::reference("GraphDifference")}},
                   .headers = {"Cache-Control"}}},
      .problems = {"not-found", "out-of-range", "storage-failed"}};
}

Reply graph_difference(const Context& context) {
  const auto refuse = [&](const Problems& problems) { return problem_reply(problems, context.exchange()); };
  const std::string& id = context.arguments.front();
  const auto values = read_query(context.request(), query_names(difference_parameters()));
  if (!values) return refuse(values.problems());
  const auto versions = context.application.graphs.versions(id);
  if (!versions) return refuse(versions.problems());
  if (versions->empty()) return refuse({no_graph(id)});
  const std::int64_t newest = versions->front().version;
  const auto to = number_of(*values, "to", newest, newest);
  if (!to) return refuse(to.problems());
  const auto from = number_of(*values, "from", std::max<std::int64_t>(1, *to - 1), newest);
  if (!from) return refuse(from.problems());
  Json documents[2];
  for (const std::int64_t version : {*from, *to}) {
    const auto stored = stored_graph(context, id + "@" + std::to_string(version));
    if (!stored) return refuse(stored.problems());
    auto json = parse_json(*stored->document, context.engine().limits());
    if (!json) return refuse(json.problems());
    documents[version == *to ? 1 : 0] = *std::move(json);
  }
  if (*from == *to) documents[0] = documents[1];
  Json answer = dini::graph_difference(documents[0], documents[1]);
  answer["from"] = *from;
  answer["to"] = *to;
  return listed(answer);
}

}  // namespace dini::server
