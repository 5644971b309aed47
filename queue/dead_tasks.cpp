#include "queue/dead_tasks.h"

#include <map>
#include <set>

#include "queue/scripts.h"
#include "queue/sweep_tasks.h"

namespace dini::queue {
namespace {

constexpr std::int64_t silence = 15'000;

std::string text_of(std::int64_t number) { return std::to_string(number); }

/// The identities that anything is known of: those that have streams.
Answered<std::set<std::string>> identities(Connection& connection) {
  std::set<std::string> found;
  std::string cursor = "0";
  do {
    const auto reply = connection.call({"SCAN", cursor, "MATCH", "dini:*", "COUNT", "1000", "TYPE", "stream"});
    if (!reply) return reply.error();
    cursor = reply->list.at(0).text;
    for (const Reply& key : reply->list.at(1).list) {
      const auto first = key.text.find(':');
      found.insert(key.text.substr(first + 1, key.text.rfind(':') - first - 1));
    }
  } while (cursor != "0");
  return found;
}

/// The identity whose dead have an entry; empty for none.
Answered<std::string> identity_of_dead(Connection& connection, const std::string& entry) {
  const auto dead = dead_tasks(connection);
  if (!dead) return dead.error();
  for (const DeadTask& task : *dead) {
    if (task.entry == entry) return task.identity;
  }
  return std::string();
}

}  // namespace

Answered<QueueState> queue_state(Connection& connection, const std::string& identity) {
  const auto time = connection.call({"TIME"});
  if (!time) return time.error();
  const std::int64_t now = std::stoll(time->list.at(0).text) * 1000;
  const std::string base = base_of(identity);
  QueueState state{.identity = identity};
  const std::vector<std::pair<std::int64_t*, std::vector<std::string>>> asked = {
      {&state.interactive, {"XLEN", base + ":interactive"}},
      {&state.batch, {"XLEN", base + ":batch"}},
      {&state.dead, {"XLEN", base + ":dead"}},
      {&state.sweeps, {"ZCOUNT", base + ":sweeps", text_of(now), "+inf"}},
      {&state.workers, {"ZCOUNT", base + ":workers", text_of(now - silence), "+inf"}}};
  for (const auto& [number, words] : asked) {
    const auto reply = connection.call(words);
    if (!reply) return reply.error();
    *number = reply->number;
  }
  const auto counts = connection.call({"HMGET", base + ":counts", "counted", "twice", "again"});
  if (!counts) return counts.error();
  std::size_t place = 0;
  for (std::int64_t* const number : {&state.counted, &state.twice, &state.again}) {
    const Reply& told = counts->list.at(place++);
    if (!told.empty()) *number = std::stoll(told.text);
  }
  return state;
}

Answered<std::vector<QueueState>> queue_states(Connection& connection) {
  const auto known = identities(connection);
  if (!known) return known.error();
  std::vector<QueueState> states;
  for (const std::string& identity : *known) {
    auto state = queue_state(connection, identity);
    if (!state) return std::move(state).error();
    states.push_back(*std::move(state));
  }
  return states;
}

Answered<std::vector<DeadTask>> dead_tasks(Connection& connection) {
  const auto known = identities(connection);
  if (!known) return known.error();
  std::vector<DeadTask> tasks;
  for (const std::string& identity : *known) {
    const auto reply = connection.call({"XRANGE", base_of(identity) + ":dead", "-", "+"});
    if (!reply) return reply.error();
    for (const Reply& entry : reply->list) {
      std::map<std::string, std::string> told;
      const std::vector<Reply>& fields = entry.list.at(1).list;
      for (std::size_t i = 0; i + 1 < fields.size(); i += 2) told[fields[i].text] = fields[i + 1].text;
      tasks.push_back(
          {entry.list.at(0).text, identity, told["sweep"], told["index"], told["deliveries"], told["worker"]});
    }
  }
  return tasks;
}

Answered<Retried> retry(Connection& connection, const std::string& entry) {
  const auto identity = identity_of_dead(connection, entry);
  if (!identity) return identity.error();
  if (identity->empty()) return Retried::none;
  const auto reply = connection.run(scripts::dead_retry, {}, {base_of(*identity), entry});
  if (!reply) return reply.error();
  return reply->text == "again" ? Retried::again : reply->text == "ended" ? Retried::ended : Retried::none;
}

Answered<bool> drop_dead(Connection& connection, const std::string& entry) {
  const auto identity = identity_of_dead(connection, entry);
  if (!identity) return identity.error();
  if (identity->empty()) return false;
  const auto reply = connection.call({"XDEL", base_of(*identity) + ":dead", entry});
  if (!reply) return reply.error();
  return reply->number == 1;
}

}  // namespace dini::queue
