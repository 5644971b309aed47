#pragma once

#include <chrono>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace dini::server {

/// An answer before it is put on the wire.
struct Reply {
  int status = 200;
  std::string type = {};  ///< media type; empty without a body
  std::string body = {};
  std::vector<std::pair<std::string, std::string>> headers = {};
};

/// What is known about the request being answered besides its text.
struct Exchange {
  using Clock = std::chrono::steady_clock;

  int socket = -1;
  std::string id;  ///< names the request in the answer and in the log
  Clock::time_point started = Clock::now();
  bool accepts_gzip = false;
  int status = 0;                                       ///< of the answer, once there is one
  std::vector<std::pair<std::string, double>> timings;  ///< name and milliseconds, for Server-Timing

  double milliseconds() const { return std::chrono::duration<double, std::milli>(Clock::now() - started).count(); }
};

}  // namespace dini::server
