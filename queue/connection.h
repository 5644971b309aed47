#pragma once

#include <chrono>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "geometry/expected.h"
#include "queue/address.h"

namespace dini::queue {

/// What Redis answers: nothing, a number, bytes, or a list of answers.
struct Reply {
  enum class Kind { nothing, number, text, list };
  Kind kind = Kind::nothing;
  std::int64_t number = 0;
  std::string text = {};
  std::vector<Reply> list = {};

  bool empty() const { return kind == Kind::nothing || (kind == Kind::list && list.empty()); }
};

/// Why there is no answer.
struct Fault {
  enum class Kind {
    lost,    ///< Redis cannot be reached, did not answer in time, or is still loading; the connection is closed
    denied,  ///< it does not take the password, or the user may not do this
    full,    ///< it has no memory for this
    refused  ///< it says that the command is wrong
  };
  Kind kind = Kind::lost;
  std::string detail;  ///< what the library or Redis says; never the password
};

template <class T>
using Answered = Expected<T, Fault>;

/// How long a connection waits.
struct Patience {
  std::chrono::milliseconds connect{250};
  std::chrono::milliseconds command{100};
};

/// A script that Redis runs in one piece. It is sent once and called by its hash from then on.
class Script {
 public:
  explicit Script(std::string text);
  const std::string& text() const { return text_; }
  const std::string& hash() const { return hash_; }  ///< SHA-1, in hexadecimal

  /// The command that runs it by its hash.
  std::vector<std::string> words(const std::vector<std::string>& keys, const std::vector<std::string>& arguments) const;
  /// Whether Redis has not seen the script: nothing was done, and it has to be sent whole.
  static bool is_unknown(const Answered<Reply>& answered);

 private:
  std::string text_;
  std::string hash_;
};

/// One connection to Redis, for one thread at a time. It is made when it is needed first, and made again after it was
/// lost; no command is sent twice by itself.
class Connection {
 public:
  Connection(Address address, const Patience& patience);
  ~Connection();
  Connection(Connection&&) noexcept;
  Connection& operator=(Connection&&) = delete;

  Answered<Reply> call(const std::vector<std::string>& words);
  /// Several commands in one go, and an answer for each; none is left out when another fails. Who sends one after the
  /// other sleeps as often, and a thread that slept finds its processor slow.
  std::vector<Answered<Reply>> call_all(const std::vector<std::vector<std::string>>& commands);
  /// A command that waits by itself for so long at Redis.
  Answered<Reply> wait(const std::vector<std::string>& words, std::chrono::milliseconds longer);
  Answered<Reply> run(const Script& script, const std::vector<std::string>& keys,
                      const std::vector<std::string>& arguments);

  /// Connects now, if it is not connected.
  Answered<bool> connect();
  bool is_connected() const { return context_ != nullptr; }
  const Address& address() const { return address_; }

 private:
  struct Context;

  Answered<Reply> send(const std::vector<std::string>& words);
  void append(const std::vector<std::string>& words);
  Answered<Reply> receive();
  Fault lost(const std::string& detail);

  Address address_;
  Patience patience_;
  std::unique_ptr<Context> context_;
};

}  // namespace dini::queue
