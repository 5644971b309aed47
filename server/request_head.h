#pragma once

// The strict reader of a request's head. cpp-httplib only ever sees a head that this reader has taken apart and put
// together again, so its lenient parser (duplicate lengths, chunked bodies, percent-decoded header values, ranges) is
// out of reach.

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "graph/problem.h"
#include "server/settings.h"

namespace dini::server {

/// A well-formed head whose body, if any, has a known length within the limit.
struct RequestHead {
  std::string method;
  std::string target;
  std::string version;                                       ///< "HTTP/1.1" or "HTTP/1.0"
  std::vector<std::pair<std::string, std::string>> headers;  ///< in the order sent, without those of framing and ranges
  std::size_t content_length = 0;
  bool expects_continue = false;
  bool close = false;  ///< the client wants the connection closed after the answer

  /// The request line for cpp-httplib, without headers: those it would decode, count and obey.
  std::string request_line() const;
};

/// How long the body of a request may be, by its method and target.
using BodyLimit = std::function<std::size_t(std::string_view method, std::string_view target)>;

/// Reads a whole head including its empty line. Problems carry the code of the HTTP status to answer with.
Result<RequestHead> parse_head(std::string_view bytes, const Settings& settings, const BodyLimit& body_limit);

/// Looks at the first bytes of a head that is not complete yet and says early when it cannot become a good one.
std::optional<Problem> check_unfinished_head(std::string_view bytes, const Settings& settings);

}  // namespace dini::server
