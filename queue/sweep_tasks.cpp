#include "queue/sweep_tasks.h"

#include <algorithm>

#include "graph/digest.h"
#include "queue/scripts.h"
#include "queue/task_taker.h"

namespace dini::queue {
namespace {

/// Sweeps of one identity at once.
constexpr std::size_t most_sweeps = 256;
/// Lines that are taken at once.
constexpr std::size_t collected_bytes = std::size_t{8} << 20;
/// How long a file lies there that was offered, after it was last.
constexpr std::chrono::seconds offer_time{24 * 3600};

void append(std::vector<std::string>& words, const std::vector<std::size_t>& numbers) {
  for (const std::size_t number : numbers) words.push_back(std::to_string(number));
}

}  // namespace

std::string base_of(const std::string& identity) { return "dini:" + identity; }

std::string place_of_line(const std::string& base, const std::string& sweep, std::size_t index) {
  return base + ":sweep:" + sweep + ":line:" + std::to_string(index);
}

std::string offered_file(const std::string& sha256) { return "dini:file:" + sha256; }

SweepTasks::SweepTasks(const Address& address, const Patience& patience, const std::string& identity)
    : connection_(address, patience), base_(base_of(identity)) {}

Answered<SweepTasks::Submitted> SweepTasks::submit(const QueuedSweep& sweep, const std::vector<std::size_t>& have) {
  std::vector<std::string> words = {base_,
                                    sweep.id,
                                    name_of(sweep.lane),
                                    sweep.body,
                                    to_hex(sha256(sweep.body)),
                                    sweep.about,
                                    std::to_string(sweep.total),
                                    std::to_string(sweep.first),
                                    std::to_string(most_sweeps),
                                    std::to_string(sweep_time_to_live.count())};
  append(words, have);
  const auto reply = connection_.run(scripts::submit, {}, words);
  if (!reply) return reply.error();
  return reply->text == "full" ? Submitted::full : reply->text == "unmanned" ? Submitted::unmanned : Submitted::taken;
}

Answered<SweepTasks::Collected> SweepTasks::collect(const std::string& id, std::size_t limit,
                                                    const std::vector<std::size_t>& have) {
  std::vector<std::string> words = {base_, id, std::to_string(sweep_time_to_live.count()), std::to_string(limit),
                                    std::to_string(collected_bytes)};
  append(words, have);
  auto reply = connection_.run(scripts::collect, {}, words);
  if (!reply) return reply.error();
  Collected collected;
  const std::string state = reply->list.empty() ? "gone" : reply->list.front().text;
  collected.gone = state == "gone";
  collected.idle = state == "idle";
  std::vector<std::string> places = {"MGET"};
  std::vector<std::size_t> long_ones;
  for (std::size_t i = 1; i + 1 < reply->list.size(); i += 2) {
    const std::size_t index = std::stoul(reply->list[i].text);
    std::string& line = reply->list[i + 1].text;
    const bool is_dead = line == "dead", is_long = line == "long";
    if (is_long) {
      places.push_back(place_of_line(base_, id, index));
      long_ones.push_back(collected.lines.size());
    }
    collected.lines.push_back({index, is_dead || is_long ? std::string() : std::move(line), is_dead});
  }
  if (long_ones.empty()) return collected;
  auto lines = connection_.call(places);
  if (!lines) return lines.error();
  for (std::size_t i = 0; i < lines->list.size(); ++i) {
    collected.lines[long_ones.at(i)].line = std::move(lines->list[i].text);
  }
  return collected;
}

Answered<Reply> SweepTasks::redo(const std::string& id, std::size_t index) {
  return connection_.run(scripts::redo, {}, {base_, id, std::to_string(index)});
}

Answered<Reply> SweepTasks::drop(const std::string& id) { return connection_.run(scripts::drop, {}, {base_, id}); }

Answered<Reply> SweepTasks::offer_file(const std::string& sha256, const std::string& bytes) {
  return connection_.call({"SET", offered_file(sha256), bytes, "EX", std::to_string(offer_time.count())});
}

}  // namespace dini::queue
