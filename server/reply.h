#pragma once

#include <chrono>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "graph/file.h"
#include "server/body_stream.h"

namespace dini::server {

/// What is told of an answer besides what it says.
struct AnswerNotes {
  std::vector<std::pair<std::string, double>> timings = {};  ///< stage and milliseconds
  std::string graph = {};                                    ///< the hash of the graph, in hexadecimal; empty for none
  std::string_view cache = {};  ///< whether the result was known: "hit" or "miss"; empty where nothing is kept
};

/// An answer before it is put on the wire. Its body is in pieces that may be shared with other answers, none is copied;
/// or it is a stream, made while it is sent.
struct Reply {
  int status = 200;
  std::string type = {};  ///< media type; empty without a body
  std::vector<SharedBytes> body = {};
  std::shared_ptr<BodyReader> stream = {};  ///< instead of `body`
  std::vector<std::pair<std::string, std::string>> headers = {};
  AnswerNotes notes = {};
  std::string framed_by = {};  ///< whose pages may have it in a frame, as `frame-ancestors` says it; empty: none

  std::size_t size() const {
    std::size_t total = 0;
    for (const SharedBytes& piece : body) total += piece->size();
    return total;
  }
};

/// What is known about the request being answered besides its text.
struct Exchange {
  using Clock = std::chrono::steady_clock;

  std::string id;                            ///< names the request in the answer and in the log
  Clock::time_point started = Clock::now();  ///< when its first byte came
  std::string trace = {};                    ///< of `traceparent`, in hexadecimal; empty without one
  std::string span = {};
  std::string client = {};     ///< the address that it came from, as far as that can be told
  std::string_view base = {};  ///< the path that everything is served below
  bool accepts_gzip = false;
  std::string shared_with = {};    ///< the origin whose pages may read the answer, "*" for all; empty for none other
  bool differs_by_origin = false;  ///< pages of another origin may be answered otherwise

  double milliseconds() const { return std::chrono::duration<double, std::milli>(Clock::now() - started).count(); }
};

}  // namespace dini::server
