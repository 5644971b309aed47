#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "graph/problem.h"

namespace dini::server {

/// The offer that an `Accept` header likes best, the first of several; nothing when it accepts none of them. An empty
/// header accepts everything.
std::optional<std::string_view> choose_type(std::string_view accept, std::span<const std::string_view> offers);

/// The same, or the problem `not-acceptable`, which lists the offers.
Result<std::string_view> accepted_type(std::string_view accept, std::span<const std::string_view> offers);

/// Whether an `Accept-Encoding` header takes a coding (RFC 9110, 12.5.3); an empty one takes none.
bool accepts_coding(std::string_view accept_encoding, std::string_view coding);

/// True when an `If-None-Match` header names the tag or is `*`. Weak tags compare like strong ones (RFC 9110, 13.1.2):
/// a proxy that compresses the answer weakens its tag.
bool names_tag(std::string_view if_none_match, std::string_view tag);

}  // namespace dini::server
