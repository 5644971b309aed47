// Models of graphs that are kept, each with an address of its own.

#include <algorithm>

#include "graph/nearest.h"
#include "server/addresses.h"
#include "server/computing.h"
#include "server/evaluation.h"
#include "server/graphs.h"
#include "server/handlers.h"
#include "server/negotiation.h"
#include "server/ranges.h"
#include "server/responses.h"
#include "server/text.h"
#include "service/identity.h"
#include "service/interface.h"
#include "service/requests/schema.h"

namespace dini::server {
namespace {

/// A parameter of a graph that is called as something of the address is written with this before it.
constexpr std::string_view parameter_prefix = "parameter.";

/// What is known of a graph that is kept.
struct KnownGraph {
  SharedGraph graph;
  Json interface;
};

/// The graph of a version, which is not read again while there is room for it.
Result<std::shared_ptr<const KnownGraph>> known_graph(const Context& context, const store::GraphVersion& version) {
  Cache& known = context.application.known;
  const Digest key = DigestBuilder().text("stored graph").digest(version.digest).finish();
  if (auto found = known.find<KnownGraph>(key)) return found;
  const auto stored = stored_graph(context, version.id + "@" + std::to_string(version.version));
  if (!stored) return stored.problems();
  const auto json = parse_json(*stored->document, context.engine().limits());
  if (!json) return json.problems();
  SharedGraph graph = context.engine().read(*json);
  Result<Json> interface = context.engine().interface(*graph);
  if (!interface) return interface.problems();
  const std::size_t held = graph->held + 8 * dump(*interface).size();
  auto made = std::make_shared<const KnownGraph>(KnownGraph{std::move(graph), *std::move(interface)});
  known.insert<KnownGraph>(key, made, held);
  return std::shared_ptr<const KnownGraph>(std::move(made));
}

/// What an address asks for.
struct Asked {
  EvaluateBody body;
  Presentation presentation;
  std::string accept;  ///< media types, or none to go by the header
  std::string format;  ///< the name of a format, or none
};

std::vector<Parameter> query_parameters() {
  const auto query = [](const char* name, const char* doc, Json schema, Json example) {
    return Parameter{.place = Parameter::Place::query,
                     .name = name,
                     .doc = doc,
                     .schema = std::move(schema),
                     .example = std::move(example)};
  };
  return {query("quality", "A draft is made faster, of fewer triangles.", {{"enum", {"draft", "final"}}}, "draft"),
          query("draco", "`false` leaves meshes uncompressed, for programs that cannot read Draco.",
                {{"type", "boolean"}}, "false"),
          format_parameter(),
          query("accept", "A media type, instead of `Accept`, for links.", {{"type", "string"}}, "model/gltf-binary"),
          query("download", "The answer is to be saved rather than shown.", {{"type", "string"}}, "")};
}

/// The names that a query may have.
std::vector<std::string> known_names(const Json& interface) {
  std::vector<std::string> names;
  for (const Parameter& parameter : query_parameters()) names.push_back(parameter.name);
  for (const auto& [name, schema] : interface.at("parameters").at("properties").items()) names.push_back(name);
  return names;
}

Problem unknown_name(const std::string& name, const Json& interface) {
  return {.code = "unknown-parameter",
          .detail = "'" + escape_controls(name, 80) +
                    "' is no parameter of the graph and nothing else that the address "
                    "takes" +
                    did_you_mean(name, known_names(interface))};
}

/// The query of an address: parameters of the graph, and what is fixed.
Result<Asked> read_query(const Context& context, const KnownGraph& known) {
  const Json& parameters = known.interface.at("parameters").at("properties");
  Asked asked;
  asked.body.graph = known.graph;
  std::map<std::string, std::string> texts;
  for (auto& [name, value] : decoded_query(context.request().query)) {
    if (name == "quality") {
      if (value != "draft" && value != "final") {
        return Problem{.code = "not-in-choices", .detail = "'quality' in the query is draft or final."};
      }
      asked.body.quality = value == "draft" ? Quality::draft : Quality::final;
    } else if (name == "draco") {
      if (value != "true" && value != "false") {
        return Problem{.code = "not-in-choices", .detail = "'draco' in the query is true or false."};
      }
      asked.body.draco = value == "true";
    } else if (name == "format") {
      asked.format = value;
    } else if (name == "accept") {
      asked.accept = value;
    } else if (name == "download") {
      asked.presentation.attachment = true;
    } else {
      std::string parameter = name.starts_with(parameter_prefix) ? name.substr(parameter_prefix.size()) : name;
      if (!parameters.contains(parameter)) return unknown_name(name, known.interface);
      if (!texts.emplace(std::move(parameter), std::move(value)).second) {
        return Problem{.code = "unknown-member", .detail = "The query has '" + escape_controls(name, 80) + "' twice."};
      }
    }
  }
  asked.body.parameters = parameters_from_text(known.interface, texts, context.engine().limits());
  return asked;
}

/// "ring.glb" is the output "ring" as that format, "ring" in what `format`, `accept` or the header likes best.
Result<Form> form_of(const Context& context, const std::string& file, Asked& asked) {
  const auto dot = file.rfind('.');
  asked.body.output = file.substr(0, dot);
  if (dot == std::string::npos) {
    const std::string_view header = context.request().header("Accept");
    return form_for(context.engine(), asked.accept.empty() ? header : std::string_view(asked.accept), asked.format);
  }
  std::string endings;
  for (const FileFormat& format : context.engine().formats()) {
    endings += (endings.empty() ? "" : ", ") + format.extension;
    if (file.substr(dot) != format.extension) continue;
    if (asked.format.empty() || asked.format == format.name) return Form{format.media_types.front(), format.name};
    return Problem{.code = "not-in-choices",
                   .detail = "The address ends in " + format.extension + ", so 'format' in its query can be " +
                             format.name + " only."};
  }
  return Problem{.code = "not-found", .detail = "Outputs end in " + endings + ", or in nothing."};
}

}  // namespace

Operation describe_graph_output() {
  Operation evaluated = describe_evaluate();
  std::vector<Parameter> parameters = {graph_parameter(true),
                                       {.place = Parameter::Place::path,
                                        .name = "output",
                                        .doc = "The name of an `export` node, alone or with the ending of a format.",
                                        .example = "out"},
                                       accept_header("What is answered when neither the ending nor `accept` says it."),
                                       if_none_match_header(),
                                       range_header()};
  for (Parameter& parameter : query_parameters()) parameters.push_back(std::move(parameter));
  Answer whole = evaluated.answers.front();
  whole.doc = "The file of the output, or its report.";
  Answer part{.status = 206, .doc = "The part that `Range` names.", .contents = whole.contents};
  part.headers = {"ETag", "Cache-Control", "Accept-Ranges", "Content-Range"};
  return {.id = "getGraphOutput",
          .group = "Stored graphs",
          .title = "The model of an output, by its address",
          .doc =
              "For links, pages and caches: `/v1/graphs/chair/outputs/out.glb?height=0.9`. The query has values for "
              "the parameters of the graph, by name: numbers, `true` and `false`, words, and lists as `1,0,0`; a "
              "parameter that is called as one of the names below is written `parameter.quality`. The address of a "
              "version, `chair@3`, is answered the same for ever and may be kept as long.",
          .parameters = std::move(parameters),
          .answers = {std::move(whole), std::move(part), not_modified()},
          .problems =
              codes_of(ProblemKind::graph, {"not-acceptable", "not-found", "range-not-satisfiable", "storage-failed"}),
          .takes_any_query = true,
          .computes = true};
}

void graph_output(const Context& context) {
  const std::string& name = context.arguments.front();
  const auto version = stored_version(context, name);
  if (!version) return reply_problems(context, version.problems());
  const auto known = known_graph(context, *version);
  if (!known) return reply_problems(context, known.problems());
  auto asked = read_query(context, **known);
  if (!asked) return reply_problems(context, asked.problems());
  const auto form = form_of(context, context.arguments.at(1), *asked);
  if (!form) return reply_problems(context, form.problems());
  asked->body.format = form->format;
  asked->presentation.parts = true;
  if (name.find('@') != std::string::npos) asked->presentation.cache_control = "public, max-age=31536000, immutable";
  answer_evaluation(context, form->type, std::make_shared<const EvaluateBody>(std::move(asked->body)),
                    asked->presentation);
}

Operation describe_graph_interface() {
  return {.id = "getGraphInterface",
          .group = "Stored graphs",
          .title = "The parameters and outputs of a graph",
          .doc = "Answers with the parameters as a JSON Schema, for forms, and with the names of the outputs.",
          .parameters = {graph_parameter(true)},
          .answers = {{.doc = "What the graph looks like from outside.",
                       .contents = {{.type = "application/json", .schema = schema::reference("GraphInterface")}},
                       .headers = {"Cache-Control"}}},
          .problems = {"not-found", "storage-failed"}};
}

Reply graph_interface(const Context& context) {
  const auto version = stored_version(context, context.arguments.front());
  if (!version) return problem_reply(version.problems(), context.exchange());
  const auto known = known_graph(context, *version);
  if (!known) return problem_reply(known.problems(), context.exchange());
  Json answer = (*known)->interface;
  answer["id"] = version->id;
  answer["version"] = version->version;
  answer["hash"] = to_hex(version->hash);
  Reply reply = json_reply(answer);
  reply.headers.emplace_back("Cache-Control", "no-cache");
  return reply;
}

}  // namespace dini::server
