#pragma once

// What the classes over the database have in common: values to and from SQL, and the time.

#include <SQLiteCpp/Statement.h>
#include <algorithm>
#include <chrono>
#include <cstdint>
#include <string>
#include <string_view>

#include "graph/digest.h"

namespace dini::store {

inline void bind_text(SQLite::Statement& statement, int place, std::string_view text) {
  statement.bind(place, std::string(text));
}

inline void bind_digest(SQLite::Statement& statement, int place, const Digest& digest) {
  statement.bind(place, digest.data(), static_cast<int>(digest.size()));
}

inline void bind_bytes(SQLite::Statement& statement, int place, std::string_view bytes) {
  statement.bind(place, bytes.data(), static_cast<int>(bytes.size()));
}

/// Zeros where a blob is too short to be one.
inline Digest digest_in(const SQLite::Column& column) {
  Digest digest{};
  const auto* bytes = static_cast<const std::uint8_t*>(column.getBlob());
  std::copy_n(bytes, std::min<std::size_t>(digest.size(), static_cast<std::size_t>(column.getBytes())), digest.begin());
  return digest;
}

/// Since 1970, UTC.
inline std::int64_t now_milliseconds() {
  const auto now = std::chrono::system_clock::now().time_since_epoch();
  return std::chrono::duration_cast<std::chrono::milliseconds>(now).count();
}

}  // namespace dini::store
