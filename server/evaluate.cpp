#include <algorithm>
#include <array>
#include <variant>

#include "server/computation.h"
#include "server/handlers.h"
#include "server/negotiation.h"
#include "server/request_body.h"
#include "server/responses.h"

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

/// Text that becomes the body of a multipart answer, part by part.
class Multipart {
 public:
  Multipart(const std::string& tag, std::size_t bytes) : boundary_(boundary_for(tag)) { body_.reserve(bytes + 1024); }

  void add(std::string_view name, std::string_view type, std::string_view content, const std::string& file = "") {
    body_ += (body_.empty() ? "--" : "\r\n--") + boundary_ + "\r\nContent-Disposition: form-data; name=\"";
    body_.append(name) += "\"";
    if (!file.empty()) body_ += "; filename=\"" + file + "\"";
    body_.append("\r\nContent-Type: ").append(type).append("\r\n\r\n").append(content);
  }

  void finish(Reply& reply) && {
    reply.type += "; boundary=" + boundary_;
    reply.body = std::move(body_) + "\r\n--" + boundary_ + "--\r\n";
  }

 private:
  std::string boundary_;
  std::string body_;
};

void set_content(Reply& reply, std::string_view type, const Evaluated& evaluated, const std::string& tag,
                 const std::string& output) {
  reply.type = type;
  const std::string file = file_name(evaluated.glb != nullptr ? output : "preview");
  if (type == report_type) {
    reply.body = dump(evaluated.report());
  } else if (type == both_type) {
    const auto size_of = [](const auto& bytes) { return bytes == nullptr ? 0 : bytes->size(); };
    const std::string report = dump(evaluated.report());
    Multipart parts(tag, report.size() + size_of(evaluated.glb) + size_of(evaluated.preview));
    parts.add("report", report_type, report);
    if (evaluated.glb != nullptr) parts.add("model", model_type, *evaluated.glb, file);
    if (evaluated.preview != nullptr) parts.add("preview", model_type, *evaluated.preview, file_name("preview"));
    std::move(parts).finish(reply);
  } else {
    reply.body = evaluated.glb != nullptr ? *evaluated.glb : *evaluated.preview;
    reply.headers.emplace_back("Content-Disposition", "inline; filename=\"" + file + "\"");
  }
}

/// Reads and checks a request, unless the very same bytes were read and checked before. Else the answer that says why
/// not.
std::variant<std::shared_ptr<const KnownRequest>, Reply> read_request(Call& call) {
  const std::string key = call.header("Content-Type") + "\n" + call.request.body;
  if (auto known = call.application.known.find(key)) return known;
  auto json = read_json(call);
  if (!json) return problem_reply(json.problems(), call.exchange);
  RequestBody body(*std::move(json),
                   {"graph", "parameters", "output", "preview", "quality", "triangle_budget", "deadline_ms"});
  KnownRequest read;
  const EvaluateRequest request{
      .graph = body.object("graph", true),
      .parameters = body.object("parameters", false),
      .output = body.text("output", false),
      .quality = body.choice("quality", {"final", "draft"}) == "draft" ? Quality::draft : Quality::final,
      .triangle_budget = body.integer("triangle_budget"),
      .preview = body.texts("preview")};
  read.deadline_milliseconds = body.positive_integer("deadline_ms");
  read.output = request.output;
  if (!body.problems().empty()) return problem_reply(body.problems(), call.exchange);
  auto prepared = call.engine().prepare(request);
  if (!prepared) return problem_reply(prepared.problems(), call.exchange, call.engine().blocked(request));
  read.prepared = *std::move(prepared);
  return call.application.known.insert(key, std::move(read));
}

}  // namespace

Reply evaluate(Call& call) {
  const auto type = choose_type(call.header("Accept"), offers);
  if (!type) {
    return problem_reply(
        Problem{.code = "not-acceptable",
                .detail = "Available are model/gltf-binary, application/json and multipart/form-data."},
        call.exchange);
  }
  auto read = read_request(call);
  if (auto* refused = std::get_if<Reply>(&read)) return std::move(*refused);
  const KnownRequest& request = *std::get<0>(read);
  const Prepared& prepared = *request.prepared;
  Computation computation(call, request.deadline_milliseconds);
  const std::string& tag = Engine::entity_tag(prepared);
  // One tag for the result in all its forms; clients keep it and ask again, so an unchanged graph costs nothing. It is
  // strong for the model only: reports hold times, so their bytes differ from one answer to the next.
  const std::string shown = *type == model_type ? tag : "W/" + tag;
  Reply reply{.headers = {{"ETag", shown}, {"Cache-Control", "no-cache"}, {"Vary", "Accept"}}};
  if (names_tag(call.header("If-None-Match"), tag)) {
    reply.status = 304;
    return reply;
  }

  const auto evaluated = [&]() -> Result<Evaluated> {
    const auto pass = computation.enter();
    if (!pass) return pass.problems();
    return call.engine().evaluate(prepared, computation.cancel());
  }();
  if (!evaluated) return problem_reply(evaluated.problems(), call.exchange);
  for (const auto& [step, took] : evaluated->milliseconds) call.exchange.timings.emplace_back(step, took);
  set_content(reply, *type, *evaluated, tag, request.output);
  return reply;
}

}  // namespace dini::server
