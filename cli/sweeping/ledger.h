#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "graph/problem.h"

namespace dini::cli {

/// What earlier runs of a sweep have finished: a file of lines beside its models, one for each. Lines are appended in
/// one piece, so several processes may share it, and one that was killed leaves at most a piece of a line, which is
/// passed over.
class Ledger {
 public:
  explicit Ledger(const std::filesystem::path& folder);

  /// What was told of a model, if the file is still the one that was written and the tag still that of the model.
  /// Otherwise null.
  Json find(const std::string& file, const std::string& tag) const;

  /// Tells that a file was finished. Problems: `io`.
  Problems add(const std::string& file, const std::string& tag, const std::string& sha256, const Json& told) const;

 private:
  std::string key_of(const std::string& file) const;

  std::filesystem::path folder_;
  std::filesystem::path path_;
  std::map<std::string, Json> entries_;  ///< by file, as seen from the folder
};

}  // namespace dini::cli
