#pragma once

#include <string>
#include <string_view>

#include "server/reply.h"

namespace dini::server {

/// How an answer is put on the wire, besides what it says.
struct AnswerForm {
  bool head_only = false;  ///< to a HEAD request: with the length of the body, without it
  bool close = false;      ///< the last answer of its connection
  bool chunked = false;    ///< a stream whose end the peer is told; else the connection ends with it
};

/// The status line and all headers, with those that every answer carries: the one place where answers are written.
std::string answer_head(const Reply& reply, const Exchange& exchange, const AnswerForm& form);

/// A piece of a chunked body, and its end after the last one.
std::string chunk_of(std::string_view bytes, bool last);

/// A whole answer of its own, for when there is no memory left to make one: 503, closing the connection.
std::string_view last_resort();

/// What every answer begins with, whatever follows.
inline constexpr std::string_view answer_beginning = "HTTP/1.1 ";

}  // namespace dini::server
