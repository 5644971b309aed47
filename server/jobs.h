#pragma once

// What the routes under /v1/jobs share.

#include <string>

#include "jobs/job_runner.h"
#include "server/application.h"
#include "server/operation.h"

namespace dini::server {

/// What is told of a job by a server below that path.
Json to_json(const jobs::JobStatus& status, const std::string& base_path);

/// Nothing changes in it any more.
bool has_ended(const jobs::JobStatus& status);

/// The job that an address names, or the problem that there is none.
Result<jobs::JobStatus> job_of(const Context& context);

/// The part of a path that names a job.
Parameter job_parameter();

/// The header that makes a request to begin a job one that can be sent again.
Parameter idempotency_key_header();

/// The header that makes a job of an evaluation.
Parameter prefer_header();

/// Whether `Prefer` asks for an answer before the work is done (RFC 7240).
bool prefers_job(const Request& request);

/// Keeps what a body asks for as a job and answers with it, at once or, for a sweep, once its cost is known.
void begin_job(const Context& context, Json body, const std::string& format,
               jobs::JobKind kind = jobs::JobKind::evaluate_or_sweep);

/// The answer to who begins a job.
std::vector<Answer> job_answers();
/// The problems that beginning a job may end in.
std::vector<std::string_view> job_problems();

}  // namespace dini::server
