#include "server/body_stream.h"

#include <catch2/catch.hpp>

using namespace dini;
using server::BodyReader;
using server::BodyStream;
using server::make_body_stream;

TEST_CASE("What is added is taken in its order, and the end after it") {
  BodyStream stream = make_body_stream();
  int woken = 0;
  CHECK(stream.writer->add("one "));
  stream.reader->when_filled([&] { ++woken; });
  CHECK(woken == 1);
  CHECK(stream.writer->add("two"));
  CHECK(woken == 2);
  BodyReader::Taken taken = stream.reader->take();
  CHECK(taken.bytes == "one two");
  CHECK(taken.state == BodyReader::State::open);
  stream.writer->finish();
  CHECK(woken == 3);
  taken = stream.reader->take();
  CHECK(taken.bytes.empty());
  CHECK(taken.state == BodyReader::State::finished);
}

TEST_CASE("A maker that goes without finishing cuts the body short") {
  BodyStream stream = make_body_stream();
  CHECK(stream.writer->add("half"));
  stream.writer = nullptr;
  const BodyReader::Taken taken = stream.reader->take();
  CHECK(taken.bytes == "half");
  CHECK(taken.state == BodyReader::State::cut);
}

TEST_CASE("A maker without room is told once there is some") {
  BodyStream stream = make_body_stream(4);
  int resumed = 0;
  CHECK(stream.writer->has_room([&] { ++resumed; }));
  CHECK(stream.writer->add("12345"));
  CHECK_FALSE(stream.writer->has_room([&] { ++resumed; }));
  CHECK(resumed == 0);
  stream.reader->take();
  CHECK(resumed == 1);
  stream.reader->take();
  CHECK(resumed == 1);
}

TEST_CASE("A maker is told when nobody reads any more, whether it waits or comes later") {
  BodyStream stream = make_body_stream(1);
  int gone = 0, resumed = 0;
  CHECK(stream.writer->add("12345"));
  stream.writer->when_abandoned([&] { ++gone; });
  CHECK_FALSE(stream.writer->has_room([&] { ++resumed; }));
  stream.reader = nullptr;
  CHECK(gone == 1);
  CHECK(resumed == 1);
  CHECK_FALSE(stream.writer->add("more"));
  stream.writer->when_abandoned([&] { ++gone; });
  CHECK(gone == 2);
}
