#include "server/jobs.h"

#include <algorithm>

#include "fitting/fit.h"
#include "jobs/random_id.h"
#include "server/computing.h"
#include "server/evaluation.h"
#include "server/graph_body.h"
#include "server/handlers.h"
#include "server/responses.h"
#include "server/routes.h"
#include "server/text.h"
#include "service/requests/schema.h"

namespace dini::server {
namespace {

constexpr std::size_t longest_key = 255;

std::string address_of(const std::string& id, const std::string& base_path) { return base_path + "/v1/jobs/" + id; }

/// The key of a request, empty without one; a problem for one that cannot be a key.
Result<std::string> idempotency_key(const Request& request) {
  if (!request.has_header("Idempotency-Key")) return std::string();
  const std::string_view key = trim(request.header("Idempotency-Key"));
  const bool plain = std::ranges::all_of(key, [](char c) { return c > ' ' && c < '\x7f'; });
  if (!key.empty() && key.size() <= longest_key && plain) return std::string(key);
  return Problem{.code = "out-of-range",
                 .detail = "An Idempotency-Key has 1 to " + std::to_string(longest_key) +
                           " visible ASCII characters and no spaces.",
                 .in_request = true};
}

Reply job_reply(const Context& context, const jobs::JobStatus& status, int code) {
  const std::string& base_path = context.application.settings.base_path;
  Reply reply = json_reply(to_json(status, base_path), code);
  reply.headers.emplace_back("Cache-Control", "no-store");
  if (code == 202) reply.headers.emplace_back("Location", address_of(status.record.id, base_path));
  return reply;
}

/// Keeps a job whose request is well.
Reply keep(const Context& context, const std::string& body, const std::string& format, const std::string& key,
           const jobs::JobRequest& request) {
  jobs::JobRunner& runner = context.application.jobs;
  const auto added = runner.add({.id = jobs::random_id(),
                                 .kind = request.kind(),
                                 .idempotency_key = key,
                                 .body = body,
                                 .format = format,
                                 .total = static_cast<std::int64_t>(request.total())});
  if (!added) return problem_reply(added.problems(), context.exchange());
  if (!*added) {
    return problem_reply(Problem{.code = "busy", .detail = "As many jobs wait as may; try again later."},
                         context.exchange());
  }
  if ((*added)->outcome == store::AddedJob::Outcome::conflict) {
    return problem_reply(
        Problem{.code = "idempotency-key-reused",
                .detail = "The job '" + (*added)->job.id +
                          "' has this Idempotency-Key and was asked something else; send another key."},
        context.exchange());
  }
  const auto status = runner.find((*added)->job.id);
  if (!status) return problem_reply(status.problems(), context.exchange());
  Reply reply = job_reply(context, status->value_or(jobs::JobStatus{(*added)->job}), 202);
  if (prefers_job(context.request())) reply.headers.emplace_back("Preference-Applied", "respond-async");
  return reply;
}

}  // namespace

Json to_json(const jobs::JobStatus& status, const std::string& base_path) {
  const store::JobRecord& job = status.record;
  const std::string address = address_of(job.id, base_path);
  Json json = {{"id", job.id},
               {"kind", job.kind},
               {"state", job.state},
               {"created", time_text(job.created)},
               {"address", address},
               {"progress", status.progress},
               {"errors", Json::parse(job.errors)}};
  if (job.started > 0) json["started"] = time_text(job.started);
  if (job.finished > 0) json["finished"] = time_text(job.finished);
  if (job.kind == "sweep") json["variants"] = {{"total", job.total}, {"done", job.done}, {"failed", job.failed}};
  if (!status.best.is_null()) json["best"] = status.best;
  json["events"] = address + "/events";
  if (job.state == "succeeded") json["result"] = address + "/result";
  return json;
}

bool has_ended(const jobs::JobStatus& status) {
  constexpr std::array going = {"queued", "running", "canceling"};
  return std::ranges::find(going, status.record.state) == going.end();
}

Result<jobs::JobStatus> job_of(const Context& context) {
  const std::string& id = context.arguments.front();
  auto found = context.application.jobs.find(id);
  if (!found) return found.problems();
  if (!*found) {
    return Problem{.code = "not-found", .detail = "There is no job '" + escape_controls(id, 80) + "' here."};
  }
  return **std::move(found);
}

Parameter job_parameter() {
  return {.place = Parameter::Place::path,
          .name = "id",
          .doc = "The id of the job, as the answer to who began it says.",
          .example = std::string(32, '0')};
}

Parameter idempotency_key_header() {
  return {.place = Parameter::Place::header,
          .name = "Idempotency-Key",
          .doc = "Any word: who sends the same request with it again, because an answer was lost, gets the same job.",
          .example = "nightly-2026-11-29"};
}

Parameter prefer_header() {
  return {.place = Parameter::Place::header,
          .name = "Prefer",
          .doc = "`respond-async`: the evaluation becomes a job, which is answered with 202 before it is done.",
          .example = "respond-async"};
}

bool prefers_job(const Request& request) {
  return std::ranges::any_of(split(request.header("Prefer"), ','), [](std::string_view preference) {
    return equal_ignoring_case(trim(preference.substr(0, preference.find(';'))), "respond-async");
  });
}

void begin_job(const Context& context, Json body, const std::string& format, jobs::JobKind kind) {
  const auto key = idempotency_key(context.request());
  if (!key) return reply_problems(context, key.problems());
  const std::string text = dump(body);
  auto read = jobs::read_job_request(std::move(body), format, kind, context.engine());
  if (!read) return reply_problems(context, read.problems());
  const auto request = std::make_shared<const jobs::JobRequest>(*std::move(read));
  if (const auto* asked = std::get_if<EvaluateRequest>(&request->asked)) {
    const Cancel cancel(deadline_of(context, std::nullopt));
    const auto prepared = context.engine().prepare(*asked, cancel);
    return answer_with(context, [&] {
      if (prepared) return keep(context, text, format, *key, *request);
      return problem_reply(prepared.problems(), context.exchange(), context.engine().blocked(*asked, cancel));
    });
  }
  if (const auto* asked = std::get_if<FitRequest>(&request->asked)) {
    const auto bytes = fitting::check(context.engine(), *asked, Cancel(deadline_of(context, std::nullopt)));
    return answer_with(context, [&] {
      if (bytes) return keep(context, text, format, *key, *request);
      return problem_reply(bytes.problems(), context.exchange());
    });
  }
  const Digest name = DigestBuilder().text("cost of a job").text(text).finish();
  ask<jobs::SweepCost>(
      context, {.key = name, .deadline = deadline_of(context, std::nullopt)},
      [&engine = context.engine(), request](const Job& job) {
        return jobs::predict(engine, std::get<jobs::SweepRequest>(request->asked), job);
      },
      [context, text, format, key = *key, request](const std::shared_ptr<const jobs::SweepCost>&) {
        return keep(context, text, format, key, *request);
      });
}

std::vector<Answer> job_answers() {
  return {{.status = 202,
           .doc = "The job, which is done when it is its turn; `Location` is where to ask for it.",
           .contents = {{.type = "application/json", .schema = schema::reference("Job")}},
           .headers = {"Location", "Cache-Control"}}};
}

std::vector<std::string_view> job_problems() {
  return codes_of(ProblemKind::graph, {"not-acceptable", "idempotency-key-reused", "busy", "storage-full",
                                       "storage-failed", "deadline", "shutting-down"});
}

Operation describe_create_job() {
  return {
      .id = "createJob",
      .group = "Jobs",
      .title = "Long work, to be asked about later",
      .doc =
          "Takes the body of an evaluation or, with a `grid`, a `zip` or a `list`, of a sweep; checks it, keeps it, "
          "and answers before it is done. Jobs are done a few at once in the order in which they came, outlive the "
          "server's restarts, and have limits of their own: `job_milliseconds` for an evaluation, "
          "`sweep_milliseconds` for a sweep; a `deadline_ms` counts from when the job begins.",
      .parameters = {accept_header("The format that an evaluation is to write its model in; the answer to this "
                                   "request is JSON whatever it says."),
                     format_parameter(), idempotency_key_header()},
      .request = &evaluate_description(),
      .or_request = &sweep_description(),
      .answers = job_answers(),
      .problems = job_problems()};
}

void create_job(const Context& context) {
  const auto form = asked_form(context);
  if (!form) return reply_problems(context, form.problems());
  auto given = read_graph_body(context);
  if (!given) return reply_problems(context, given.problems());
  begin_job(context, std::move(given->json), form->format);
}

Operation describe_get_job() {
  return {.id = "getJob",
          .group = "Jobs",
          .title = "How a job fares",
          .doc =
              "Its state is one of `queued`, `running`, `succeeded`, `failed`, `canceling`, `canceled`, `expired`. "
              "`progress` counts finished work of all nodes, or the variants of a sweep, and never goes back while a "
              "job runs.",
          .parameters = {job_parameter()},
          .answers = {{.doc = "The job.",
                       .contents = {{.type = "application/json", .schema = schema::reference("Job")}},
                       .headers = {"Cache-Control"}}},
          .problems = {"not-found", "storage-failed"}};
}

Reply get_job(const Context& context) {
  const auto status = job_of(context);
  return status ? job_reply(context, *status, 200) : problem_reply(status.problems(), context.exchange());
}

Operation describe_cancel_job() {
  return {.id = "cancelJob",
          .group = "Jobs",
          .title = "Stop a job",
          .doc =
              "Stops it inside its kernels, or takes it back before it begins. One that has ended stays as it is, so "
              "this can be sent again.",
          .parameters = {job_parameter()},
          .answers = {{.doc = "The job as it is now.",
                       .contents = {{.type = "application/json", .schema = schema::reference("Job")}},
                       .headers = {"Cache-Control"}}},
          .problems = {"not-found", "storage-full", "storage-failed"}};
}

Reply cancel_job(const Context& context) {
  if (const auto known = job_of(context); !known) return problem_reply(known.problems(), context.exchange());
  const auto status = context.application.jobs.cancel(context.arguments.front());
  if (!status) return problem_reply(status.problems(), context.exchange());
  return *status ? job_reply(context, **status, 200) : get_job(context);
}

}  // namespace dini::server
