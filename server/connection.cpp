#include "server/connection.h"

#include <algorithm>
#include <new>

#include "server/access.h"
#include "server/forwarding.h"
#include "server/negotiation.h"
#include "server/responses.h"
#include "server/text.h"
#include "server/trace.h"

namespace dini::server {
namespace {

constexpr std::size_t read_bytes_per_second = 1024 * 1024;
/// How long a peer may go on sending before a connection is closed whose answer it should read. Closing a socket with
/// unread bytes would reset the connection and take the answer just given with it.
constexpr std::chrono::milliseconds linger_time{500};
/// What an idle connection gets for a request that is on its way when the server stops.
constexpr std::chrono::milliseconds farewell_time{300};
constexpr std::string_view head_end = "\r\n\r\n";

/// For the log: what can be said about a request that was refused before it was understood.
Access access_of(std::string_view input) {
  const std::string_view line = input.substr(0, std::min(input.find('\r'), input.size()));
  const auto space = line.find(' ');
  if (space == std::string_view::npos) return {.path = std::string(line.substr(0, 256))};
  std::string_view target = line.substr(space + 1);
  target = target.substr(0, std::min<std::size_t>(target.rfind(' '), 256));
  return {.method = std::string(line.substr(0, space)), .path = std::string(target)};
}

/// Bytes that are held for this answer alone.
std::size_t held_alone(const Reply& reply) {
  if (reply.stream != nullptr) return reply.stream->room();
  std::size_t held = 0;
  for (const SharedBytes& piece : reply.body) {
    if (piece.use_count() == 1) held += piece->size();
  }
  return held;
}

}  // namespace

Connection::Connection(Home& home, int descriptor)
    : home_(home),
      descriptor_(descriptor),
      socket_(descriptor),
      since_(Clock::now()),
      deadline_(since_ + home.settings().head_deadline) {}

Connection::~Connection() { close(); }

void Connection::deliver(std::unique_ptr<Reply> reply) {
  {
    const std::lock_guard lock(mutex_);
    delivered_ = std::move(reply);
    has_delivered_ = true;
    interest_ = nullptr;
  }
  home_.wake(shared_from_this());
}

void Connection::watch(std::shared_ptr<jobs::Flights::Interest> interest) {
  {
    const std::lock_guard lock(mutex_);
    if (has_delivered_) return;
    if (!client_gone_) {
      interest_ = std::move(interest);
      return;
    }
  }
  interest->stop(StopReason::client_gone);
}

void Connection::close() noexcept {
  if (state_ == State::closed) return;
  if (state_ == State::writing) write_log();  // what was not taken is in the log too
  if (sending_.is_streaming()) sending_.give_up_stream();
  state_ = State::closed;
  home_.give_incoming(std::exchange(held_incoming_, 0));
  home_.give_unsent(std::exchange(held_unsent_, 0));
  std::shared_ptr<jobs::Flights::Interest> interest;
  {
    const std::lock_guard lock(mutex_);
    client_gone_ = true;
    interest = std::move(interest_);
  }
  if (interest) interest->stop(StopReason::client_gone);
}

void Connection::on_ready(const Ready& ready, std::span<char> buffer) {
  readable_ = readable_ || ready.read;
  half_closed_ = half_closed_ || ready.half_closed;
  if (ready.broken) return close();
  if (state_ == State::answering && half_closed_) notice_half_close();
  if (state_ == State::writing && ready.write) write();
  read(buffer);
}

void Connection::on_woken(std::span<char> buffer) {
  std::unique_ptr<Reply> reply;
  bool has_reply = false;
  {
    const std::lock_guard lock(mutex_);
    has_reply = std::exchange(has_delivered_, false);
    reply = std::move(delivered_);
  }
  if (has_reply && state_ == State::answering) begin_answer(std::move(reply));
  if (state_ == State::writing && sending_.is_streaming()) write();
  read(buffer);
}

/// A peer that sends no more has either left for good or waits for its answer; the two look alike until something is
/// sent, to which only the one that has left replies with a reset. Every answer begins with the same bytes, so these
/// are sent ahead.
void Connection::notice_half_close() {
  last_ = true;
  if (probed_) return;
  probed_ = true;
  const std::array pieces = {answer_beginning};
  const Socket::Moved sent = socket_.write(pieces);
  if (sent.outcome != Socket::Outcome::moved || sent.bytes != answer_beginning.size()) close();
}

void Connection::read(std::span<char> buffer) {
  constexpr int most_reads = 8;  // then it is the turn of others
  const auto wants_more = [this] { return readable_ && (state_ == State::reading || state_ == State::lingering); };
  for (int i = 0; i < most_reads && wants_more(); ++i) {
    const Socket::Moved got = socket_.read(buffer);
    if (got.outcome == Socket::Outcome::ended) return close();
    // Less than there was room for means that there is no more; whatever comes is told anew.
    readable_ = got.bytes == buffer.size();
    if (got.bytes > 0 && state_ == State::reading) take({buffer.data(), got.bytes});
  }
  if (wants_more()) home_.wake(shared_from_this());
  if (state_ == State::answering && half_closed_) notice_half_close();
}

void Connection::take(std::string_view bytes) {
  if (head_) return take_body(bytes);
  if (is_idle()) {
    // Some clients send an empty line after a body (RFC 9112, 2.2).
    while (bytes.starts_with("\r\n")) bytes.remove_prefix(2);
    if (bytes.empty()) return;
    since_ = Clock::now();
    deadline_ = since_ + home_.settings().head_deadline;
    exchange_ = Exchange{.id = home_.next_id(), .started = since_, .base = home_.settings().base_path};
    access_ = {};
  }
  input_.append(bytes);
  take_head();
}

void Connection::take_head() {
  const auto end = input_.find(head_end);
  if (end == std::string::npos) {
    if (auto problem = check_unfinished_head(input_, home_.settings())) refuse(*problem);
    return;
  }
  const std::size_t size = end + head_end.size();
  if (size > home_.settings().head_bytes) {
    return refuse({.code = "headers-too-large",
                   .detail = "The headers are larger than " + std::to_string(home_.settings().head_bytes) + " bytes."});
  }
  auto head = parse_head(std::string_view(input_).substr(0, size), home_.settings());
  if (!head) return refuse(head.problems().front());
  take_names(head->request, *exchange_);
  take_forwarding(Address::of_peer(descriptor_), home_.settings(), head->request, *exchange_);
  exchange_->shared_with = shared_origin(head->request, home_.settings());
  exchange_->differs_by_origin = !home_.settings().allowed_origins.empty() && exchange_->shared_with != "*";
  auto admission = home_.admit(*head, *exchange_);
  if (auto* refused = std::get_if<Reply>(&admission)) return refuse(std::move(*refused));
  const std::size_t limit = std::get<std::size_t>(admission);
  if (head->content_length > limit) {
    return refuse({.code = "body-too-large",
                   .detail = "The body has " + std::to_string(head->content_length) + " bytes; at most " +
                             std::to_string(limit) + " are accepted."});
  }
  access_ = access_of(input_);
  head_ = *std::move(head);
  const std::string rest = input_.substr(size);
  input_.clear();
  body_ = head_->is_chunked ? IncomingBody::in_chunks(limit) : IncomingBody::of_length(head_->content_length);
  body_begun_ = Clock::now();
  set_body_deadline();
  if (head_->expects_continue && rest.empty() && !body_->is_complete()) {
    constexpr std::array<std::string_view, 1> go_on = {"HTTP/1.1 100 Continue\r\n\r\n"};
    if (socket_.write(go_on).bytes != go_on[0].size()) return close();
  }
  take_body(rest);
}

void Connection::take_body(std::string_view bytes) {
  const auto taken = body_->take(bytes);
  if (!taken) return refuse(taken.problems().front());
  const std::size_t added = body_->size() - held_incoming_;
  if (!home_.take_incoming(added)) {
    return refuse({.code = "busy", .detail = "Too many large bodies arrive at once; try again in a moment."});
  }
  held_incoming_ += added;
  if (bytes.size() > *taken) {
    // Bytes past the request would be a pipelined one, or one smuggled through a proxy that counts differently: no
    // telling.
    last_ = true;
  }
  if (body_->is_complete()) return finish_request();
  if (head_->is_chunked) set_body_deadline();
}

/// A body whose length is not told gets more time as it comes.
void Connection::set_body_deadline() {
  const std::size_t bytes = head_->is_chunked ? body_->size() : head_->content_length;
  deadline_ = body_begun_ + home_.settings().body_deadline + std::chrono::seconds(bytes / read_bytes_per_second);
}

void Connection::finish_request() {
  state_ = State::answering;
  since_ = Clock::now();
  deadline_ = Clock::time_point::max();
  last_ = last_ || head_->close || home_.is_draining();
  exchange_->accepts_gzip = accepts_coding(head_->request.header("Accept-Encoding"), "gzip");
  head_->request.body = std::move(*body_).release();
  body_.reset();
  home_.answer(std::make_shared<Call>(shared_from_this(), std::move(head_->request), *exchange_));
}

void Connection::give_up() noexcept {
  if (state_ != State::reading && state_ != State::answering) return close();
  body_.reset();
  home_.give_unsent(std::exchange(held_unsent_, 0));
  try {
    begin_answer(nullptr);
  } catch (const std::bad_alloc&) {
    return close();
  }
  home_.wake(shared_from_this());  // there may be more to read before its peer reads the answer
}

void Connection::refuse(const Problem& problem) { refuse(refusal(problem, *exchange_)); }

void Connection::refuse(Reply reply) {
  if (!head_) access_ = access_of(input_);
  last_ = true;  // there may be more of it to come
  begin_answer(std::make_unique<Reply>(std::move(reply)));
}

void Connection::begin_answer(std::unique_ptr<Reply> reply) {
  home_.give_incoming(std::exchange(held_incoming_, 0));
  last_ = last_ || home_.is_draining();
  const bool head_only = access_.method == "HEAD";
  if (reply != nullptr && head_only) reply->stream = nullptr;
  const std::size_t held = reply != nullptr ? held_alone(*reply) : 0;
  if (held > 0 && !home_.take_unsent(held)) {
    *reply = refusal({.code = "busy", .detail = "Too many large answers wait to be taken; try again in a moment."},
                     *exchange_);
  } else {
    held_unsent_ = held;
  }
  const bool streaming = reply != nullptr && reply->stream != nullptr;
  const bool chunked = streaming && head_ && !head_->is_old;
  last_ = last_ || (streaming && !chunked) || reply == nullptr;
  if (streaming) {
    reply->stream->when_filled([weak = weak_from_this()] {
      if (const auto connection = weak.lock()) connection->home_.wake(connection);
    });
  }
  access_.status = reply != nullptr ? reply->status : 503;
  access_.notes = reply != nullptr ? reply->notes : AnswerNotes{};
  sending_.begin(std::move(reply), *exchange_, {.head_only = head_only, .close = last_, .chunked = chunked},
                 probed_ ? answer_beginning.size() : 0);
  state_ = State::writing;
  begin_wait_for_peer();
  write();
}

void Connection::begin_wait_for_peer() {
  since_ = Clock::now();
  deadline_ = since_ + home_.settings().write_deadline;
  sent_before_wait_ = sending_.sent_of_piece();
}

void Connection::write() {
  while (true) {
    switch (sending_.send(socket_)) {
      case Sending::Outcome::finished:
        return finish_answer();
      case Sending::Outcome::next_piece:
        begin_wait_for_peer();
        break;
      case Sending::Outcome::peer_waits:
        return;
      case Sending::Outcome::maker_waits:
        deadline_ = Clock::time_point::max();  // it has deadlines of its own
        return;
      case Sending::Outcome::broken:
        return close();
    }
  }
}

void Connection::write_log() noexcept {
  access_.bytes = sending_.sent();
  if (exchange_) home_.log(access_, *exchange_);
}

void Connection::finish_answer() {
  write_log();
  sending_.end();
  home_.give_unsent(std::exchange(held_unsent_, 0));
  last_ || half_closed_ ? linger() : expect_request();
}

void Connection::expect_request() {
  state_ = State::reading;
  since_ = Clock::now();
  deadline_ = since_ + (home_.is_draining() ? farewell_time : home_.settings().idle_deadline);
  head_.reset();
  exchange_.reset();
  probed_ = false;
}

void Connection::linger() {
  socket_.finish_writing();
  if (half_closed_) return close();
  state_ = State::lingering;
  deadline_ = Clock::now() + linger_time;
  head_.reset();
}

void Connection::drain() {
  if (is_idle()) deadline_ = std::min(deadline_, Clock::now() + farewell_time);
}

void Connection::on_time(Clock::time_point now) {
  if (now < deadline_) return;
  switch (state_) {
    case State::reading:
      if (is_idle()) return linger();
      return refuse({.code = "request-timeout",
                     .detail = head_ ? "The body did not arrive in time." : "The headers did not arrive in time."});
    case State::writing: {
      const double least =
          static_cast<double>(home_.settings().write_rate) * std::chrono::duration<double>(now - since_).count();
      if (static_cast<double>(sending_.sent_of_piece() - sent_before_wait_) < least) return close();
      return begin_wait_for_peer();
    }
    case State::lingering:
      return close();
    case State::answering:
    case State::closed:
      return;
  }
}

}  // namespace dini::server
