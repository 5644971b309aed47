// What came of a job.

#include "server/evaluation.h"
#include "server/handlers.h"
#include "server/jobs.h"
#include "server/negotiation.h"
#include "server/responses.h"
#include "service/requests/schema.h"

namespace dini::server {
namespace {

constexpr std::string_view report_type = "application/json";
constexpr std::string_view line_type = "application/x-ndjson";

/// Why a job has nothing to show; nothing for one that succeeded.
std::optional<Reply> no_result(const Context& context, const jobs::JobStatus& status) {
  const std::string& state = status.record.state;
  const auto refused = [&](const std::string& code, const std::string& detail) {
    return problem_reply(Problem{.code = code, .detail = detail}, context.exchange());
  };
  if (state == "succeeded") return std::nullopt;
  if (!has_ended(status)) return refused("job-unfinished", "The job is " + state + "; ask again when it has ended.");
  if (state == "canceled") return refused("canceled", "The job was canceled, so nothing came of it.");
  if (state == "expired") return refused("job-expired", "What came of the job is not kept any more; begin it again.");
  Problems problems;
  for (const Json& error : Json::parse(status.record.errors)) {
    problems.push_back({.code = error.value("code", "internal"),
                        .detail = error.value("detail", ""),
                        .node = error.value("node", ""),
                        .port = error.value("port", ""),
                        .in_request = true});
    if (error.contains("pointer")) problems.back().pointer = error["pointer"].get<std::string>();
  }
  return problem_reply(problems, context.exchange());
}

Reply reply_with(std::string_view type, SharedBytes bytes) {
  return {.type = std::string(type), .body = {std::move(bytes)}, .headers = {{"Cache-Control", "private, no-cache"}}};
}

Reply result_of(const Context& context, const jobs::JobStatus& status) {
  const store::JobStore& kept = context.application.jobs.kept();
  const std::string& id = status.record.id;
  const bool is_sweep = status.record.kind == "sweep";
  store::JobResult result;
  if (!is_sweep) {
    auto found = kept.result(id);
    if (!found) return problem_reply(found.problems(), context.exchange());
    result = *std::move(found);
  }
  std::vector<std::string_view> types;
  if (result.file) types.push_back(result.file->media_type);
  types.push_back(is_sweep ? line_type : report_type);
  const auto type = accepted_type(context.request().header("Accept"), types);
  if (!type) return problem_reply(type.problems(), context.exchange());
  if (*type == report_type) return reply_with(*type, share(std::move(result.report)));
  if (!is_sweep) return reply_with(*type, result.file->bytes);
  auto lines = kept.lines(id);
  if (!lines) return problem_reply(lines.problems(), context.exchange());
  return reply_with(*type, share(*std::move(lines)));
}

}  // namespace

Operation describe_job_result() {
  std::vector<Content> contents;
  for (const FileFormat& format : usual_formats()) contents.push_back({.type = format.media_types.front()});
  contents.push_back({.type = std::string(report_type),
                      .schema = {{"anyOf", {schema::reference("Report"), schema::reference("Fit")}}}});
  contents.push_back({.type = std::string(line_type), .schema = schema::reference("SweepLine")});
  return {.id = "getJobResult",
          .group = "Jobs",
          .title = "What came of a job",
          .doc =
              "Of an evaluation the file or, by `Accept`, the report; of a fit what was found; of a sweep a line of "
              "JSON for each variant, as "
              "`POST /v1/sweeps` answers. A job that failed is answered with its problems.",
          .parameters = {job_parameter(), accept_header("The file, the report, or the lines.")},
          .answers = {{.doc = "The file, the report, or the lines.",
                       .contents = std::move(contents),
                       .headers = {"Cache-Control"}}},
          .problems =
              codes_of(ProblemKind::graph, {"not-found", "job-unfinished", "canceled", "job-expired", "not-acceptable",
                                            "storage-full", "storage-failed", "deadline", "out-of-memory"})};
}

Reply job_result(const Context& context) {
  const auto status = job_of(context);
  if (!status) return problem_reply(status.problems(), context.exchange());
  if (auto refusal = no_result(context, *status)) return *std::move(refusal);
  return result_of(context, *status);
}

}  // namespace dini::server
