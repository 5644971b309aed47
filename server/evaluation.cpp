#include "server/evaluation.h"

#include <algorithm>
#include <array>

#include "graph/nearest.h"
#include "server/computing.h"
#include "server/negotiation.h"
#include "server/query.h"
#include "server/ranges.h"
#include "server/responses.h"
#include "server/text.h"
#include "service/identity.h"

namespace dini::server {
namespace {

constexpr std::string_view report_type = "application/json";
constexpr std::string_view both_type = "multipart/form-data";

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

/// A request with what its check came to, and how it is answered.
struct CheckedRequest {
  std::shared_ptr<const EvaluateBody> body;
  SharedPrepared prepared;
  std::string_view type;
  Presentation presentation;
};

/// One tag for the result in all its forms that holds no times: it is strong for the model. What a report tells has a
/// tag of its own, which is weak, since its bytes differ from one answer to the next.
std::string tag_for(std::string_view type, const Prepared& prepared) {
  return is_model(type) ? prepared.model_tag : "W/" + prepared.report_tag;
}

std::vector<std::pair<std::string, std::string>> headers_of(const CheckedRequest& request) {
  return {{"ETag", tag_for(request.type, *request.prepared)},
          {"Cache-Control", request.presentation.cache_control},
          {"Vary", "Accept"}};
}

Reply file_reply(const Context& context, const CheckedRequest& request, const Computed& computed, Reply reply) {
  const File& file = computed.model != nullptr ? *computed.model : *computed.preview;
  const std::string name = file_name(computed.model != nullptr ? request.body->output : "preview", file);
  reply.body = {file.bytes};
  reply.headers.emplace_back("Content-Disposition", (request.presentation.attachment ? "attachment" : "inline") +
                                                        ("; filename=\"" + name + "\""));
  if (!request.presentation.parts) return reply;
  return with_range(std::move(reply), context, request.prepared->model_tag);
}

Reply evaluated_reply(const Context& context, const CheckedRequest& request, const Computed& computed) {
  const Prepared& prepared = *request.prepared;
  const std::string_view type = request.type;
  for (const auto& [step, took] : computed.milliseconds) context.call->note_time(step, took);
  Reply reply{.type = std::string(type), .headers = headers_of(request)};
  if (is_model(type)) return file_reply(context, request, computed, std::move(reply));
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

/// Whether a client has what it asks for. On anything but a GET `*` would mean "only if there is nothing yet", which
/// says nothing about a result.
bool is_known_to_client(const Context& context, const CheckedRequest& request) {
  const std::string_view known = context.request().header("If-None-Match");
  if (trim(known) == "*" && context.request().method == "POST") return false;
  return names_tag(known, is_model(request.type) ? request.prepared->model_tag : request.prepared->report_tag);
}

/// The check of a request, unless one of its identity was checked before. Nothing when it has been answered that it is
/// wrong.
std::optional<SharedPrepared> check(const Context& context, const EvaluateBody& body) {
  const Digest identity = identity_of(body);
  Cache& known = context.application.known;
  if (auto prepared = known.find<Prepared>(identity)) return prepared;
  const Cancel cancel(deadline_of(context, body.deadline_milliseconds));
  const auto begun = Exchange::Clock::now();
  auto prepared = context.engine().prepare(body, cancel);
  context.call->note_time("check", std::chrono::duration<double, std::milli>(Exchange::Clock::now() - begun).count());
  if (!prepared) {
    context.call->reply(problem_reply(prepared.problems(), context.exchange(), context.engine().blocked(body, cancel)));
    return std::nullopt;
  }
  known.insert<Prepared>(identity, *prepared, (*prepared)->held);
  return *std::move(prepared);
}

}  // namespace

std::vector<std::string_view> evaluation_types(std::span<const FileFormat> formats) {
  std::vector<std::string_view> types;
  for (const FileFormat& format : formats) {
    types.insert(types.end(), format.media_types.begin(), format.media_types.end());
  }
  types.push_back(report_type);
  types.push_back(both_type);
  return types;
}

Result<Form> form_for(const Engine& engine, std::string_view accept, const std::string& format) {
  const std::span<const FileFormat> formats = engine.formats();
  if (format.empty()) {
    const Result<std::string_view> type = accepted_type(accept, evaluation_types(formats));
    if (!type) return type.problems();
    return Form{*type, is_model(*type) ? format_of_type(formats, *type)->name : ""};
  }
  const FileFormat* const wanted = format_named(formats, format);
  if (wanted == nullptr) {
    std::vector<std::string> names;
    std::string list;
    for (const FileFormat& known : formats) {
      names.push_back(known.name);
      list += (list.empty() ? "" : ", ") + known.name;
    }
    return Problem{.code = "not-in-choices",
                   .detail = "there is no format '" + escape_controls(format, 80) + "' among " + list +
                             did_you_mean(format, names)};
  }
  const std::string_view model = wanted->media_types.front();
  const auto best = choose_type(accept, std::array{model, report_type, both_type});
  return Form{best.value_or(model), wanted->name};
}

Result<Form> asked_form(const Context& context) {
  auto query = read_query(context.request(), {format_parameter().name});
  if (!query) return query.problems();
  return form_for(context.engine(), context.request().header("Accept"), (*query)["format"]);
}

Parameter format_parameter() {
  return {
      .place = Parameter::Place::query,
      .name = "format",
      .doc = "The format of the model by its name, instead of a media type in `Accept`; `GET /v1/nodes` lists them.",
      .schema = {{"type", "string"}},
      .example = "glb"};
}

void answer_evaluation(const Context& context, std::string_view type, const std::shared_ptr<const EvaluateBody>& body,
                       const Presentation& presentation) {
  context.call->note_graph(body->graph->hash);
  const std::optional<SharedPrepared> checked = check(context, *body);
  if (!checked) return take_over(context);  // a wrong request is newer all the same
  const CheckedRequest request{body, *checked, type, presentation};
  if (is_known_to_client(context, request)) {
    take_over(context);
    return context.call->reply({.status = 304, .headers = headers_of(request)});
  }
  // What is known waits for nobody.
  if (const SharedComputed known = context.engine().find(*request.prepared)) {
    context.call->note_cache("hit");
    take_over(context);
    return context.call->reply(evaluated_reply(context, request, *known));
  }
  context.call->note_cache("miss");
  const SharedPrepared& prepared = request.prepared;
  compute<Computed>(
      context,
      {.key = prepared->content,
       .bytes = prepared->bytes,
       .work = prepared->work,
       .deadline = deadline_of(context, body->deadline_milliseconds)},
      [&application = context.application, prepared](const Job& job) { return application.compute(*prepared, job); },
      [context, request](const SharedComputed& computed) { return evaluated_reply(context, request, *computed); });
}

}  // namespace dini::server
