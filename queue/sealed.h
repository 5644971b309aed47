#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace dini::queue {

/// Bytes with what they have to be, as they lie in Redis: their length, their SHA-256, their media type and the version
/// of the engine that made them.
std::string sealed(std::string_view media_type, std::string_view engine, std::string_view bytes);

/// What was sealed: a view into the argument. Nothing when it is not exactly that: a flipped byte, a piece, another
/// type, another engine.
std::optional<std::string_view> unsealed(std::string_view value, std::string_view media_type, std::string_view engine);

}  // namespace dini::queue
