#include "tests/server/client.h"

#include <algorithm>
#include <arpa/inet.h>
#include <array>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include "server/text.h"

namespace dini::support {
namespace {

constexpr std::chrono::seconds patience{15};

}  // namespace

std::vector<Json> Answer::lines() const {
  std::vector<Json> lines;
  for (const std::string_view line : server::split(body, '\n')) lines.push_back(Json::parse(line, nullptr, false));
  return lines;
}

std::string Answer::code() const {
  const Json problem = json();
  if (!problem.is_object() || !problem.contains("errors") || problem.at("errors").empty()) return "";
  return problem.at("errors").front().value("code", "");
}

Client::Client(int port) : descriptor_(::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0)) {
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(static_cast<std::uint16_t>(port));
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  if (::connect(descriptor_, reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0) close();
}

Client::~Client() { close(); }

void Client::close() {
  if (descriptor_ >= 0) ::close(descriptor_);
  descriptor_ = -1;
}

void Client::finish_sending() const { ::shutdown(descriptor_, SHUT_WR); }

bool Client::send(std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t count = ::send(descriptor_, bytes.data(), bytes.size(), MSG_NOSIGNAL);
    if (count <= 0) return false;
    bytes.remove_prefix(static_cast<std::size_t>(count));
  }
  return true;
}

std::size_t Client::flood(std::string_view piece, std::size_t limit) {
  std::size_t sent = 0;
  while (sent < limit && !readable(std::chrono::milliseconds(0)) && send(piece)) sent += piece.size();
  return sent;
}

bool Client::readable(std::chrono::milliseconds wait) const {
  if (descriptor_ < 0) return true;  // it was refused: the end is there already
  pollfd state{descriptor_, POLLIN, 0};
  return ::poll(&state, 1, static_cast<int>(wait.count())) > 0;
}

bool Client::read_more() {
  std::array<char, 65536> bytes;
  if (!readable(patience)) return false;
  const ssize_t count = ::recv(descriptor_, bytes.data(), bytes.size(), 0);
  if (count <= 0) return false;
  buffer_.append(bytes.data(), static_cast<std::size_t>(count));
  return true;
}

std::optional<Answer> Client::receive(bool head_only) {
  std::size_t end = 0;
  while ((end = buffer_.find("\r\n\r\n")) == std::string::npos) {
    if (!read_more()) return std::nullopt;
  }
  Answer answer;
  const std::string head = buffer_.substr(0, end);
  buffer_.erase(0, end + 4);
  answer.status = std::stoi(head.substr(9, 3));
  for (const std::string_view line : server::split(head, '\n')) {
    const auto colon = line.find(':');
    if (colon == std::string_view::npos) continue;
    std::string_view value = server::trim(line.substr(colon + 1));
    if (value.ends_with('\r')) value.remove_suffix(1);
    answer.headers[server::to_lower(line.substr(0, colon))] = value;
  }
  if (answer.header("transfer-encoding") == "chunked") {
    if (!head_only && !receive_chunks(answer.body)) return std::nullopt;
    return answer;
  }
  const std::string length = answer.header("content-length");
  const std::size_t size = length.empty() || head_only ? 0 : std::stoul(length);
  while (buffer_.size() < size) {
    if (!read_more()) return std::nullopt;
  }
  answer.body = buffer_.substr(0, size);
  buffer_.erase(0, size);
  return answer;
}

bool Client::receive_chunks(std::string& body) {
  for (;;) {
    std::size_t line = 0;
    while ((line = buffer_.find("\r\n")) == std::string::npos) {
      if (!read_more()) return false;
    }
    const std::size_t size = std::stoul(buffer_.substr(0, line), nullptr, 16);
    buffer_.erase(0, line + 2);
    while (buffer_.size() < size + 2) {
      if (!read_more()) return false;
    }
    body.append(buffer_, 0, size);
    buffer_.erase(0, size + 2);
    if (size == 0) return true;
  }
}

std::string Client::rest() {
  while (read_more()) continue;
  return std::exchange(buffer_, {});
}

bool Client::closed() {
  if (!buffer_.empty() || !readable(patience)) return false;
  char byte = 0;
  return ::recv(descriptor_, &byte, 1, 0) <= 0;
}

std::optional<Answer> ask(int port, std::string_view bytes) {
  Client client(port);
  client.send(bytes);
  return client.receive();
}

std::optional<Answer> get(int port, const std::string& path, const std::string& headers) {
  return ask(port, "GET " + path + " HTTP/1.1\r\nHost: localhost\r\n" + headers + "\r\n");
}

std::optional<Answer> head(int port, const std::string& path) {
  Client client(port);
  client.send("HEAD " + path + " HTTP/1.1\r\nHost: localhost\r\n\r\n");
  return client.receive(true);
}

std::string post_text(const std::string& path, const std::string& body, const std::string& headers) {
  return "POST " + path + " HTTP/1.1\r\nHost: localhost\r\nContent-Type: application/json\r\nContent-Length: " +
         std::to_string(body.size()) + "\r\n" + headers + "\r\n" + body;
}

std::optional<Answer> post(int port, const std::string& path, const std::string& body, const std::string& headers) {
  return ask(port, post_text(path, body, headers));
}

std::string toy_body(const Json& inputs) {
  const Json graph = {{"format", 1},
                      {"nodes", {{"out", {{"type", "toy"}, {"inputs", inputs.is_null() ? Json::object() : inputs}}}}}};
  return Json{{"graph", graph}}.dump();
}

}  // namespace dini::support
