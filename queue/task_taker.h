#pragma once

#include <chrono>
#include <optional>
#include <string>
#include <vector>

#include "queue/connection.h"
#include "queue/sweep_tasks.h"

namespace dini::queue {

std::string name_of(Lane lane);

/// One variant of a sweep that a worker was given.
struct Task {
  std::string lane;
  std::string entry;  ///< of the stream
  std::string sweep;
  std::size_t index = 0;
  std::size_t deliveries = 1;  ///< to how many it was given, this one included; others may have died of it
};

/// What a worker needs to know of a sweep.
struct TaskedSweep {
  std::string body;
  std::string about;
};

/// How a worker gets its variants and tells their lines. One for each thread.
class TaskTaker {
 public:
  struct Terms {
    std::string identity;                       ///< of engine and limits: others are given nothing
    std::string worker;                         ///< its name; no two have the same
    std::chrono::milliseconds silence{15'000};  ///< after so long without a heartbeat its variants go to others
    std::size_t most_deliveries = 3;            ///< a variant that was given to so many, and to no avail, is dead
  };

  TaskTaker(const Address& address, const Patience& patience, Terms terms);

  /// A variant; nothing when there was none for about so long.
  Answered<std::optional<Task>> take(std::chrono::milliseconds wait);
  /// What is to be known of a sweep; nothing when it is not there any more.
  Answered<std::optional<TaskedSweep>> find(const std::string& sweep);

  enum class Finished { counted, twice, unwanted };
  enum class Then { rest, take };
  /// Tells the line of a variant, and in the same breath asks for the next one, which `take` then has.
  Answered<Finished> finish(const Task& task, const std::string& line, Then then = Then::rest);
  /// Whether a variant was given that `take` has not handed out yet.
  bool has_next() const { return ahead_.has_value(); }

  /// Tells that the worker is well and computes these; answers the entries of those that it is to stop.
  Answered<std::vector<std::string>> beat(const std::vector<Task>& running);
  /// The worker ends, and computes nothing.
  Answered<Reply> leave();

  /// A file that was offered; null when it is not there.
  Answered<std::optional<std::string>> offered(const std::string& sha256);

  /// Whether Redis takes the password.
  Answered<bool> connect() { return connection_.connect(); }

 private:
  std::vector<std::string> take_words() const;

  Connection connection_;
  Terms terms_;
  std::string base_;
  std::optional<Task> ahead_;
};

}  // namespace dini::queue
