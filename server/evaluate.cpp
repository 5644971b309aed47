#include <algorithm>

#include "server/computing.h"
#include "server/handlers.h"
#include "server/negotiation.h"
#include "server/responses.h"
#include "server/text.h"
#include "service/identity.h"
#include "service/requests/requests.h"
#include "service/requests/schema.h"

namespace dini::server {
namespace {

constexpr std::string_view report_type = "application/json";
constexpr std::string_view both_type = "multipart/form-data";

/// Every type that an answer may have, the one that is answered to who takes all first.
std::vector<std::string_view> offers_of(std::span<const FileFormat> formats) {
  std::vector<std::string_view> offers;
  for (const FileFormat& format : formats)
    offers.insert(offers.end(), format.media_types.begin(), format.media_types.end());
  offers.push_back(report_type);
  offers.push_back(both_type);
  return offers;
}

bool is_model(std::string_view type) { return type != report_type && type != both_type; }

bool is_plain(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' || c == '_';
}

std::string file_name(const std::string& name, const File& file) {
  std::string plain;
  std::ranges::copy_if(name.substr(0, 64), std::back_inserter(plain), is_plain);
  return (plain.empty() ? "model" : plain) + file.extension;
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

using SharedBody = std::shared_ptr<const EvaluateBody>;

/// A request with what its check came to.
struct CheckedRequest {
  SharedBody body;
  SharedPrepared prepared;
};

/// One tag for the result in all its forms that holds no times: it is strong for the model. What a report tells has a
/// tag of its own, which is weak, since its bytes differ from one answer to the next.
std::string tag_for(std::string_view type, const Prepared& prepared) {
  return is_model(type) ? prepared.model_tag : "W/" + prepared.report_tag;
}

Reply evaluated_reply(const Context& context, std::string_view type, const CheckedRequest& request,
                      const Computed& computed) {
  const Prepared& prepared = *request.prepared;
  for (const auto& [step, took] : computed.milliseconds) context.call->note_time(step, took);
  Reply reply{.type = std::string(type),
              .headers = {{"ETag", tag_for(type, prepared)}, {"Cache-Control", "no-cache"}, {"Vary", "Accept"}}};
  if (is_model(type)) {
    const File& file = computed.model != nullptr ? *computed.model : *computed.preview;
    const std::string name = file_name(computed.model != nullptr ? request.body->output : "preview", file);
    reply.body = {file.bytes};
    reply.headers.emplace_back("Content-Disposition", "inline; filename=\"" + name + "\"");
    return reply;
  }
  SharedBytes report = share(dump(context.engine().report(prepared, computed)));
  if (type == report_type) {
    reply.body = {std::move(report)};
    return reply;
  }
  Multipart parts(prepared.report_tag);
  parts.add("report", report_type, std::move(report));
  const auto add = [&](const char* part, const SharedFile& file, const std::string& name) {
    if (file != nullptr) parts.add(part, file->media_type, file->bytes, file_name(name, *file));
  };
  add("model", computed.model, request.body->output);
  add("preview", computed.preview, "preview");
  std::move(parts).finish(reply);
  return reply;
}

/// What the body of a request says. The very same bytes say the same, so they are not read twice.
Result<SharedBody> read_body(const Context& context, const std::string& format) {
  const Request& request = context.request();
  const Digest bytes =
      DigestBuilder().text("body").text(request.header("Content-Type")).text(format).text(request.body).finish();
  Cache& known = context.application.known;
  if (SharedBody read = known.find<EvaluateBody>(bytes)) return read;
  auto json = read_json(context);
  if (!json) return json.problems();
  auto read = read_evaluate_body(*std::move(json), context.engine());
  if (!read) return read.problems();
  read->format = format;
  auto body = std::make_shared<const EvaluateBody>(*std::move(read));
  known.insert<EvaluateBody>(bytes, body, memory_of(*body));
  return SharedBody(std::move(body));
}

/// Reads and checks a request for a type of answer, unless one of its identity was checked before. Nothing when it has
/// been answered that it is wrong.
std::optional<CheckedRequest> read_request(const Context& context, std::string_view type) {
  const FileFormat* format = is_model(type) ? format_of_type(context.engine().formats(), type) : nullptr;
  const auto refuse = [&](const Reply& reply) {
    context.call->reply(reply);
    return std::nullopt;
  };
  const Result<SharedBody> read = read_body(context, format != nullptr ? format->name : "");
  if (!read) return refuse(problem_reply(read.problems(), context.exchange()));
  const SharedBody& body = *read;
  const Digest identity = identity_of(*body);
  Cache& known = context.application.known;
  if (auto prepared = known.find<Prepared>(identity)) return CheckedRequest{body, std::move(prepared)};
  const Cancel cancel(deadline_of(context, body->deadline_milliseconds));
  auto prepared = context.engine().prepare(*body, cancel);
  if (!prepared) {
    return refuse(problem_reply(prepared.problems(), context.exchange(), context.engine().blocked(*body, cancel)));
  }
  known.insert<Prepared>(identity, *prepared, (*prepared)->held);
  return CheckedRequest{body, *std::move(prepared)};
}

/// Whether a client has what it asks for. On anything but a GET `*` would mean "only if there is nothing yet", which
/// says nothing about a result.
bool is_known_to_client(const Context& context, std::string_view type, const Prepared& prepared) {
  const std::string_view known = context.request().header("If-None-Match");
  return trim(known) != "*" && names_tag(known, is_model(type) ? prepared.model_tag : prepared.report_tag);
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
                                       [] {
                                         const auto offers = offers_of(usual_formats());
                                         return std::vector<std::string>(offers.begin(), offers.end());
                                       }()),
                         if_none_match_header(), supersede_key_header()},
          .request = &evaluate_description(),
          .answers = {{.status = 200,
                       .doc = "The file of the model, or without an output that of the preview; the report; or the "
                              "parts `report`, `model` and `preview`, those of them that were asked for.",
                       .contents =
                           [] {
                             std::vector<Content> contents;
                             for (const std::string_view type : offers_of(usual_formats())) {
                               contents.push_back({.type = std::string(type)});
                               if (type == report_type) contents.back().schema = schema::reference("Report");
                             }
                             return contents;
                           }(),
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
  const std::vector<std::string_view> offers = offers_of(context.engine().formats());
  const auto type = choose_type(context.request().header("Accept"), offers);
  if (!type) {
    std::string list;
    for (const std::string_view offer : offers) list.append(list.empty() ? "" : ", ").append(offer);
    return reply_problems(context, {{.code = "not-acceptable", .detail = "Available are " + list + "."}});
  }
  const auto request = read_request(context, *type);
  if (!request) return take_over(context);  // a wrong request is newer all the same
  const SharedPrepared prepared = request->prepared;
  if (is_known_to_client(context, *type, *prepared)) {
    take_over(context);
    return context.call->reply(
        {.status = 304,
         .headers = {{"ETag", tag_for(*type, *prepared)}, {"Cache-Control", "no-cache"}, {"Vary", "Accept"}}});
  }
  // What is known waits for nobody.
  if (const SharedComputed known = context.engine().find(*prepared)) {
    take_over(context);
    return context.call->reply(evaluated_reply(context, *type, *request, *known));
  }
  compute<Computed>(
      context,
      {.key = prepared->content,
       .bytes = prepared->bytes,
       .work = prepared->work,
       .deadline = deadline_of(context, request->body->deadline_milliseconds)},
      [&engine = context.engine(), prepared](const Job& job) { return engine.compute(*prepared, job); },
      [context, request = *request, type = *type](const SharedComputed& computed) {
        return evaluated_reply(context, type, request, *computed);
      });
}

}  // namespace dini::server
