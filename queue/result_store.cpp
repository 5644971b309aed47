#include "queue/result_store.h"

#include <random>
#include <unistd.h>

#include "queue/scripts.h"
#include "queue/sealed.h"

namespace dini::queue {
namespace {

/// Somebody waits for an answer: making a connection and the first command together stay below a tenth of a second.
constexpr Patience patience{std::chrono::milliseconds(25), std::chrono::milliseconds(60)};
/// A result that nobody asks for goes after a week; Redis may let it go earlier (maxmemory-policy volatile-lru).
constexpr const char* time_to_live = "604800";
constexpr std::string_view result_type = "application/x-dini-result";

std::string result_key(const std::string& key) { return "dini:result:" + key; }
std::string lease_key(const std::string& key) { return "dini:lease:" + key; }

}  // namespace

ResultStore::ResultStore(Link& link, std::string version)
    : link_(link),
      version_(std::move(version)),
      owner_(std::to_string(::getpid()) + "-" + std::to_string(std::random_device()())) {}

/// On a connection that nobody else uses. A fault is noted, so that it is paid for once.
template <class Ask>
std::optional<Reply> ResultStore::ask(Ask ask) {
  if (!link_.is_well()) return std::nullopt;
  std::unique_ptr<Connection> connection;
  {
    const std::lock_guard lock(mutex_);
    if (!idle_.empty()) {
      connection = std::move(idle_.back());
      idle_.pop_back();
    }
  }
  if (connection == nullptr) connection = std::make_unique<Connection>(link_.address(), patience);
  auto answered = ask(*connection);
  const std::lock_guard lock(mutex_);
  if (!answered) {
    link_.note(answered.error());
    idle_.clear();
    return std::nullopt;
  }
  idle_.push_back(std::move(connection));
  return *std::move(answered);
}

std::optional<Reply> ResultStore::call(const std::vector<std::string>& words) {
  return ask([&](Connection& connection) { return connection.call(words); });
}

std::optional<Reply> ResultStore::run(const Script& script, const std::vector<std::string>& arguments) {
  return ask([&](Connection& connection) { return connection.run(script, {}, arguments); });
}

std::optional<std::string> ResultStore::find(const std::string& key) {
  const auto reply = call({"GET", result_key(key)});
  if (reply && !reply->empty()) {
    if (const auto bytes = unsealed(reply->text, result_type, version_)) {
      ++counts_.hits;
      return std::string(*bytes);
    }
    ++counts_.damaged;
    call({"DEL", result_key(key)});
  }
  ++counts_.misses;
  return std::nullopt;
}

void ResultStore::keep(const std::string& key, const std::string& bytes) {
  if (bytes.size() > most_bytes) return;
  if (call({"SET", result_key(key), sealed(result_type, version_, bytes), "EX", time_to_live})) ++counts_.kept;
}

bool ResultStore::lease(const std::string& key, std::chrono::milliseconds time) {
  const auto reply = call({"SET", lease_key(key), owner_, "NX", "PX", std::to_string(time.count())});
  return !reply || !reply->empty();
}

void ResultStore::release(const std::string& key) { run(scripts::release, {lease_key(key), owner_}); }

}  // namespace dini::queue
