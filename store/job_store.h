#pragma once

#include <chrono>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "graph/digest.h"
#include "graph/file.h"
#include "graph/problem.h"

namespace dini::store {

class Database;

/// What is known of a job without what it was asked and what came of it. Times are milliseconds since 1970, UTC, and 0
/// for what has not happened.
struct JobRecord {
  std::string id;
  std::string kind;
  std::string state;
  std::int64_t created = 0;
  std::int64_t started = 0;
  std::int64_t finished = 0;
  std::string format;         ///< of its models
  std::int64_t total = 0;     ///< variants of a sweep
  std::int64_t done = 0;      ///< of these, those that have a line
  std::int64_t failed = 0;    ///< of these, those that failed
  std::string errors = "[]";  ///< JSON
};

/// A job to keep.
struct NewJob {
  std::string id;
  std::string kind;
  std::string idempotency_key;  ///< empty for none
  std::string_view body;
  std::string format;
  std::int64_t total = 0;
};

struct AddedJob {
  enum class Outcome { added, known, conflict };
  Outcome outcome = Outcome::added;
  JobRecord job;  ///< the new one, or the one that has the key
};

/// What came of a variant of a sweep.
struct JobLine {
  std::size_t index = 0;
  bool failed = false;
  std::string text;                    ///< JSON in one line
  std::vector<SharedFile> files = {};  ///< that were made
};

/// What came of an evaluation.
struct JobResult {
  std::string report;    ///< JSON
  SharedFile file = {};  ///< null when none was made
};

/// Jobs by id, in the database of the graphs. What a function was told is kept when it returns. All problems are
/// `storage-full` or `storage-failed`.
class JobStore {
 public:
  explicit JobStore(std::shared_ptr<Database> database);

  /// Keeps a job that waits; with a key that a job has already, tells that one: `known` for the same body and format,
  /// `conflict` for others. At most `most_waiting` wait; then nothing.
  Result<std::optional<AddedJob>> add(const NewJob& job, std::size_t most_waiting);

  Result<std::optional<JobRecord>> find(std::string_view id) const;
  /// The ids of those that have not ended: first those that were begun, each in the order in which they came.
  Result<std::vector<std::string>> unfinished() const;
  /// What was sent to begin it; empty for a job that is not there.
  Result<std::string> body(std::string_view id) const;

  /// False for one that is not there or has ended.
  Result<bool> begin(std::string_view id);
  Result<bool> add_lines(std::string_view id, const std::vector<JobLine>& lines);
  /// Ends it, unless it has ended. `errors` is JSON.
  Result<bool> finish(std::string_view id, std::string_view state, const std::string& errors, const JobResult& result);

  /// What came of an evaluation, or of a sweep: its lines.
  Result<JobResult> result(std::string_view id) const;
  Result<std::string> lines(std::string_view id) const;
  /// A file that a job made; null when none is kept.
  Result<SharedFile> file(const Digest& sha256) const;

  /// Lets go of what came of jobs that ended longer ago than this, and of all that is known of those that ended longer
  /// ago than twice this.
  Result<bool> expire(std::chrono::milliseconds result_time);

 private:
  std::shared_ptr<Database> database_;
};

}  // namespace dini::store
