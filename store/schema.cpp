#include "store/schema.h"

#include <algorithm>

namespace dini::store {
namespace {

constexpr int application_id = 0x44696e69;  // "Dini"
constexpr int schema_version = 1;

/// Every version of every graph for ever, and which of them is the current one. A graph that is deleted keeps its
/// versions. `digest` is of the document's bytes, `hash` of the graph that it means.
constexpr const char* tables = R"(
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
)";

}  // namespace

void make_tables(SQLite::Database& database) {
  database.exec("PRAGMA application_id = " + std::to_string(application_id));
  database.exec("PRAGMA user_version = " + std::to_string(schema_version));
  database.exec(tables);
}

std::string fault_in(SQLite::Database& database) {
  if (database.execAndGet("PRAGMA application_id").getInt() != application_id) return "this is no database of Dini";
  const int version = database.execAndGet("PRAGMA user_version").getInt();
  if (version != schema_version) {
    return "the database has version " + std::to_string(version) + ", this program reads version " +
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
