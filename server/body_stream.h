#pragma once

// A body that is made while it is sent, such as lines of NDJSON or server-sent events. Its maker adds pieces, from any
// thread; the connection takes them as fast as its client does. What waits to be taken is bounded: the maker is told
// when to pause, and when nobody reads any more.

#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <utility>

namespace dini::server {

class BodyPipe;

/// The maker's end. One that goes without finishing cuts the body short, which its reader notices.
class BodyWriter {
 public:
  explicit BodyWriter(std::shared_ptr<BodyPipe> pipe) : pipe_(std::move(pipe)) {}
  ~BodyWriter();
  BodyWriter(const BodyWriter&) = delete;
  BodyWriter& operator=(const BodyWriter&) = delete;

  /// False once nobody reads any more: there is no use in making more.
  bool add(std::string_view piece);
  /// Nothing more comes.
  void finish();
  /// Whether to go on now. If not, `resume` is called once, when there is room again or nobody reads any more, on the
  /// thread of the reader: it must be quick.
  bool has_room(std::function<void()> resume);
  /// Calls `gone` once nobody reads any more, on the thread of the reader; at once if that is so already.
  void when_abandoned(std::function<void()> gone);

 private:
  std::shared_ptr<BodyPipe> pipe_;
};

/// The connection's end. One that goes is nobody reading any more.
class BodyReader {
 public:
  explicit BodyReader(std::shared_ptr<BodyPipe> pipe) : pipe_(std::move(pipe)) {}
  ~BodyReader();
  BodyReader(const BodyReader&) = delete;
  BodyReader& operator=(const BodyReader&) = delete;

  /// Memory that the stream may hold, about.
  std::size_t room() const;

  /// `wake` is called when there is something to take, on the thread of the maker; at once if there is already.
  void when_filled(std::function<void()> wake);

  enum class State { open, finished, cut };
  struct Taken {
    std::string bytes;
    State state = State::open;  ///< once it is not open, these bytes are the last
  };
  Taken take();

 private:
  std::shared_ptr<BodyPipe> pipe_;
};

struct BodyStream {
  std::shared_ptr<BodyWriter> writer;
  std::shared_ptr<BodyReader> reader;
};

/// `room`: how many bytes may wait before there is no room for more.
BodyStream make_body_stream(std::size_t room = std::size_t{64} << 10);

}  // namespace dini::server
