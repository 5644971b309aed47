#pragma once

#include <functional>
#include <memory>
#include <optional>

#include "server/application.h"

namespace dini::server {

/// When a request is to be answered at the latest: what its client allows, from its first byte on, but never past the
/// limit.
jobs::Flights::Clock::time_point deadline_of(const Context& context, std::optional<std::int64_t> milliseconds);

/// What is said of a request whose deadline passed, with where its time went.
Problem late_problem(const Context& context, jobs::Flights::Clock::time_point deadline, jobs::Flights::Begun begun);

/// Answers that a request is not let in, or that what was asked of it cannot be had.
void reply_problems(const Context& context, const Problems& problems);

/// What is wrong with the header `Supersede`, which says how older requests are replaced.
std::optional<Problem> wrong_supersede(const Request& request);

/// The newest request of the client's `Supersede-Key` is this one: see jobs::Supersede.
void take_over(const Context& context, const std::shared_ptr<jobs::Flights::Interest>& interest = nullptr);

/// Lets `work` be done by whoever does it first for that key, and `write` make an answer of its outcome, or see to it
/// that there is one later. Problems are answered as such; nobody waits on this thread. Null when it is not let in.
template <class T>
std::shared_ptr<jobs::Flights::Interest> ask(
    const Context& context, const jobs::Flights::Terms& terms,
    std::function<Result<std::shared_ptr<const T>>(const Job&)> work,
    std::function<std::optional<Reply>(const std::shared_ptr<const T>&)> write);

/// The same, as the newest request of the client's `Supersede-Key`.
template <class T>
void compute(const Context& context, const jobs::Flights::Terms& terms,
             std::function<Result<std::shared_ptr<const T>>(const Job&)> work,
             std::function<std::optional<Reply>(const std::shared_ptr<const T>&)> write) {
  if (const auto interest = ask<T>(context, terms, std::move(work), std::move(write))) take_over(context, interest);
}

// ---------------------------------------------------------------------------------------------------------------------

/// Runs a step of answering on one of the threads for answers.
void continue_with(const Context& context, std::function<std::optional<Reply>()> step);
/// Adds how long the work waited for a place to the times of the answer.
void note_queue(const Context& context, jobs::Flights::Clock::time_point asked, jobs::Flights::Begun begun);
void refuse_busy(const Context& context);
Reply problems_reply(const Context& context, const Problems& problems);
/// The answer to a request that was late. One that waited for a place all the time may be luckier another time.
Reply late_reply(const Context& context, jobs::Flights::Clock::time_point deadline, jobs::Flights::Begun begun);

template <class T>
std::shared_ptr<jobs::Flights::Interest> ask(
    const Context& context, const jobs::Flights::Terms& terms,
    std::function<Result<std::shared_ptr<const T>>(const Job&)> work,
    std::function<std::optional<Reply>(const std::shared_ptr<const T>&)> write) {
  using Outcome = Result<std::shared_ptr<const T>>;
  const auto asked = jobs::Flights::Clock::now();
  const auto interest =
      context.application.flights.ask<T>(terms, std::move(work),
                                         [context, asked, deadline = terms.deadline, write = std::move(write)](
                                             const Outcome& outcome, jobs::Flights::Begun begun) {
                                           continue_with(context, [=]() -> std::optional<Reply> {
                                             note_queue(context, asked, begun);
                                             if (outcome) return write(*outcome);
                                             if (outcome.problems().front().code != "deadline")
                                               return problems_reply(context, outcome.problems());
                                             return late_reply(context, deadline, begun);
                                           });
                                         });
  if (interest == nullptr) {
    refuse_busy(context);
  } else {
    context.call->watch(interest);
  }
  return interest;
}

}  // namespace dini::server
