#pragma once

#include <chrono>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "graph/problem.h"

namespace dini::support {

/// An HTTP answer taken apart. Header names are in lower case.
struct Answer {
  int status = 0;
  std::map<std::string, std::string> headers;
  std::string body;

  std::string header(const std::string& name) const {
    const auto found = headers.find(name);
    return found == headers.end() ? "" : found->second;
  }
  Json json() const { return Json::parse(body, nullptr, false); }
  /// The lines of a body of NDJSON.
  std::vector<Json> lines() const;
  /// The code of the first error of a problem; empty when the body is none.
  std::string code() const;
};

/// A plain socket to 127.0.0.1: sends exactly the bytes it is given.
class Client {
 public:
  explicit Client(int port);
  ~Client();
  Client(const Client&) = delete;
  Client& operator=(const Client&) = delete;

  /// False when the server has closed.
  bool send(std::string_view bytes);

  /// Sends the piece again and again until an answer (or the end) can be read, or `limit` bytes are sent.
  std::size_t flood(std::string_view piece, std::size_t limit);

  /// The next answer; nothing when the connection ends without one or nothing comes for fifteen seconds.
  std::optional<Answer> receive(bool head_only = false);

  /// True when the server closes the connection (without another byte) within fifteen seconds.
  bool closed();

  /// Everything until the server closes.
  std::string rest();

  void close();

  /// Sends no more, but goes on reading.
  void finish_sending() const;

 private:
  bool readable(std::chrono::milliseconds wait) const;
  bool read_more();
  /// A chunked body; false when it is cut off.
  bool receive_chunks(std::string& body);

  int descriptor_ = -1;
  std::string buffer_;
};

/// One request on a connection of its own.
std::optional<Answer> ask(int port, std::string_view bytes);
std::optional<Answer> get(int port, const std::string& path, const std::string& headers = "");
std::optional<Answer> head(int port, const std::string& path);
std::optional<Answer> post(int port, const std::string& path, const std::string& body, const std::string& headers = "");

/// What a raw request says of the host that it asks.
inline const std::string host_line = "Host: localhost\r\n";

/// The bytes of a POST of JSON.
std::string post_text(const std::string& path, const std::string& body, const std::string& headers = "");

/// A body for /v1/evaluate with these inputs for the toy's one node.
std::string toy_body(const Json& inputs);

}  // namespace dini::support
