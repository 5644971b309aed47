#pragma once

#include <SQLiteCpp/Database.h>
#include <string>

namespace dini::store {

/// Makes the tables in an empty database.
void make_tables(SQLite::Database& database);

/// What is wrong with a database as a whole, in words; empty when nothing is: it is another program's, or of a later
/// version, or its pages are damaged.
std::string fault_in(SQLite::Database& database);

}  // namespace dini::store
