#include "server/sending.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace dini::server {

void Sending::begin(std::unique_ptr<Reply> reply, const Exchange& exchange, const AnswerForm& form, std::size_t ahead) {
  reply_ = std::move(reply);
  chunked_ = form.chunked;
  sent_before_ = 0;
  written_ = ahead;
  if (reply_ != nullptr) {
    head_ = answer_head(*reply_, exchange, form);
    size_ = head_.size() + (form.head_only ? 0 : reply_->size());
  } else {
    size_ = last_resort().size();
  }
}

Sending::Outcome Sending::send(const Socket& socket) {
  const Outcome outcome = send_piece(socket);
  return outcome == Outcome::finished && is_streaming() ? refill() : outcome;
}

Sending::Outcome Sending::send_piece(const Socket& socket) {
  while (written_ < size_) {
    std::vector<std::string_view> pieces;
    std::size_t skip = written_;
    const auto add = [&](std::string_view piece) {
      const std::size_t skipped = std::min(skip, piece.size());
      skip -= skipped;
      if (skipped < piece.size()) pieces.push_back(piece.substr(skipped));
    };
    if (reply_ == nullptr) {
      add(last_resort());
    } else {
      add(head_);
      if (size_ > head_.size()) {
        for (const SharedBytes& piece : reply_->body) add(*piece);
      }
    }
    const Socket::Moved sent = socket.write(pieces);
    if (sent.outcome == Socket::Outcome::ended) return Outcome::broken;
    if (sent.outcome == Socket::Outcome::would_wait) return Outcome::peer_waits;
    written_ += sent.bytes;
  }
  return Outcome::finished;
}

/// Takes what there is of a stream to be sent next.
Sending::Outcome Sending::refill() {
  BodyReader::Taken taken = reply_->stream->take();
  sent_before_ += std::exchange(written_, 0);
  const bool finished = taken.state == BodyReader::State::finished;
  head_ = chunked_ ? chunk_of(taken.bytes, finished) : std::move(taken.bytes);
  size_ = head_.size();
  if (finished) {
    reply_->stream = nullptr;
    return Outcome::next_piece;
  }
  if (size_ > 0) return Outcome::next_piece;
  return taken.state == BodyReader::State::cut ? Outcome::broken : Outcome::maker_waits;
}

void Sending::end() {
  reply_ = nullptr;
  head_.clear();
}

}  // namespace dini::server
