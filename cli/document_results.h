#pragma once

#include <optional>
#include <string>

#include "cli/source_text.h"
#include "cli/terminal.h"

namespace dini::cli {

/// What a command that looks at several documents one by one came to: told as it goes, or at the end as JSON.
class DocumentResults {
 public:
  explicit DocumentResults(const Console& console) : console_(console) {}

  /// A document that is well, with what JSON tells of it. What is said of it otherwise is up to the command.
  void add(const std::string& path, const Json& told, int code = 0);

  /// A document that is not.
  void add_failure(const std::string& path, const Problems& problems, int code, const SourceText* source = nullptr);

  /// The largest exit code of all; with `--json` the answer is `{"succeeded": ..., "files": [...]}`.
  int finish() const;

 private:
  const Console& console_;
  Json files_ = Json::array();
  int code_ = 0;
};

}  // namespace dini::cli
