#pragma once

// The strict reader of a request's head: what decides where a request ends is read in one way only, or refused.

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "graph/problem.h"
#include "server/request.h"
#include "server/settings.h"

namespace dini::server {

/// A well-formed head.
struct RequestHead {
  Request request;      ///< without its body
  std::string target;   ///< as sent: for the log
  bool is_old = false;  ///< HTTP/1.0
  std::size_t content_length = 0;
  bool is_chunked = false;    ///< the body has no length beforehand
  bool lacks_length = false;  ///< of a method that usually has a body: there is none, or it was forgotten
  bool expects_continue = false;
  bool close = false;  ///< the client wants the connection closed after the answer
};

/// Reads a whole head including its empty line. Problems carry the code of the HTTP status to answer with.
Result<RequestHead> parse_head(std::string_view bytes, const Settings& settings);

/// Looks at the first bytes of a head that is not complete yet and says early when it cannot become a good one.
std::optional<Problem> check_unfinished_head(std::string_view bytes, const Settings& settings);

}  // namespace dini::server
