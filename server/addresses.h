#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace dini::server {

/// A path with its percent-encoded bytes decoded.
std::string decoded_path(std::string_view path);

/// The names and values of a query ("a=1&b=2"), decoded, in the order sent; a plus sign is a space.
std::vector<std::pair<std::string, std::string>> decoded_query(std::string_view query);

/// The name or address of a Host header or an authority, without its port: "localhost:80" is "localhost", "[::1]:80" is
/// "[::1]".
std::string_view without_port(std::string_view authority);

/// True for names and addresses that no other machine can reach: localhost, 127.0.0.0/8 and ::1, the latter in brackets
/// or not.
bool is_loopback(std::string_view host);

}  // namespace dini::server
