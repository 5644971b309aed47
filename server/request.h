#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace dini::server {

/// A complete request.
struct Request {
  using Fields = std::vector<std::pair<std::string, std::string>>;

  std::string method;
  std::string path;    ///< decoded, without the query and what everything is served below
  std::string scheme;  ///< that the client used, "http" or "https", if a trusted proxy told; else empty
  std::string query;   ///< as sent, without its question mark
  Fields headers;      ///< in the order sent, without those that frame the request
  std::string body;

  /// The first header of that name, whatever its case; empty when there is none.
  std::string_view header(std::string_view name) const;
  bool has_header(std::string_view name) const;
};

}  // namespace dini::server
