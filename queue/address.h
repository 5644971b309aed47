#pragma once

#include <string>

#include "graph/problem.h"

namespace dini::queue {

/// Where a Redis is, and as whom to speak to it.
struct Address {
  std::string host = "127.0.0.1";
  int port = 6379;
  std::string user = {};      ///< empty: the usual one
  std::string password = {};  ///< empty: none
  int database = 0;

  /// As people may read it: without the password.
  std::string text() const { return "redis://" + host + ":" + std::to_string(port) + "/" + std::to_string(database); }
};

/// Reads `redis://[[user]:password@]host[:port][/database]`; a host of IPv6 stands in brackets. The problem (`usage`)
/// never repeats the password.
Result<Address> read_address(const std::string& text);

}  // namespace dini::queue
