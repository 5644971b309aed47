#include "cli/sweeping/ledger.h"

#include <cerrno>
#include <fcntl.h>
#include <fstream>
#include <system_error>
#include <unistd.h>

#include "cli/documents.h"
#include "cli/problems.h"

namespace dini::cli {

Ledger::Ledger(const std::filesystem::path& folder) : folder_(folder), path_(folder / ".dini-sweep.jsonl") {
  std::ifstream file(path_, std::ios::binary);
  for (std::string line; std::getline(file, line);) {
    Json entry = Json::parse(line, nullptr, false);
    if (entry.is_object() && entry.value("file", Json()).is_string()) {
      const std::string name = entry["file"].get<std::string>();
      entries_[name] = std::move(entry);
    }
  }
}

std::string Ledger::key_of(const std::string& file) const {
  return std::filesystem::path(file).lexically_proximate(folder_).string();
}

Json Ledger::find(const std::string& file, const std::string& tag) const {
  const auto entry = entries_.find(key_of(file));
  if (entry == entries_.end() || entry->second.value("tag", Json()) != tag) return nullptr;
  constexpr std::size_t any_size = std::size_t{1} << 40;
  const Result<std::string> bytes = read_input(file, any_size);
  if (!bytes || entry->second.value("sha256", Json()) != to_hex(sha256(*bytes))) return nullptr;
  return entry->second.value("told", Json());
}

Problems Ledger::add(const std::string& file, const std::string& tag, const std::string& sha256,
                     const Json& told) const {
  const std::string line =
      "\n" + dump(Json{{"file", key_of(file)}, {"tag", tag}, {"sha256", sha256}, {"told", told}}) + "\n";
  errno = 0;
  const int descriptor = ::open(path_.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0666);
  const bool written =
      descriptor >= 0 && ::write(descriptor, line.data(), line.size()) == static_cast<ssize_t>(line.size());
  const int error = errno;
  if (descriptor >= 0) ::close(descriptor);
  if (written) return {};
  return {io_problem(path_.string(), error)};
}

}  // namespace dini::cli
