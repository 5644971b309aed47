#include <algorithm>
#include <array>

#include "server/computing.h"
#include "server/handlers.h"
#include "server/negotiation.h"
#include "server/responses.h"
#include "server/text.h"
#include "service/requests/requests.h"
#include "service/requests/schema.h"

namespace dini::server {
namespace {

constexpr std::string_view model_type = "model/gltf-binary";
constexpr std::string_view report_type = "application/json";
constexpr std::string_view both_type = "multipart/form-data";
constexpr std::array offers = {model_type, report_type, both_type};

bool is_plain(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' || c == '_';
}

std::string file_name(const std::string& output) {
  std::string name;
  std::ranges::copy_if(output.substr(0, 64), std::back_inserter(name), is_plain);
  return (name.empty() ? "model" : name) + ".glb";
}

/// From the fingerprint, so that equal requests give equal bytes; and no answer contains the hash of its own request.
std::string boundary_for(const std::string& tag) {
  std::string name = "dini-";
  std::ranges::copy_if(tag, std::back_inserter(name), is_plain);
  return name.substr(0, 64);
}

/// The pieces of a multipart answer; files are handed on as they are.
class Multipart {
 public:
  explicit Multipart(const std::string& tag) : boundary_(boundary_for(tag)) {}

  void add(std::string_view name, std::string_view type, SharedBytes content, const std::string& file = "") {
    std::string head = (pieces_.empty() ? "--" : "\r\n--") + boundary_ + "\r\nContent-Disposition: form-data; name=\"";
    head.append(name) += "\"";
    if (!file.empty()) head += "; filename=\"" + file + "\"";
    head.append("\r\nContent-Type: ").append(type).append("\r\n\r\n");
    pieces_.push_back(share(std::move(head)));
    pieces_.push_back(std::move(content));
  }

  void finish(Reply& reply) && {
    reply.type += "; boundary=" + boundary_;
    pieces_.push_back(share("\r\n--" + boundary_ + "--\r\n"));
    reply.body = std::move(pieces_);
  }

 private:
  std::string boundary_;
  std::vector<SharedBytes> pieces_;
};

/// A request that was read and checked.
struct KnownRequest {
  SharedPrepared prepared;
  std::string file_name;
  std::optional<std::int64_t> deadline_milliseconds;
};

/// One tag for the result in all its forms that holds no times: it is strong for the model. What a report tells has a
/// tag of its own, which is weak, since its bytes differ from one answer to the next.
std::string tag_for(std::string_view type, const Prepared& prepared) {
  return type == model_type ? prepared.model_tag : "W/" + prepared.report_tag;
}

Reply evaluated_reply(const Context& context, std::string_view type, const KnownRequest& request,
                      const Computed& computed) {
  const Prepared& prepared = *request.prepared;
  for (const auto& [step, took] : computed.milliseconds) context.call->note_time(step, took);
  Reply reply{.type = std::string(type),
              .headers = {{"ETag", tag_for(type, prepared)}, {"Cache-Control", "no-cache"}, {"Vary", "Accept"}}};
  const std::string file = computed.model != nullptr ? request.file_name : file_name("preview");
  if (type == model_type) {
    reply.body = {computed.model != nullptr ? computed.model->bytes : computed.preview->bytes};
    reply.headers.emplace_back("Content-Disposition", "inline; filename=\"" + file + "\"");
    return reply;
  }
  SharedBytes report = share(dump(context.engine().report(prepared, computed)));
  if (type == report_type) {
    reply.body = {std::move(report)};
    return reply;
  }
  Multipart parts(prepared.report_tag);
  parts.add("report", report_type, std::move(report));
  if (computed.model != nullptr) parts.add("model", model_type, computed.model->bytes, file);
  if (computed.preview != nullptr) parts.add("preview", model_type, computed.preview->bytes, file_name("preview"));
  std::move(parts).finish(reply);
  return reply;
}

/// Reads and checks a request, unless the very same bytes were read and checked before. Null when it has been answered
/// that it is wrong.
std::shared_ptr<const KnownRequest> read_request(const Context& context) {
  const Request& request = context.request();
  const Digest digest =
      DigestBuilder().text("request").text(request.header("Content-Type")).text(request.body).finish();
  if (auto known = context.application.known.find<KnownRequest>(digest)) return known;
  const auto refuse = [&](const Reply& reply) {
    context.call->reply(reply);
    return nullptr;
  };
  auto json = read_json(context);
  if (!json) return refuse(problem_reply(json.problems(), context.exchange()));
  const auto asked = read_evaluate_body(*std::move(json));
  if (!asked) return refuse(problem_reply(asked.problems(), context.exchange()));
  auto read = std::make_shared<KnownRequest>();
  read->file_name = file_name(asked->output);
  read->deadline_milliseconds = asked->deadline_milliseconds;
  const Cancel cancel(deadline_of(context, read->deadline_milliseconds));
  auto prepared = context.engine().prepare(*asked, cancel);
  if (!prepared) {
    return refuse(problem_reply(prepared.problems(), context.exchange(), context.engine().blocked(*asked, cancel)));
  }
  read->prepared = *std::move(prepared);
  context.application.known.insert<KnownRequest>(digest, read, read->prepared->held);
  return read;
}

/// Whether a client has what it asks for. On anything but a GET `*` would mean "only if there is nothing yet", which
/// says nothing about a result.
bool is_known_to_client(const Context& context, std::string_view type, const Prepared& prepared) {
  const std::string_view known = context.request().header("If-None-Match");
  return trim(known) != "*" && names_tag(known, type == model_type ? prepared.model_tag : prepared.report_tag);
}

}  // namespace

Operation describe_evaluate() {
  return {.id = "evaluate",
          .group = "Graphs",
          .title = "The model of a graph, a preview, a report, or all of them",
          .doc =
              "Answers with the model of an output, a preview of nodes, a report about both, or all of them in one "
              "answer. The bytes of a file depend on the graph, the parameters and the engine only. Only what the "
              "output and the previews depend on has to be well; problems of other nodes are warnings of the "
              "report. But a check that cannot run fails the request, as one that does not hold would.",
          .parameters = {accept_header("What is answered: the file, the report, or both as parts of one answer.",
                                       {offers.begin(), offers.end()}),
                         if_none_match_header(), supersede_key_header()},
          .request = &evaluate_description(),
          .answers = {{.status = 200,
                       .doc = "The file of the model, or without an output that of the preview; the report; or the "
                              "parts `report`, `model` and `preview`, those of them that were asked for.",
                       .contents = {{.type = std::string(model_type)},
                                    {.type = std::string(report_type), .schema = schema::reference("Report")},
                                    {.type = std::string(both_type)}},
                       .headers = {"ETag", "Cache-Control", "Vary", "Content-Disposition"}},
                      not_modified()},
          .problems =
              [] {
                auto codes = codes_of(ProblemKind::graph);
                codes.push_back("not-acceptable");
                return codes;
              }(),
          .computes = true};
}

void evaluate(const Context& context) {
  const auto type = choose_type(context.request().header("Accept"), offers);
  if (!type) {
    return reply_problems(context,
                          {{.code = "not-acceptable",
                            .detail = "Available are model/gltf-binary, application/json and multipart/form-data."}});
  }
  const auto request = read_request(context);
  if (request == nullptr) return take_over(context);  // a wrong request is newer all the same
  const SharedPrepared prepared = request->prepared;
  if (is_known_to_client(context, *type, *prepared)) {
    take_over(context);
    return context.call->reply(
        {.status = 304,
         .headers = {{"ETag", tag_for(*type, *prepared)}, {"Cache-Control", "no-cache"}, {"Vary", "Accept"}}});
  }
  // What is known waits for nobody.
  if (const SharedComputed known = context.engine().find(*prepared, *type != model_type)) {
    take_over(context);
    return context.call->reply(evaluated_reply(context, *type, *request, *known));
  }
  compute<Computed>(
      context,
      {.key = prepared->content,
       .bytes = prepared->bytes,
       .deadline = deadline_of(context, request->deadline_milliseconds)},
      [&engine = context.engine(), prepared](const Cancel& cancel) { return engine.compute(*prepared, cancel); },
      [context, request, type = *type](const SharedComputed& computed) {
        return evaluated_reply(context, type, *request, *computed);
      });
}

}  // namespace dini::server
