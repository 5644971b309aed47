#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "graph/problem.h"

namespace dini::server {

/// The body of a request as it arrives: of a length that was told before, or in chunks (RFC 9112, 7.1). Chunks are read
/// in one way only, or refused: sizes are 1 to 8 hexadecimal digits, lines end with CR and LF, extensions and trailers
/// are short and passed over.
class IncomingBody {
 public:
  /// A body of so many bytes.
  static IncomingBody of_length(std::size_t bytes);
  /// A body in chunks, of at most so many bytes together.
  static IncomingBody in_chunks(std::size_t limit);

  /// Takes what belongs to the body, and tells how much of `bytes` that was: all, but at its end. The problems are
  /// `bad-request` for what are no chunks, and `body-too-large`.
  Result<std::size_t> take(std::string_view bytes);

  bool is_complete() const { return state_ == State::complete; }
  /// How much has come.
  std::size_t size() const { return bytes_.size(); }
  /// What has come.
  std::string release() && { return std::move(bytes_); }

 private:
  enum class State { data, size_line, data_end, trailer, complete };

  IncomingBody(State state, std::size_t missing, std::size_t limit) : state_(state), missing_(missing), limit_(limit) {}

  std::size_t take_data(std::string_view bytes);
  Result<std::size_t> take_line(std::string_view bytes);
  std::optional<Problem> end_line();
  std::optional<Problem> begin_chunk();

  State state_;
  bool chunked_ = false;
  std::size_t missing_;  ///< of the body, or of the chunk
  std::size_t limit_;
  std::string line_ = {};  ///< of what stands between chunks, as far as it has come
  std::size_t trailer_ = 0;
  std::string bytes_ = {};
};

}  // namespace dini::server
