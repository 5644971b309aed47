#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "server/reply.h"

namespace dini::server {

/// What the log tells of a request, besides what is known of it before it is answered.
struct Access {
  std::string method = "-";
  std::string path = "-";  ///< with its query
  int status = 0;
  std::size_t bytes = 0;  ///< of the answer, those that were sent
  AnswerNotes notes = {};
};

/// The name of the logger that is given lines of requests in JSON: members of an object, without its braces, for
/// whoever writes the time before them.
inline constexpr const char* request_logger = "request";

/// The line of a request in the form for people. What comes from outside has its controls escaped.
std::string request_text(const Access& access, const Exchange& exchange, std::string_view route);
/// The members of the line of a request in JSON.
std::string request_members(const Access& access, const Exchange& exchange, std::string_view route);

}  // namespace dini::server
