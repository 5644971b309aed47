#include "server/request_head.h"

#include <catch2/catch.hpp>
#include <random>

#include "server/addresses.h"

using namespace dini;
using server::check_unfinished_head;
using server::decoded_query;
using server::is_loopback;
using server::parse_head;
using server::Settings;

namespace {

std::string code_of(const std::string& head) {
  const auto parsed = parse_head(head, Settings());
  return parsed ? "" : parsed.problems().front().code;
}

std::string post_head(const std::string& headers) { return "POST / HTTP/1.1\r\nHost: a\r\n" + headers + "\r\n"; }
std::string get_head(const std::string& headers) { return "GET / HTTP/1.1\r\nHost: a\r\n" + headers + "\r\n"; }

}  // namespace

TEST_CASE("A good head is taken apart") {
  const auto head = parse_head(
      "POST /a%20b/c?d=e?f HTTP/1.1\r\nHost: a\r\nContent-Length: 12\r\nX-One:  two\t\r\nConnection: close\r\n\r\n",
      Settings());
  REQUIRE(head);
  CHECK(head->request.method == "POST");
  CHECK(head->target == "/a%20b/c?d=e?f");
  CHECK(head->request.path == "/a b/c");
  CHECK(head->request.query == "d=e?f");
  CHECK(head->content_length == 12);
  CHECK(head->close);
  CHECK_FALSE(head->is_old);
  CHECK(head->request.headers == server::Request::Fields{{"Host", "a"}, {"X-One", "two"}});
  CHECK(head->request.header("x-ONE") == "two");
  CHECK(head->request.header("missing").empty());
}

TEST_CASE("A target with a host is that host's, whatever the header says") {
  const auto head = parse_head("GET HTTP://b.example:81?x=1 HTTP/1.1\r\nHost: a\r\n\r\n", Settings());
  REQUIRE(head);
  CHECK(head->request.path == "/");
  CHECK(head->request.query == "x=1");
  CHECK(head->request.header("Host") == "b.example:81");
}

TEST_CASE("Connections of HTTP/1.0 end with their answer and need no host") {
  const auto head = parse_head("GET / HTTP/1.0\r\n\r\n", Settings());
  REQUIRE(head);
  CHECK(head->is_old);
  CHECK(head->close);
}

TEST_CASE("Addresses and queries are decoded, names of this machine are known") {
  CHECK(
      decoded_query("a=1&b=x%20y+z&c&=d&&e=%3D%26") ==
      std::vector<std::pair<std::string, std::string>>{{"a", "1"}, {"b", "x y z"}, {"c", ""}, {"", "d"}, {"e", "=&"}});
  for (const auto* host : {"localhost", "LocalHost", "127.0.0.1", "127.1.2.3", "::1", "[::1]"})
    CHECK(is_loopback(host));
  for (const auto* host : {"", "127.evil.example", "127.0.0.1.evil.example", "128.0.0.1", "0.0.0.0", "::2", "[::1",
                           "localhost.example", "0127.0.0.1", "127.0.0.1:80"}) {
    CAPTURE(host);
    CHECK_FALSE(is_loopback(host));
  }
}

TEST_CASE("Heads that cannot be trusted are refused, each for its reason") {
  const std::vector<std::pair<std::string, std::string>> table = {
      {"GET /\r\n\r\n", "bad-request"},
      {"GET / HTTP/2.0\r\nHost: a\r\n\r\n", "http-version"},
      {"GET / HTTP/1.1x\r\nHost: a\r\n\r\n", "http-version"},
      {"BREW / HTTP/1.1\r\nHost: a\r\n\r\n", "method-not-allowed"},
      {"G(T / HTTP/1.1\r\nHost: a\r\n\r\n", "bad-request"},
      {"GET http:/b HTTP/1.1\r\nHost: a\r\n\r\n", "bad-request"},
      {"GET ftp://b/ HTTP/1.1\r\nHost: a\r\n\r\n", "bad-request"},
      {"GET /%00 HTTP/1.1\r\nHost: a\r\n\r\n", "bad-request"},
      {"GET /?q=%0d%0A HTTP/1.1\r\nHost: a\r\n\r\n", "bad-request"},
      {"GET /%u000a HTTP/1.1\r\nHost: a\r\n\r\n", "bad-request"},
      {"GET /%4 HTTP/1.1\r\nHost: a\r\n\r\n", "bad-request"},
      {"GET /a b HTTP/1.1\r\nHost: a\r\n\r\n", "bad-request"},
      {"GET / HTTP/1.1\r\n\r\n", "bad-request"},
      {get_head("Host: b\r\n"), "bad-request"},
      {get_head("Folded: a\r\n b\r\n"), "bad-request"},
      {get_head("Space : a\r\n"), "bad-request"},
      {get_head("NoColon\r\n"), "bad-request"},
      {get_head("Bare: a\nb: c\r\n"), "bad-request"},
      {get_head("X: a%0d%0aSet-Cookie: b\r\n"), "bad-request"},
      {get_head("X: %00\r\n"), "bad-request"},
      {get_head("Content-Length: 3\r\n"), "bad-request"},
      {get_head("Content-Length: 0\r\n"), ""},
      {get_head("Transfer-Encoding: chunked\r\n"), "bad-request"},
      {get_head("Range: bytes=0-1\r\n"), ""},
      {get_head("Expect: wonders\r\n"), "expectation-failed"},
      {post_head("Transfer-Encoding: chunked\r\n"), ""},
      {post_head("Transfer-Encoding: Chunked\r\n"), ""},
      {post_head("Transfer-Encoding: chunked\r\nTransfer-Encoding: chunked\r\n"), "bad-request"},
      {post_head("Transfer-Encoding: chunked, chunked\r\n"), "bad-request"},
      {post_head("Transfer-Encoding: gzip, chunked\r\n"), "bad-request"},
      {post_head("Transfer-Encoding: xchunked\r\n"), "bad-request"},
      {post_head("Transfer-Encoding:\r\n"), "bad-request"},
      {post_head("Transfer-Encoding: chunked\r\nContent-Length: 3\r\n"), "bad-request"},
      {post_head("Content-Length: 0\r\nTransfer-Encoding: chunked\r\n"), "bad-request"},
      {post_head("Content-Length: 3\r\nTransfer-Encoding: identity\r\n"), "bad-request"},
      {"POST / HTTP/1.0\r\nHost: a\r\nTransfer-Encoding: chunked\r\n\r\n", "bad-request"},
      {post_head("Content-Length: 3\r\nContent-Length: 3\r\n"), "bad-request"},
      {post_head("Content-Length: 3, 3\r\n"), "bad-request"},
      {post_head("Content-Length: -1\r\n"), "bad-request"},
      {post_head("Content-Length: +1\r\n"), "bad-request"},
      {post_head("Content-Length: abc\r\n"), "bad-request"},
      {post_head("Content-Length: 0x10\r\n"), "bad-request"},
      {post_head("Content-Length:\r\n"), "bad-request"},
      {post_head("Content-Length: 99999999999999999999999\r\n"), "bad-request"},
      {post_head("Content-Length: 1000\r\n"), ""},
      {get_head("Cookie: a=%00%0d%0a\r\n"), ""},
      {post_head("Content-Length: 3\r\nContent-Encoding: gzip\r\n"), "unsupported-media-type"},
      {post_head("Content-Length: 3\r\nContent-Encoding: br\r\n"), "unsupported-media-type"},
  };
  for (const auto& [head, code] : table) {
    CAPTURE(head);
    CHECK(code_of(head) == code);
  }
}

TEST_CASE("Lines and headers have limits") {
  CHECK(code_of("GET /" + std::string(9000, 'a') + " HTTP/1.1\r\nHost: a\r\n\r\n") == "uri-too-long");
  CHECK(code_of(get_head("X: " + std::string(9000, 'a') + "\r\n")) == "headers-too-large");
  std::string many;
  for (int i = 0; i < 100; ++i) many += "X: y\r\n";
  CHECK(code_of(get_head(many)) == "headers-too-large");
}

TEST_CASE("Heads that cannot become good are refused before they end") {
  const Settings settings;
  CHECK_FALSE(check_unfinished_head("GET /health", settings));
  CHECK_FALSE(check_unfinished_head("GET / HTTP/1.1\r", settings));
  CHECK(check_unfinished_head(std::string("\x16\x03\x01\x02\x00", 5), settings)->code == "bad-request");
  CHECK(check_unfinished_head("GET /" + std::string(9000, 'a'), settings)->code == "uri-too-long");
  const std::string long_header = "GET / HTTP/1.1\r\nX: " + std::string(9000, 'a');
  CHECK(check_unfinished_head(long_header, settings)->code == "headers-too-large");
}

TEST_CASE("No bytes upset the reader of heads") {
  std::mt19937 random(7);
  const std::string good = post_head("Content-Length: 3\r\nAccept: */*;q=0.5\r\nX: a%20b\r\n");
  for (int i = 0; i < 20'000; ++i) {
    std::string head = good;
    for (int change = 0; change < 3; ++change) head[random() % head.size()] = static_cast<char>(random() % 256);
    const auto parsed = parse_head(head, Settings());
    if (parsed) CHECK(parsed->request.path.find('\0') == std::string::npos);
    static_cast<void>(check_unfinished_head(head, Settings()));
  }
}
