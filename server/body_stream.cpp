#include "server/body_stream.h"

#include <mutex>

namespace dini::server {

/// What both ends share. Nothing of theirs is called under its lock.
class BodyPipe {
 public:
  explicit BodyPipe(std::size_t room) : room_(room) {}

  const std::size_t room_;
  std::mutex mutex_;
  std::string waiting_;
  BodyReader::State state_ = BodyReader::State::open;
  bool abandoned_ = false;
  std::function<void()> wake_;
  std::function<void()> resume_;
  std::function<void()> gone_;

  void end(BodyReader::State state) {
    std::function<void()> wake;
    {
      const std::lock_guard lock(mutex_);
      if (state_ != BodyReader::State::open) return;
      state_ = state;
      resume_ = nullptr;
      gone_ = nullptr;
      wake = std::move(wake_);  // it is not needed again
    }
    if (wake) wake();
  }
};

BodyWriter::~BodyWriter() { pipe_->end(BodyReader::State::cut); }

void BodyWriter::finish() { pipe_->end(BodyReader::State::finished); }

bool BodyWriter::add(std::string_view piece) {
  std::function<void()> wake;
  {
    const std::lock_guard lock(pipe_->mutex_);
    if (pipe_->abandoned_) return false;
    pipe_->waiting_.append(piece);
    wake = pipe_->wake_;
  }
  if (wake) wake();
  return true;
}

bool BodyWriter::has_room(std::function<void()> resume) {
  const std::lock_guard lock(pipe_->mutex_);
  if (pipe_->abandoned_ || pipe_->waiting_.size() < pipe_->room_) return true;
  pipe_->resume_ = std::move(resume);
  return false;
}

void BodyWriter::when_abandoned(std::function<void()> gone) {
  {
    const std::lock_guard lock(pipe_->mutex_);
    if (!pipe_->abandoned_) {
      pipe_->gone_ = std::move(gone);
      return;
    }
  }
  gone();
}

BodyReader::~BodyReader() {
  std::function<void()> resume, gone;
  {
    const std::lock_guard lock(pipe_->mutex_);
    pipe_->abandoned_ = true;
    pipe_->waiting_ = {};
    pipe_->wake_ = nullptr;
    resume = std::move(pipe_->resume_);
    gone = std::move(pipe_->gone_);
  }
  if (gone) gone();
  if (resume) resume();
}

std::size_t BodyReader::room() const { return pipe_->room_; }

void BodyReader::when_filled(std::function<void()> wake) {
  {
    const std::lock_guard lock(pipe_->mutex_);
    pipe_->wake_ = wake;
    if (pipe_->waiting_.empty() && pipe_->state_ == State::open) return;
  }
  wake();
}

BodyReader::Taken BodyReader::take() {
  Taken taken;
  std::function<void()> resume;
  {
    const std::lock_guard lock(pipe_->mutex_);
    taken = {std::exchange(pipe_->waiting_, {}), pipe_->state_};
    resume = std::exchange(pipe_->resume_, nullptr);
  }
  if (resume) resume();
  return taken;
}

BodyStream make_body_stream(std::size_t room) {
  const auto pipe = std::make_shared<BodyPipe>(room);
  return {std::make_shared<BodyWriter>(pipe), std::make_shared<BodyReader>(pipe)};
}

}  // namespace dini::server
