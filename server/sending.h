#pragma once

#include <cstddef>
#include <memory>
#include <string>

#include "server/answer_writer.h"
#include "server/reply.h"
#include "server/socket.h"

namespace dini::server {

/// An answer on its way to its peer: a head and pieces, which may be shared with other answers, or a head and a stream,
/// whose pieces are taken as they are made and their predecessors were sent.
class Sending {
 public:
  /// Begins with an answer, or with that of last resort for none, of which `ahead` bytes have been sent already.
  void begin(std::unique_ptr<Reply> reply, const Exchange& exchange, const AnswerForm& form, std::size_t ahead);

  enum class Outcome {
    finished,
    next_piece,  ///< of a stream: there is more to send
    peer_waits,  ///< the peer has to take something first
    maker_waits,
    broken,
  };
  /// Sends what the socket takes of a piece.
  Outcome send(const Socket& socket);

  /// Whether a stream is being sent; one that is given up tells its maker.
  bool is_streaming() const { return reply_ != nullptr && reply_->stream != nullptr; }
  void give_up_stream() { reply_->stream = nullptr; }

  /// Bytes that were sent, of everything and of the current piece.
  std::size_t sent() const { return sent_before_ + written_; }
  std::size_t sent_of_piece() const { return written_; }

  /// Lets go of the answer.
  void end();

 private:
  Outcome send_piece(const Socket& socket);
  Outcome refill();

  std::unique_ptr<Reply> reply_;
  std::string head_;  ///< then, of a stream, whichever piece is being sent
  bool chunked_ = false;
  std::size_t sent_before_ = 0;  ///< of a stream, in earlier pieces
  std::size_t written_ = 0;
  std::size_t size_ = 0;
};

}  // namespace dini::server
