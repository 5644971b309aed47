#pragma once

#include <SQLiteCpp/Database.h>
#include <string>

namespace dini::store {

/// Makes the tables in an empty database.
void make_tables(SQLite::Database& database);

/// Brings a database of an earlier version to the present one, as a whole or not at all.
void upgrade(SQLite::Database& database);

/// What is wrong with a database as a whole, in words; empty when nothing is: it is another program's, or of a later
/// version, or its pages are damaged.
std::string fault_in(SQLite::Database& database);

/// What one of SQLite's checks, `quick_check` or `integrity_check`, finds first, in one line; empty when nothing.
std::string damage_in(SQLite::Database& database, const std::string& check);

}  // namespace dini::store
