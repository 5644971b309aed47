#include "server/graphs.h"

#include <charconv>

#include "server/addresses.h"
#include "server/handlers.h"
#include "server/negotiation.h"
#include "server/responses.h"
#include "server/text.h"
#include "service/requests/schema.h"

namespace dini::server {
namespace {

std::string address_of(const Context& context, const store::GraphVersion& version) {
  return std::string(context.exchange().base) + "/v1/graphs/" + version.id + "@" + std::to_string(version.version);
}

bool names_current(std::string_view header, const store::GraphVersion* current) {
  return current != nullptr && names_tag(header, tag_of(*current));
}

/// What a search of the store finds under the name in an address.
template <class Found>
Result<Found> named(const Context& context, std::string_view text,
                    Result<std::optional<Found>> (store::GraphStore::*search)(std::string_view,
                                                                              std::optional<std::int64_t>) const) {
  const auto name = graph_name(text);
  if (!name) return no_graph(text);
  auto found = (context.application.graphs.*search)(name->id, name->version);
  if (!found) return found.problems();
  if (!*found) return no_graph(text);
  context.call->note_graph((*found)->hash);
  return **std::move(found);
}

/// What the headers of a request to write ask of the current version.
store::Condition condition_of(const Request& request) {
  return [&request](const store::GraphVersion* current) {
    if (request.has_header("If-Match") && !names_current(request.header("If-Match"), current)) return false;
    return !request.has_header("If-None-Match") || !names_current(request.header("If-None-Match"), current);
  };
}

Reply precondition_failed(const Context& context, const std::string& id,
                          const std::optional<store::GraphVersion>& current) {
  const std::string detail = current ? "The current version of '" + id + "' is " + std::to_string(current->version) +
                                           ", with the tag " + tag_of(*current) + "; get it, and write with `If-Match`."
                                     : "There is no graph '" + id + "'; create it with `If-None-Match: *`.";
  Reply reply = problem_reply(Problem{.code = "precondition-failed", .detail = detail}, context.exchange());
  if (current) reply.headers.emplace_back("ETag", tag_of(*current));
  return reply;
}

/// A name for people, from what the document says of itself.
std::string title_of(const Json& document) {
  const auto meta = document.find("meta");
  if (meta == document.end() || !meta->is_object()) return {};
  const auto title = meta->find("title");
  return title != meta->end() && title->is_string() ? title->get<std::string>() : "";
}

Problem wrong_id(const std::string& id) {
  return {.code = "invalid-id",
          .detail = "A graph is kept under a letter followed by up to 63 letters, digits, '_' or '-', not '" +
                    escape_controls(id, 80) + "'."};
}

Content version_content() { return {.type = "application/json", .schema = schema::reference("GraphVersion")}; }

Parameter condition_header(const char* name, std::string doc, std::string example) {
  return {.place = Parameter::Place::header, .name = name, .doc = std::move(doc), .example = std::move(example)};
}

}  // namespace

std::optional<GraphName> graph_name(std::string_view text) {
  const auto at = text.find('@');
  GraphName name{std::string(text.substr(0, at))};
  if (!is_graph_id(name.id)) return std::nullopt;
  if (at == std::string_view::npos) return name;
  const std::string_view digits = text.substr(at + 1);
  std::int64_t version = 0;
  const auto end = std::from_chars(digits.data(), digits.data() + digits.size(), version);
  if (digits.empty() || digits.front() == '0' || end.ec != std::errc() || end.ptr != digits.data() + digits.size() ||
      version < 1) {
    return std::nullopt;
  }
  name.version = version;
  return name;
}

Problem no_graph(std::string_view name) {
  return {.code = "not-found", .detail = "There is no graph '" + escape_controls(name, 80) + "' here."};
}

Result<store::StoredGraph> stored_graph(const Context& context, std::string_view name) {
  return named(context, name, &store::GraphStore::find);
}

Result<store::GraphVersion> stored_version(const Context& context, std::string_view name) {
  return named(context, name, &store::GraphStore::look_up);
}

std::string tag_of(const store::GraphVersion& version) {
  return "\"" + std::to_string(version.version) + "-" + to_hex(version.digest).substr(0, 16) + "\"";
}

Json to_json(const Context& context, const store::GraphVersion& version) {
  return {{"id", version.id},
          {"version", version.version},
          {"title", version.title},
          {"bytes", version.bytes},
          {"hash", to_hex(version.hash)},
          {"created", time_text(version.created)},
          {"etag", tag_of(version)},
          {"address", address_of(context, version)}};
}

Parameter graph_parameter(bool with_version) {
  return {.place = Parameter::Place::path,
          .name = "id",
          .doc = with_version ? "The name of the graph, with `@` and a number for one of its versions."
                              : "The name of the graph.",
          .schema = {{"type", "string"}, {"pattern", schema::graph_name_pattern(with_version)}},
          .example = "example"};
}

Operation describe_put_graph() {
  return {
      .id = "putGraph",
      .group = "Stored graphs",
      .title = "Keeps a graph, as its next version",
      .doc =
          "Keeps a document byte for byte. `If-None-Match: *` creates a graph and replaces none; `If-Match` with the "
          "`ETag` of the current version replaces that one and no other. What is kept already is answered 200, so a "
          "request whose answer was lost may be sent again. A graph may have mistakes, which `POST /v1/validate` "
          "tells; but it must be a document. An answer comes when the disk has what was sent.",
      .parameters = {graph_parameter(false),
                     condition_header("If-None-Match", "`*`: there must be no such graph.", "*"),
                     condition_header("If-Match", "The tag of the version to replace, or `*`.",
                                      "\"1-0123456789abcdef\"")},
      .takes_document = true,
      .answers = {{.doc = "It was replaced, or was kept already.",
                   .contents = {version_content()},
                   .headers = {"ETag", "Cache-Control"}},
                  {.status = 201,
                   .doc = "It was created.",
                   .contents = {version_content()},
                   .headers = {"ETag", "Cache-Control", "Location"}}},
      .problems = codes_of(ProblemKind::graph, {"not-json", "precondition-failed", "precondition-required",
                                                "storage-full", "storage-failed"})};
}

Reply put_graph(const Context& context) {
  const Request& request = context.request();
  const std::string& id = context.arguments.front();
  const auto refuse = [&](const Problems& problems) { return problem_reply(problems, context.exchange()); };
  if (!is_graph_id(id)) return refuse({wrong_id(id)});
  const auto json = read_json(context);
  if (!json) return refuse(json.problems());
  if (!request.has_header("If-Match") && !request.has_header("If-None-Match")) {
    return refuse({{.code = "precondition-required",
                    .detail = "Send `If-None-Match: *` to create the graph, or `If-Match` with the tag of the version "
                              "to replace."}});
  }
  const SharedGraph graph = context.engine().read(*json);
  if (const auto readable = context.engine().interface(*graph); !readable) return refuse(readable.problems());
  context.call->note_graph(graph->hash);
  const auto written = context.application.graphs.put(
      {.id = id, .hash = graph->hash, .title = title_of(*json), .document = request.body}, condition_of(request));
  if (!written) return refuse(written.problems());
  if (written->outcome == store::WriteOutcome::refused) return precondition_failed(context, id, written->current);
  const store::GraphVersion& version = *written->current;
  const bool created = written->outcome == store::WriteOutcome::created;
  Reply reply = json_reply(to_json(context, version), created ? 201 : 200);
  reply.headers = {{"ETag", tag_of(version)}, {"Cache-Control", "no-store"}};
  if (created)
    reply.headers.emplace_back("Location", std::string(context.exchange().base) + "/v1/graphs/" + version.id);
  return reply;
}

Operation describe_get_graph() {
  return {.id = "getGraph",
          .group = "Stored graphs",
          .title = "A graph that is kept",
          .doc =
              "Answers with the document, byte for byte as it was sent. A version never changes, and stays when the "
              "graph is replaced or deleted.",
          .parameters = {graph_parameter(true), if_none_match_header()},
          .answers = {{.doc = "The document.",
                       .contents = {{.type = "application/json", .schema = schema::reference("Graph")}},
                       .headers = {"ETag", "Cache-Control", "Content-Location"}},
                      not_modified()},
          .problems = {"not-found", "storage-failed"}};
}

Reply get_graph(const Context& context) {
  const std::string& name = context.arguments.front();
  const auto found = stored_graph(context, name);
  if (!found) return problem_reply(found.problems(), context.exchange());
  const bool is_version = name.find('@') != std::string::npos;
  Reply reply{.headers = {{"ETag", tag_of(*found)},
                          {"Cache-Control", is_version ? "public, max-age=31536000, immutable" : "no-cache"}}};
  if (names_tag(context.request().header("If-None-Match"), tag_of(*found))) {
    reply.status = 304;
    return reply;
  }
  reply.headers.emplace_back("Content-Location", address_of(context, *found));
  reply.type = "application/json";
  reply.body = {found->document};
  return reply;
}

Operation describe_delete_graph() {
  return {.id = "deleteGraph",
          .group = "Stored graphs",
          .title = "Deletes a graph, but not its versions",
          .doc =
              "The graph is in no list any more and its name has no current version. Its versions can be read until "
              "`dini store purge`.",
          .parameters = {graph_parameter(false),
                         condition_header("If-Match", "The tag of the version that must be the current one.",
                                          "\"1-0123456789abcdef\"")},
          .answers = {{.status = 204, .doc = "It is deleted."}},
          .problems = {"not-found", "precondition-failed", "storage-full", "storage-failed"}};
}

Reply delete_graph(const Context& context) {
  const std::string& id = context.arguments.front();
  const auto written = context.application.graphs.remove(id, condition_of(context.request()));
  if (!written) return problem_reply(written.problems(), context.exchange());
  if (written->outcome == store::WriteOutcome::refused) return precondition_failed(context, id, written->current);
  if (written->outcome == store::WriteOutcome::unchanged) return problem_reply(no_graph(id), context.exchange());
  return {.status = 204};
}

}  // namespace dini::server
