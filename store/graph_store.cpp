#include "store/graph_store.h"

#include "store/asset_references.h"
#include "store/database.h"
#include "store/schema.h"
#include "store/statements.h"

namespace dini::store {
namespace {

/// The columns that `version_in` takes.
const std::string columns = "v.id, v.version, v.created, v.hash, v.digest, v.bytes, v.title";
const std::string current_of = "FROM graphs g JOIN versions v ON v.id = g.id AND v.version = g.version ";

GraphVersion version_in(SQLite::Statement& row) {
  return {.id = row.getColumn(0).getString(),
          .version = row.getColumn(1).getInt64(),
          .created = row.getColumn(2).getInt64(),
          .hash = digest_in(row.getColumn(3)),
          .digest = digest_in(row.getColumn(4)),
          .bytes = row.getColumn(5).getInt64(),
          .title = row.getColumn(6).getString()};
}

/// Columns of the current version, or of one by its number.
SQLite::Statement selected(SQLite::Database& database, const std::string& wanted, std::string_view id,
                           std::optional<std::int64_t> version) {
  SQLite::Statement select(database, "SELECT " + wanted + " " +
                                         (version ? "FROM versions v WHERE v.id = ? AND v.version = ?"
                                                  : current_of + "WHERE g.id = ? AND g.deleted IS NULL"));
  bind_text(select, 1, id);
  if (version) select.bind(2, *version);
  return select;
}

std::optional<GraphVersion> current_version(SQLite::Database& database, std::string_view id) {
  SQLite::Statement select = selected(database, columns, id, std::nullopt);
  if (!select.executeStep()) return std::nullopt;
  return version_in(select);
}

std::int64_t next_number(SQLite::Database& database, std::string_view id) {
  SQLite::Statement select(database, "SELECT coalesce(max(version), 0) + 1 FROM versions WHERE id = ?");
  bind_text(select, 1, id);
  select.executeStep();
  return select.getColumn(0).getInt64();
}

void insert_version(SQLite::Database& database, const GraphVersion& version, std::string_view document) {
  SQLite::Statement insert(database,
                           "INSERT INTO versions (id, version, created, hash, digest, bytes, title, document) "
                           "VALUES (?, ?, ?, ?, ?, ?, ?, ?)");
  bind_text(insert, 1, version.id);
  insert.bind(2, version.version);
  insert.bind(3, version.created);
  bind_digest(insert, 4, version.hash);
  bind_digest(insert, 5, version.digest);
  insert.bind(6, version.bytes);
  bind_text(insert, 7, version.title);
  insert.bind(8, document.data(), static_cast<int>(document.size()));
  insert.exec();
  SQLite::Statement point(database,
                          "INSERT INTO graphs (id, version, deleted) VALUES (?, ?, NULL) "
                          "ON CONFLICT (id) DO UPDATE SET version = excluded.version, deleted = NULL");
  bind_text(point, 1, version.id);
  point.bind(2, version.version);
  point.exec();
  insert_references(database, version.id, version.version, document);
}

/// A text that LIKE takes for itself, with a backslash as its escape.
std::string containing(std::string_view text) {
  std::string pattern = "%";
  for (const char c : text) {
    if (c == '%' || c == '_' || c == '\\') pattern += '\\';
    pattern += c;
  }
  return pattern + "%";
}

}  // namespace

GraphStore::GraphStore(std::shared_ptr<Database> database) : database_(std::move(database)) {}
GraphStore::~GraphStore() = default;

Result<std::unique_ptr<GraphStore>> GraphStore::open(const std::filesystem::path& folder, std::size_t most_bytes) {
  auto database = Database::open(folder, most_bytes);
  if (!database) return database.problems();
  return std::unique_ptr<GraphStore>(new GraphStore(*std::move(database)));
}

std::unique_ptr<GraphStore> GraphStore::in_memory(std::size_t most_bytes) {
  return std::unique_ptr<GraphStore>(new GraphStore(Database::in_memory(most_bytes)));
}

std::unique_ptr<GraphStore> GraphStore::refusing(const std::string& detail) {
  return std::unique_ptr<GraphStore>(new GraphStore(Database::refusing(detail)));
}

Result<std::unique_ptr<GraphStore>> GraphStore::open_to_read(const std::filesystem::path& folder) {
  auto database = Database::open_to_read(folder);
  if (!database) return database.problems();
  return std::unique_ptr<GraphStore>(new GraphStore(*std::move(database)));
}

Result<Written> GraphStore::put(const NewGraph& graph, const Condition& condition) {
  const Digest digest = sha256(graph.document);
  return database_->write([&](SQLite::Database& database) -> Result<Written> {
    std::optional<GraphVersion> current = current_version(database, graph.id);
    if (current && current->digest == digest) return Written{WriteOutcome::unchanged, current};
    if (!condition(current ? &*current : nullptr)) return Written{WriteOutcome::refused, current};
    const GraphVersion version{.id = graph.id,
                               .version = next_number(database, graph.id),
                               .created = now_milliseconds(),
                               .hash = graph.hash,
                               .digest = digest,
                               .bytes = static_cast<std::int64_t>(graph.document.size()),
                               .title = graph.title};
    insert_version(database, version, graph.document);
    return Written{current ? WriteOutcome::replaced : WriteOutcome::created, version};
  });
}

Result<Written> GraphStore::remove(std::string_view id, const Condition& condition) {
  return database_->write([&](SQLite::Database& database) -> Result<Written> {
    std::optional<GraphVersion> current = current_version(database, id);
    if (!current) return Written{WriteOutcome::unchanged, std::nullopt};
    if (!condition(&*current)) return Written{WriteOutcome::refused, current};
    SQLite::Statement update(database, "UPDATE graphs SET deleted = ? WHERE id = ?");
    update.bind(1, now_milliseconds());
    bind_text(update, 2, id);
    update.exec();
    return Written{WriteOutcome::deleted, std::nullopt};
  });
}

Result<std::optional<StoredGraph>> GraphStore::find(std::string_view id, std::optional<std::int64_t> version) const {
  return database_->read([&](SQLite::Database& database) -> Result<std::optional<StoredGraph>> {
    SQLite::Statement select = selected(database, columns + ", v.document", id, version);
    if (!select.executeStep()) return std::optional<StoredGraph>();
    StoredGraph found{version_in(select), nullptr};
    found.document = share(select.getColumn(7).getString());
    return std::optional(std::move(found));
  });
}

Result<std::optional<GraphVersion>> GraphStore::look_up(std::string_view id,
                                                        std::optional<std::int64_t> version) const {
  return database_->read([&](SQLite::Database& database) -> Result<std::optional<GraphVersion>> {
    SQLite::Statement select = selected(database, columns, id, version);
    return select.executeStep() ? std::optional(version_in(select)) : std::nullopt;
  });
}

Result<GraphPage> GraphStore::list(std::string_view after, std::string_view query, std::size_t limit) const {
  return database_->read([&](SQLite::Database& database) -> Result<GraphPage> {
    SQLite::Statement select(
        database, "SELECT " + columns + " " + current_of +
                      "WHERE g.deleted IS NULL AND g.id > ?1 AND (v.id LIKE ?2 ESCAPE '\\' OR v.title LIKE ?2 "
                      "ESCAPE '\\') ORDER BY g.id LIMIT ?3");
    bind_text(select, 1, after);
    bind_text(select, 2, containing(query));
    select.bind(3, static_cast<std::int64_t>(limit) + 1);
    GraphPage page;
    while (select.executeStep()) page.graphs.push_back(version_in(select));
    page.more = page.graphs.size() > limit;
    if (page.more) page.graphs.pop_back();
    return page;
  });
}

Result<std::vector<GraphVersion>> GraphStore::versions(std::string_view id) const {
  return database_->read([&](SQLite::Database& database) -> Result<std::vector<GraphVersion>> {
    SQLite::Statement select(database, "SELECT " + columns + " FROM versions v WHERE v.id = ? ORDER BY v.version DESC");
    bind_text(select, 1, id);
    std::vector<GraphVersion> versions;
    while (select.executeStep()) versions.push_back(version_in(select));
    return versions;
  });
}

std::optional<std::filesystem::path> GraphStore::folder() const { return database_->folder(); }

Result<bool> GraphStore::names(const Digest& asset) const {
  return database_->read([&](SQLite::Database& database) -> Result<bool> { return is_referenced(database, asset); });
}

std::optional<Problem> GraphStore::check_writing() {
  if (!database_->has_failed()) return std::nullopt;
  const auto tried = database_->write([](SQLite::Database& database) -> Result<bool> {
    database.exec("PRAGMA user_version = " + database.execAndGet("PRAGMA user_version").getString());
    return true;
  });
  if (tried) return std::nullopt;
  return tried.problems().front();
}

Result<std::size_t> GraphStore::purge() {
  auto purged = database_->write([](SQLite::Database& database) -> Result<std::size_t> {
    database.exec("CREATE TEMP TABLE gone AS SELECT id FROM graphs WHERE deleted IS NOT NULL");
    database.exec("DELETE FROM graphs WHERE id IN (SELECT id FROM gone)");
    database.exec("DELETE FROM versions WHERE id IN (SELECT id FROM gone)");
    database.exec("DELETE FROM asset_references WHERE id IN (SELECT id FROM gone)");
    const auto count = static_cast<std::size_t>(database.execAndGet("SELECT count(*) FROM gone").getInt64());
    database.exec("DROP TABLE gone");
    return count;
  });
  if (!purged) return purged;
  const Result<bool> vacuumed = database_->maintain([](SQLite::Database& database) -> Result<bool> {
    database.exec("VACUUM");
    return true;
  });
  if (!vacuumed) return vacuumed.problems();
  return purged;
}

Result<bool> GraphStore::back_up(const std::filesystem::path& file) const {
  return database_->maintain([&](SQLite::Database& database) -> Result<bool> {
    SQLite::Statement vacuum(database, "VACUUM INTO ?");
    bind_text(vacuum, 1, file.string());
    vacuum.exec();
    return true;
  });
}

Result<std::string> GraphStore::fault() const {
  return database_->read([](SQLite::Database& database) -> Result<std::string> {
    if (std::string damage = damage_in(database, "integrity_check"); !damage.empty()) return damage;
    SQLite::Statement select(database, "SELECT id, version, digest, document FROM versions");
    while (select.executeStep()) {
      if (digest_in(select.getColumn(2)) == sha256(select.getColumn(3).getString())) continue;
      return "version " + std::to_string(select.getColumn(1).getInt64()) + " of '" + select.getColumn(0).getString() +
             "' is not what was written";
    }
    return std::string();
  });
}

}  // namespace dini::store
