#include "store/schema.h"

#include <SQLiteCpp/Statement.h>
#include <SQLiteCpp/Transaction.h>
#include <algorithm>
#include <array>

#include "store/asset_references.h"

namespace dini::store {
namespace {

constexpr int application_id = 0x44696e69;  // "Dini"
/// Every version of every graph for ever, and which of them is the current one. A graph that is deleted keeps its
/// versions. `digest` is of the document's bytes, `hash` of the graph that it means.
void add_graphs(SQLite::Database& database) {
  database.exec(R"(
    CREATE TABLE versions (
      id TEXT NOT NULL,
      version INTEGER NOT NULL,
      created INTEGER NOT NULL,
      hash BLOB NOT NULL,
      digest BLOB NOT NULL,
      bytes INTEGER NOT NULL,
      title TEXT NOT NULL,
      document BLOB NOT NULL,
      PRIMARY KEY (id, version)
    );
    CREATE TABLE graphs (
      id TEXT PRIMARY KEY,
      version INTEGER NOT NULL,
      deleted INTEGER,
      FOREIGN KEY (id, version) REFERENCES versions (id, version)
    ) WITHOUT ROWID;
  )");
}

/// Which uploaded files the versions name, so that those are not the ones to make room.
void add_asset_references(SQLite::Database& database) {
  database.exec(R"(
    CREATE TABLE asset_references (
      sha256 BLOB NOT NULL,
      id TEXT NOT NULL,
      version INTEGER NOT NULL,
      PRIMARY KEY (sha256, id, version)
    ) WITHOUT ROWID;
  )");
  SQLite::Statement select(database, "SELECT id, version, document FROM versions");
  while (select.executeStep()) {
    insert_references(database, select.getColumn(0).getString(), select.getColumn(1).getInt64(),
                      select.getColumn(2).getString());
  }
}

/// Long work: what was asked, how it fares, and what came of it. `body` is the request as it was sent, so that the work
/// can begin again; `digest` is of it. A sweep has a line for each variant that is done. Files are kept once, however
/// many jobs have made them.
void add_jobs(SQLite::Database& database) {
  database.exec(R"(
    CREATE TABLE jobs (
      number INTEGER PRIMARY KEY,
      id TEXT NOT NULL UNIQUE,
      kind TEXT NOT NULL,
      state TEXT NOT NULL,
      created INTEGER NOT NULL,
      started INTEGER NOT NULL DEFAULT 0,
      finished INTEGER NOT NULL DEFAULT 0,
      idempotency_key TEXT UNIQUE,
      digest BLOB NOT NULL,
      body BLOB NOT NULL,
      format TEXT NOT NULL,
      total INTEGER NOT NULL,
      errors TEXT NOT NULL DEFAULT '[]',
      report TEXT NOT NULL DEFAULT ''
    );
    CREATE INDEX jobs_by_state ON jobs (state, finished);
    CREATE TABLE job_lines (
      job INTEGER NOT NULL REFERENCES jobs (number) ON DELETE CASCADE,
      line INTEGER NOT NULL,
      failed INTEGER NOT NULL,
      text TEXT NOT NULL,
      PRIMARY KEY (job, line)
    ) WITHOUT ROWID;
    CREATE TABLE files (
      sha256 BLOB PRIMARY KEY,
      media_type TEXT NOT NULL,
      extension TEXT NOT NULL,
      bytes BLOB NOT NULL
    );
    CREATE TABLE job_files (
      job INTEGER NOT NULL REFERENCES jobs (number) ON DELETE CASCADE,
      sha256 BLOB NOT NULL REFERENCES files (sha256),
      PRIMARY KEY (job, sha256)
    ) WITHOUT ROWID;
    CREATE INDEX job_files_by_file ON job_files (sha256);
  )");
}

/// What makes each version of the schema of the one before it; the first, of an empty database. A step is never
/// changed.
constexpr std::array steps = {add_graphs, add_asset_references, add_jobs};
constexpr int schema_version = static_cast<int>(steps.size());

int version_of(SQLite::Database& database) { return database.execAndGet("PRAGMA user_version").getInt(); }

void take_steps(SQLite::Database& database) {
  for (int version = version_of(database); version < schema_version; ++version) {
    steps[static_cast<std::size_t>(version)](database);
  }
  database.exec("PRAGMA user_version = " + std::to_string(schema_version));
}

}  // namespace

void make_tables(SQLite::Database& database) {
  database.exec("PRAGMA application_id = " + std::to_string(application_id));
  take_steps(database);
}

void upgrade(SQLite::Database& database) {
  if (version_of(database) == schema_version) return;
  SQLite::Transaction transaction(database, SQLite::TransactionBehavior::IMMEDIATE);
  take_steps(database);
  transaction.commit();
}

std::string fault_in(SQLite::Database& database) {
  if (database.execAndGet("PRAGMA application_id").getInt() != application_id) return "this is no database of Dini";
  const int version = version_of(database);
  if (version < 1 || version > schema_version) {
    return "the database has version " + std::to_string(version) + ", this program reads those up to " +
           std::to_string(schema_version);
  }
  const std::string damage = damage_in(database, "quick_check");
  return damage.empty() ? "" : "the database is damaged (" + damage + "); restore a backup";
}

std::string damage_in(SQLite::Database& database, const std::string& check) {
  std::string verdict = database.execAndGet("PRAGMA " + check + "(1)").getString();
  std::ranges::replace(verdict, '\n', ' ');
  return verdict == "ok" ? "" : verdict;
}

}  // namespace dini::store
