#include "store/asset_references.h"

#include "store/statements.h"

namespace dini::store {

std::vector<Digest> assets_named_in(std::string_view document) {
  constexpr std::size_t digits = 64;
  std::vector<Digest> named;
  // A quote that ends a text may be taken for one that begins it; what stands between two texts is no hash.
  for (auto quote = document.find('"'); quote != std::string_view::npos; quote = document.find('"', quote + 1)) {
    const std::string_view rest = document.substr(quote + 1);
    if (rest.size() <= digits || rest[digits] != '"') continue;
    if (const auto digest = digest_from_hex(rest.substr(0, digits))) named.push_back(*digest);
  }
  return named;
}

void insert_references(SQLite::Database& database, std::string_view id, std::int64_t version,
                       std::string_view document) {
  SQLite::Statement insert(database, "INSERT OR IGNORE INTO asset_references (sha256, id, version) VALUES (?, ?, ?)");
  for (const Digest& digest : assets_named_in(document)) {
    bind_digest(insert, 1, digest);
    bind_text(insert, 2, id);
    insert.bind(3, version);
    insert.exec();
    insert.reset();
  }
}

bool is_referenced(SQLite::Database& database, const Digest& sha256) {
  SQLite::Statement select(database, "SELECT 1 FROM asset_references WHERE sha256 = ? LIMIT 1");
  bind_digest(select, 1, sha256);
  return select.executeStep();
}

}  // namespace dini::store
