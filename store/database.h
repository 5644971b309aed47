#pragma once

#include <SQLiteCpp/Database.h>
#include <SQLiteCpp/Exception.h>
#include <SQLiteCpp/Transaction.h>
#include <atomic>
#include <filesystem>
#include <memory>
#include <mutex>
#include <optional>

#include "graph/problem.h"
#include "store/data_folder.h"

namespace dini::store {

/// What a failure of SQLite is to a client: `storage-full`, or `storage-failed` with what SQLite says.
Problem problem_of(const SQLite::Exception& error);

/// The database of a data folder, which this process alone writes, or one in memory. What was written has reached the
/// disk when `write` returns. Any thread; who reads waits for no disk.
class Database {
 public:
  /// Problems (`io`), of one line each: the folder is held by another process, or the database cannot be written, is
  /// damaged, is another program's, or has been lost. A database is made only in a folder that was never used.
  static Result<std::unique_ptr<Database>> open(const std::filesystem::path& folder, std::size_t most_bytes);
  static std::unique_ptr<Database> in_memory(std::size_t most_bytes);
  /// An empty one in which every write is `storage-failed` with that detail.
  static std::unique_ptr<Database> refusing(const std::string& detail);
  /// To look only, while another process may write.
  static Result<std::unique_ptr<Database>> open_to_read(const std::filesystem::path& folder);

  /// Work that changes nothing.
  template <class Work>
  auto read(Work work) -> decltype(work(std::declval<SQLite::Database&>())) {
    const std::lock_guard lock(one_connection_ ? writing_ : reading_);
    try {
      if (!one_connection_ && !reader_) reader_ = reading(database_file(folder_->path()));
      return work(one_connection_ ? *writer_ : *reader_);
    } catch (const SQLite::Exception& error) {
      return problem_of(error);
    }
  }

  /// Work as a whole or, when it gives a problem, not at all.
  template <class Work>
  auto write(Work work) -> decltype(work(std::declval<SQLite::Database&>())) {
    if (!refusal_.empty()) return Problem{.code = "storage-failed", .detail = refusal_};
    const std::lock_guard lock(writing_);
    try {
      if (!writer_) writer_ = reopened();
      SQLite::Transaction transaction(*writer_, SQLite::TransactionBehavior::IMMEDIATE);
      auto outcome = work(*writer_);
      if (outcome) transaction.commit();
      failed_ = false;
      return outcome;
    } catch (const SQLite::Exception& error) {
      failed_ = true;
      forget_connections_after(error);
      return problem_of(error);
    }
  }

  /// Where it is; nothing in memory.
  std::optional<std::filesystem::path> folder() const {
    return folder_ ? std::optional(folder_->path()) : std::nullopt;
  }

  /// Whether the last write met a failure.
  bool has_failed() const { return failed_; }

  /// Work outside of a transaction, such as VACUUM.
  template <class Work>
  auto maintain(Work work) -> decltype(work(std::declval<SQLite::Database&>())) {
    const std::lock_guard lock(writing_);
    try {
      if (!writer_ && !reader_) writer_ = reopened();
      return work(writer_ ? *writer_ : *reader_);
    } catch (const SQLite::Exception& error) {
      return problem_of(error);
    }
  }

 private:
  explicit Database(std::size_t most_bytes, bool one_connection = false)
      : most_bytes_(most_bytes), one_connection_(one_connection) {}

  static std::unique_ptr<SQLite::Database> reading(const std::filesystem::path& file);
  std::unique_ptr<SQLite::Database> connected(const std::filesystem::path& file) const;
  /// The connection once more after a failure that left in doubt what was written: checked before it is used.
  std::unique_ptr<SQLite::Database> reopened();
  void forget_connections_after(const SQLite::Exception& error);

  std::size_t most_bytes_;
  const bool one_connection_;         ///< in memory, where `writer_` reads too
  std::string refusal_;               ///< why nothing is written; empty when it is
  std::optional<DataFolder> folder_;  ///< none in memory
  std::atomic<bool> failed_ = false;
  std::mutex reading_;
  std::mutex writing_;
  std::unique_ptr<SQLite::Database> writer_;  ///< null after a failure, or to look only
  std::unique_ptr<SQLite::Database> reader_;  ///< null in memory, and after a failure
};

}  // namespace dini::store
