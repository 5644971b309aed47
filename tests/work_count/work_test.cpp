// Whatever a node has to do, little of it is done once nobody wants it any more.

#include <catch2/catch.hpp>

#include "tests/nodes/large_graphs.h"
#include "tests/work_count/work_count.h"

using namespace dini;
using namespace dini::support;

namespace {

/// About 10 milliseconds of the released program on one processor, for each of the two that tests run on.
constexpr std::uint64_t most_after_stop = 4'000'000;

/// What is stopped has to be much more than that, or nothing is shown.
constexpr std::uint64_t much = 3 * most_after_stop;

struct Planned {
  Plan plan;
  std::size_t subject = 0;
};

std::optional<Planned> planned(const Json& nodes, std::size_t work) {
  const Result<Document> read = read_document(document(nodes), Limits{}, catalogue());
  REQUIRE(read);
  Limits limits;
  limits.work = work;
  CheckReport report = check(catalogue(), *read, {}, Quality::final, limits, test_file, {{"subject"}, false});
  for (const Problem& problem : report.problems) {
    if (problem.code != "limit-exceeded") FAIL(problem.code << " at " << problem.node << ": " << problem.detail);
  }
  if (!report.problems.empty()) return std::nullopt;
  const std::size_t subject = report.plan.index.at("subject");
  return Planned{std::move(report.plan), subject};
}

/// Everything that the subject needs, computed before.
void compute_sources(const Planned& planned, Cache& cache) {
  std::vector<std::size_t> sources;
  for (const PlannedInput& input : planned.plan.nodes[planned.subject].inputs) {
    for (const PlannedItem& item : input.items) {
      if (const auto* source = std::get_if<Source>(&item.from)) sources.push_back(source->node);
    }
  }
  REQUIRE(evaluate(planned.plan, sources, cache, Job()));
}

/// What the subject still computes when it is stopped after so much work; nothing when it was ready before.
std::optional<std::uint64_t> work_after_stop(const Planned& planned, Cache& cache, std::uint64_t stop_at) {
  const Job job;
  if (stop_at == 0) job.cancel.stop(StopReason::superseded);
  const std::uint64_t begin = work_done();
  if (stop_at > 0) stop_after(job.cancel, stop_at);
  const Result<Evaluation> evaluation = evaluate(planned.plan, {planned.subject}, cache, job);
  if (stop_at == 0) return work_done() - begin;
  if (work_at_stop() == 0) {
    stop_after(job.cancel, std::numeric_limits<std::uint32_t>::max());  // no alarm is left behind
    return std::nullopt;
  }
  CHECK_FALSE(evaluation);
  return work_done() - work_at_stop();
}

/// Each node of a quarter is stopped before it begins and anywhere within.
void check_stops(std::size_t quarter) {
  const std::vector<Subject> subjects = quarter_of_subjects(quarter);
  std::size_t stopped_within = 0;
  for (const Subject& subject : subjects) {
    for (const std::size_t size : {400'000, 20'000}) {
      for (const Json& nodes : large_graphs(subject, size)) {
        CAPTURE(subject.name(), size, nodes.dump());
        const auto large = planned(nodes, Limits().work);
        if (!large) continue;
        Cache cache(std::size_t{4} << 30);
        compute_sources(*large, cache);
        for (const std::uint64_t stop_at : {0, 10'000, 200'000, 1'000'000, 3'000'000, 8'000'000}) {
          CAPTURE(stop_at);
          const auto more = work_after_stop(*large, cache, stop_at);
          if (!more) break;  // it was ready before, and is in the cache now
          CHECK(*more <= most_after_stop);
          if (stop_at + most_after_stop >= much) ++stopped_within;
        }
      }
    }
  }
  CHECK(stopped_within >= subjects.size());
}

}  // namespace

TEST_CASE("A node that is stopped computes little more: first quarter") { check_stops(0); }

TEST_CASE("A node that is stopped computes little more: second quarter") { check_stops(1); }

TEST_CASE("A node that is stopped computes little more: third quarter") { check_stops(2); }

TEST_CASE("A node that is stopped computes little more: last quarter") { check_stops(3); }
