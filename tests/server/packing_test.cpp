#include "server/packing.h"

#include <zlib.h>

#include "server/negotiation.h"
#include "tests/server/fixture.h"

using namespace dini;
using namespace dini::support;

namespace {

std::string unpacked(const std::string& file) {
  z_stream stream{};
  REQUIRE(::inflateInit2(&stream, 15 + 16) == Z_OK);
  std::string text(32 * 1024 * 1024, '\0');
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(file.data()));
  stream.avail_in = static_cast<uInt>(file.size());
  stream.next_out = reinterpret_cast<Bytef*>(text.data());
  stream.avail_out = static_cast<uInt>(text.size());
  CHECK(::inflate(&stream, Z_FINISH) == Z_STREAM_END);
  CHECK(stream.avail_in == 0);
  text.resize(stream.total_out);
  ::inflateEnd(&stream);
  return text;
}

}  // namespace

TEST_CASE("Clients say whether they take gzip") {
  const std::vector<std::pair<std::string, bool>> table = {
      {"", false},         {"gzip", true},           {"br, GZip", true},         {"br", false},
      {"gzip;q=0", false}, {"gzip;q=0.5", true},     {"gzip; q=0.0", false},     {"*", true},
      {"*;q=0", false},    {"*, gzip;q=0", false},   {"gzip, *;q=0", true},      {"identity;q=1, *;q=0", false},
      {"xgzip", false},    {"gzip;q=wonder", false}, {"deflate, gzip;q=1", true}};
  for (const auto& [header, takes] : table) {
    CAPTURE(header);
    CHECK(server::accepts_coding(header, "gzip") == takes);
  }
}

TEST_CASE("JSON of some size is packed for those who take it, under the same tag") {
  const Running server;
  const auto plain = get(server.port(), "/schema/graph-1.json");
  const auto packed = get(server.port(), "/schema/graph-1.json", "Accept-Encoding: br, gzip\r\n");
  REQUIRE(plain);
  REQUIRE(packed);
  CHECK(plain->header("content-encoding").empty());
  CHECK(plain->header("vary") == "Accept-Encoding");
  CHECK(packed->header("content-encoding") == "gzip");
  CHECK(packed->header("vary") == "Accept-Encoding");
  CHECK(packed->header("content-length") == std::to_string(packed->body.size()));
  CHECK(packed->body.size() < plain->body.size() / 2);
  CHECK(unpacked(packed->body) == plain->body);
  CHECK(packed->header("etag") == plain->header("etag"));
  CHECK(get(server.port(), "/schema/graph-1.json",
            "Accept-Encoding: gzip\r\nIf-None-Match: " + packed->header("etag") + "\r\n")
            ->status == 304);
  Client client(server.port());
  client.send("HEAD /schema/graph-1.json HTTP/1.1\r\nHost: localhost\r\nAccept-Encoding: gzip\r\n\r\n");
  const auto head = client.receive(true);
  CHECK(head->header("content-encoding") == "gzip");
  CHECK(head->header("content-length") == packed->header("content-length"));
}

TEST_CASE("Problems and reports of some size are packed, files and small answers are not") {
  const Running server;
  const std::string takes = "Accept-Encoding: gzip\r\n";
  CHECK(get(server.port(), "/healthz", takes)->header("content-encoding").empty());
  const auto model = post(server.port(), "/v1/evaluate", toy_body({{"bytes", 3000}}), takes);
  CHECK(model->status == 200);
  CHECK(model->header("content-encoding").empty());
  std::string unknown = "{";
  for (int i = 0; i < 60; ++i) unknown += (i > 0 ? ",\"x" : "\"x") + std::to_string(i) + "\":0";
  const auto problem = post(server.port(), "/v1/evaluate", unknown + "}", takes);
  CHECK(problem->status == 422);
  CHECK(problem->header("content-encoding") == "gzip");
  CHECK(Json::parse(unpacked(problem->body))["status"] == 422);
}
