#include "store/database.h"

#include <sqlite3.h>

#include "store/schema.h"

namespace dini::store {
namespace {

/// Who reads while another process writes waits so long for a lock.
constexpr int patience_milliseconds = 2000;

bool is_full(const SQLite::Exception& error) {
  return error.getErrorCode() == SQLITE_FULL || error.getExtendedErrorCode() == SQLITE_IOERR_SHMSIZE;
}

/// Lets a database grow so far and no further.
void bound(SQLite::Database& database, std::size_t most_bytes) {
  const auto page = static_cast<std::size_t>(database.execAndGet("PRAGMA page_size").getInt64());
  database.exec("PRAGMA max_page_count = " + std::to_string(std::max<std::size_t>(1, most_bytes / page)));
}

/// Makes the database beside its place, so that one that was not finished is never taken for one that lost everything.
void make_database(const std::filesystem::path& file) {
  const std::filesystem::path begun = std::filesystem::path(file).concat(".new");
  std::filesystem::remove(begun);
  {
    SQLite::Database database(begun.string(), SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE);
    database.exec("PRAGMA synchronous = FULL");
    SQLite::Transaction transaction(database);
    make_tables(database);
    transaction.commit();
  }
  std::filesystem::rename(begun, file);
}

}  // namespace

Problem problem_of(const SQLite::Exception& error) {
  if (is_full(error)) {
    return {.code = "storage-full",
            .detail = "There is no room to keep this: the disk is full, or what is kept has reached `store_bytes`."};
  }
  return {.code = "storage-failed",
          .detail = std::string("What is kept cannot be read or written just now: ") + error.what() + "."};
}

std::unique_ptr<SQLite::Database> Database::reading(const std::filesystem::path& file) {
  return std::make_unique<SQLite::Database>(file.string(), SQLite::OPEN_READONLY, patience_milliseconds);
}

std::unique_ptr<SQLite::Database> Database::connected(const std::filesystem::path& file) const {
  auto database = std::make_unique<SQLite::Database>(file.string(), SQLite::OPEN_READWRITE, patience_milliseconds);
  database->exec("PRAGMA journal_mode = WAL");
  database->exec("PRAGMA synchronous = FULL");
  database->exec("PRAGMA foreign_keys = ON");
  bound(*database, most_bytes_);
  return database;
}

Result<std::unique_ptr<Database>> Database::open(const std::filesystem::path& folder, std::size_t most_bytes) {
  auto held = DataFolder::hold(folder);
  if (!held) return held.problems();
  const std::filesystem::path file = database_file(folder);
  std::unique_ptr<Database> database(new Database(most_bytes));
  database->folder_.emplace(*std::move(held));
  try {
    std::error_code error;
    if (!std::filesystem::exists(file, error)) {
      if (error) return io_problem(file, error.message());
      if (const auto trace = trace_of_use(folder)) {
        return io_problem(file, "the database is missing, but the folder has " + trace->filename().string() +
                                    "; restore a backup, or give an empty folder with --data");
      }
      make_database(file);
    }
    // What is damaged is only read, so that whoever mends it finds it as it was.
    database->reader_ = reading(file);
    if (const std::string fault = fault_in(*database->reader_); !fault.empty()) return io_problem(file, fault);
    database->writer_ = database->connected(file);
    if (sqlite3_db_readonly(database->writer_->getHandle(), "main") != 0) {
      return io_problem(file, "the database cannot be written");
    }
    upgrade(*database->writer_);
  } catch (const SQLite::Exception& error) {
    const bool damaged = error.getErrorCode() == SQLITE_NOTADB || error.getErrorCode() == SQLITE_CORRUPT;
    return io_problem(file, (damaged ? "the database is damaged, restore a backup: " : "") + std::string(error.what()));
  } catch (const std::filesystem::filesystem_error& error) {
    return io_problem(file, error.code().message());
  }
  return database;
}

std::unique_ptr<Database> Database::in_memory(std::size_t most_bytes) {
  std::unique_ptr<Database> database(new Database(most_bytes, true));
  database->writer_ = std::make_unique<SQLite::Database>(":memory:", SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE);
  database->writer_->exec("PRAGMA foreign_keys = ON");
  make_tables(*database->writer_);
  bound(*database->writer_, most_bytes);
  return database;
}

std::unique_ptr<Database> Database::refusing(const std::string& detail) {
  constexpr std::size_t for_tables = 1 << 20;
  std::unique_ptr<Database> database = in_memory(for_tables);
  database->refusal_ = detail;
  return database;
}

Result<std::unique_ptr<Database>> Database::open_to_read(const std::filesystem::path& folder) {
  const std::filesystem::path file = database_file(folder);
  std::error_code error;
  if (!std::filesystem::exists(file, error)) return io_problem(file, "there is no such database");
  std::unique_ptr<Database> database(new Database(0));
  try {
    database->reader_ = reading(file);
    database->reader_->execAndGet("PRAGMA user_version");
  } catch (const SQLite::Exception& failure) {
    return io_problem(file, failure.what());
  }
  return database;
}

std::unique_ptr<SQLite::Database> Database::reopened() {
  std::unique_ptr<SQLite::Database> database = connected(database_file(folder_->path()));
  if (const std::string fault = fault_in(*database); !fault.empty()) throw SQLite::Exception(fault, SQLITE_CORRUPT);
  return database;
}

void Database::forget_connections_after(const SQLite::Exception& error) {
  if (!folder_ || is_full(error) || error.getErrorCode() == SQLITE_CONSTRAINT) return;
  writer_ = nullptr;
  // A lock that could not be given back is held by the process until its last connection is closed.
  const std::lock_guard lock(reading_);
  reader_ = nullptr;
}

}  // namespace dini::store
