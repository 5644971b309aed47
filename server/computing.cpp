#include "server/computing.h"

#include <algorithm>
#include <cmath>

#include "server/responses.h"
#include "server/routes.h"
#include "server/text.h"

namespace dini::server {
namespace {

using Clock = jobs::Flights::Clock;

/// The one word that the header `Supersede` may be.
constexpr std::string_view after_current = "after-current";

std::string milliseconds_text(Clock::duration duration) {
  const double milliseconds = std::chrono::duration<double, std::milli>(duration).count();
  return std::to_string(std::llround(milliseconds)) + " ms";
}

}  // namespace

Clock::time_point deadline_of(const Context& context, std::optional<std::int64_t> milliseconds) {
  const auto limit = static_cast<std::int64_t>(context.engine().limits().interactive_milliseconds);
  return context.exchange().started + std::chrono::milliseconds(std::min(milliseconds.value_or(limit), limit));
}

Problem late_problem(const Context& context, Clock::time_point deadline, jobs::Flights::Begun begun) {
  const auto arrived = context.exchange().started;
  std::string detail = "the work was not done within the deadline of " + milliseconds_text(deadline - arrived);
  if (!begun) {
    detail += ": it waited for a place to compute all the time";
  } else {
    detail += "; " + milliseconds_text(*begun - arrived) + " of it passed before it began";
  }
  return {.code = "deadline", .detail = std::move(detail)};
}

Reply problems_reply(const Context& context, const Problems& problems) {
  if (!problems.empty() && problems.front().code == "out-of-memory") context.application.release_memory();
  return problem_reply(problems, context.exchange());
}

Reply late_reply(const Context& context, Clock::time_point deadline, jobs::Flights::Begun begun) {
  Reply reply = problem_reply(late_problem(context, deadline, begun), context.exchange());
  if (!begun) reply.headers.emplace_back("Retry-After", "1");
  return reply;
}

void reply_problems(const Context& context, const Problems& problems) {
  answer_with(context, [&] { return problems_reply(context, problems); });
}

std::optional<Problem> wrong_supersede(const Request& request) {
  if (!request.has_header("Supersede") || trim(request.header("Supersede")) == after_current) return std::nullopt;
  return Problem{.code = "not-in-choices",
                 .detail = "The header Supersede is left out or '" + std::string(after_current) + "'.",
                 .in_request = true};
}

void take_over(const Context& context, const std::shared_ptr<jobs::Flights::Interest>& interest) {
  const bool patient = trim(context.request().header("Supersede")) == after_current;
  context.application.supersede.take_over(std::string(context.request().header("Supersede-Key")),
                                          context.exchange().started, interest,
                                          patient ? jobs::Superseding::after_current : jobs::Superseding::at_once);
}

void continue_with(const Context& context, std::function<std::optional<Reply>()> step) {
  context.application.threads.post([context, step = std::move(step)] { answer_with(context, step); });
}

void note_queue(const Context& context, Clock::time_point asked, jobs::Flights::Begun begun) {
  const auto waited = begun ? std::max(Clock::duration{}, *begun - asked) : Clock::now() - asked;
  context.call->note_time("queue", std::chrono::duration<double, std::milli>(waited).count());
}

void refuse_busy(const Context& context) {
  reply_problems(context,
                 {{.code = "busy",
                   .detail = "Every place to compute and the whole queue before them are taken; try again in a "
                             "moment."}});
}

}  // namespace dini::server
