#pragma once

#include <string>
#include <vector>

#include "queue/connection.h"

namespace dini::queue {

/// A variant that ended as many workers as it may.
struct DeadTask {
  std::string entry;  ///< names it
  std::string identity;
  std::string sweep;
  std::string index;
  std::string deliveries;
  std::string worker;  ///< the last one that was given it
};

/// What lies in the queue of one identity.
struct QueueState {
  std::string identity = {};
  std::int64_t interactive = 0, batch = 0;  ///< variants that wait or are computed
  std::int64_t sweeps = 0;
  std::int64_t workers = 0;  ///< that are well
  std::int64_t dead = 0;
  std::int64_t counted = 0;  ///< variants that were computed so far
  std::int64_t twice = 0;    ///< that another had computed meanwhile
  std::int64_t again = 0;    ///< that were given to another worker, because the first was silent
};

Answered<QueueState> queue_state(Connection& connection, const std::string& identity);

/// What lies there, by identity.
Answered<std::vector<QueueState>> queue_states(Connection& connection);
Answered<std::vector<DeadTask>> dead_tasks(Connection& connection);

/// What `retry` comes to: there is none of that name, it is computed again, or its sweep has ended.
enum class Retried { none, again, ended };
Answered<Retried> retry(Connection& connection, const std::string& entry);
/// False for none of that name.
Answered<bool> drop_dead(Connection& connection, const std::string& entry);

}  // namespace dini::queue
