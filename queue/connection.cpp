#include "queue/connection.h"

#include <hiredis/hiredis.h>
#include <openssl/sha.h>
#include <string_view>

namespace dini::queue {
namespace {

timeval to_timeval(std::chrono::milliseconds time) {
  return {static_cast<time_t>(time.count() / 1000), static_cast<suseconds_t>(time.count() % 1000 * 1000)};
}

struct Free {
  void operator()(redisReply* reply) const { freeReplyObject(reply); }
};

std::string text_of(const redisReply& reply) { return {reply.str, static_cast<std::size_t>(reply.len)}; }

/// Answers are as deep as our scripts make them: a few levels.
Reply reply_of(const redisReply& raw) {
  Reply reply;
  switch (raw.type) {
    case REDIS_REPLY_INTEGER:
      reply.kind = Reply::Kind::number;
      reply.number = raw.integer;
      break;
    case REDIS_REPLY_STRING:
    case REDIS_REPLY_STATUS:
    case REDIS_REPLY_ERROR:
      reply.kind = Reply::Kind::text;
      reply.text = text_of(raw);
      break;
    case REDIS_REPLY_ARRAY:
      reply.kind = Reply::Kind::list;
      reply.list.reserve(raw.elements);
      for (std::size_t i = 0; i < raw.elements; ++i) reply.list.push_back(reply_of(*raw.element[i]));
      break;
    default:
      break;
  }
  return reply;
}

Fault fault_of(const std::string& error) {
  const auto starts = [&](std::string_view word) { return error.starts_with(word); };
  if (starts("WRONGPASS") || starts("NOAUTH") || starts("NOPERM") || starts("ERR AUTH")) {
    return {Fault::Kind::denied, error};
  }
  if (starts("OOM") || error.find("OOM command not allowed") != std::string::npos) return {Fault::Kind::full, error};
  if (starts("LOADING") || starts("BUSY ") || starts("MASTERDOWN") || starts("READONLY") || starts("MISCONF")) {
    return {Fault::Kind::lost, error};
  }
  return {Fault::Kind::refused, error};
}

}  // namespace

struct Connection::Context {
  explicit Context(redisContext* made) : context(made) {}
  ~Context() { redisFree(context); }
  Context(const Context&) = delete;
  Context& operator=(const Context&) = delete;

  redisContext* const context;
};

Script::Script(std::string text) : text_(std::move(text)) {
  unsigned char digest[SHA_DIGEST_LENGTH];
  SHA1(reinterpret_cast<const unsigned char*>(text_.data()), text_.size(), digest);
  constexpr std::string_view digits = "0123456789abcdef";
  for (const unsigned char byte : digest) {
    hash_ += digits[byte >> 4];
    hash_ += digits[byte & 15];
  }
}

std::vector<std::string> Script::words(const std::vector<std::string>& keys,
                                       const std::vector<std::string>& arguments) const {
  std::vector<std::string> words = {"EVALSHA", hash_, std::to_string(keys.size())};
  words.insert(words.end(), keys.begin(), keys.end());
  words.insert(words.end(), arguments.begin(), arguments.end());
  return words;
}

bool Script::is_unknown(const Answered<Reply>& answered) {
  return !answered && answered.error().detail.starts_with("NOSCRIPT");
}

Connection::Connection(Address address, const Patience& patience) : address_(std::move(address)), patience_(patience) {}
Connection::~Connection() = default;
Connection::Connection(Connection&&) noexcept = default;

Fault Connection::lost(const std::string& detail) {
  context_ = nullptr;
  return {Fault::Kind::lost, address_.text() + ": " + detail};
}

Answered<bool> Connection::connect() {
  if (context_ != nullptr) return true;
  redisContext* const made =
      redisConnectWithTimeout(address_.host.c_str(), address_.port, to_timeval(patience_.connect));
  if (made == nullptr) return lost("there is no memory for a connection");
  context_ = std::make_unique<Context>(made);
  if (made->err != 0) return lost(made->errstr);
  redisSetTimeout(made, to_timeval(patience_.command));
  redisEnableKeepAlive(made);
  std::vector<std::vector<std::string>> greetings;
  if (!address_.password.empty()) {
    greetings.push_back({"AUTH"});
    if (!address_.user.empty()) greetings.back().push_back(address_.user);
    greetings.back().push_back(address_.password);
  }
  if (address_.database != 0) greetings.push_back({"SELECT", std::to_string(address_.database)});
  greetings.push_back({"PING"});
  for (const auto& greeting : greetings) {
    if (auto greeted = send(greeting); !greeted) {
      Fault fault = std::move(greeted).error();
      context_ = nullptr;
      if (fault.kind != Fault::Kind::lost) fault.detail = address_.text() + ": " + fault.detail;
      return fault;
    }
  }
  return true;
}

Answered<Reply> Connection::send(const std::vector<std::string>& words) {
  append(words);
  return receive();
}

/// Only memory can lack here; the answer is missing then, and the connection with it.
void Connection::append(const std::vector<std::string>& words) {
  std::vector<const char*> starts;
  std::vector<std::size_t> sizes;
  for (const std::string& word : words) {
    starts.push_back(word.data());
    sizes.push_back(word.size());
  }
  redisAppendCommandArgv(context_->context, static_cast<int>(words.size()), starts.data(), sizes.data());
}

Answered<Reply> Connection::receive() {
  void* answer = nullptr;
  redisGetReply(context_->context, &answer);
  const std::unique_ptr<redisReply, Free> raw(static_cast<redisReply*>(answer));
  if (raw == nullptr)
    return lost(context_->context->err == REDIS_ERR_IO ? "no answer in time" : context_->context->errstr);
  if (raw->type == REDIS_REPLY_ERROR) {
    Fault fault = fault_of(text_of(*raw));
    if (fault.kind == Fault::Kind::lost) context_ = nullptr;
    return fault;
  }
  return reply_of(*raw);
}

Answered<Reply> Connection::call(const std::vector<std::string>& words) {
  if (auto connected = connect(); !connected) return std::move(connected).error();
  return send(words);
}

Answered<Reply> Connection::wait(const std::vector<std::string>& words, std::chrono::milliseconds longer) {
  if (auto connected = connect(); !connected) return std::move(connected).error();
  redisSetTimeout(context_->context, to_timeval(patience_.command + longer));
  auto answered = send(words);
  if (context_ != nullptr) redisSetTimeout(context_->context, to_timeval(patience_.command));
  return answered;
}

std::vector<Answered<Reply>> Connection::call_all(const std::vector<std::vector<std::string>>& commands) {
  if (auto connected = connect(); !connected) return {commands.size(), std::move(connected).error()};
  for (const auto& words : commands) append(words);
  std::vector<Answered<Reply>> answers;
  while (answers.size() < commands.size() && context_ != nullptr) answers.push_back(receive());
  while (answers.size() < commands.size()) answers.push_back(answers.back());
  return answers;
}

Answered<Reply> Connection::run(const Script& script, const std::vector<std::string>& keys,
                                const std::vector<std::string>& arguments) {
  std::vector<std::string> words = script.words(keys, arguments);
  auto answered = call(words);
  if (!Script::is_unknown(answered)) return answered;
  words[0] = "EVAL";
  words[1] = script.text();
  return call(words);
}

}  // namespace dini::queue
