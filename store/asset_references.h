#pragma once

#include <SQLiteCpp/Database.h>
#include <cstdint>
#include <string_view>
#include <vector>

#include "graph/digest.h"

namespace dini::store {

/// The files that a document names: its texts that are 64 hexadecimal digits. Some may mean something else, which does
/// no harm: a file that is named is kept.
std::vector<Digest> assets_named_in(std::string_view document);

/// Notes which files a version of a graph names.
void insert_references(SQLite::Database& database, std::string_view id, std::int64_t version,
                       std::string_view document);

/// Whether some version of a graph names a file.
bool is_referenced(SQLite::Database& database, const Digest& sha256);

}  // namespace dini::store
