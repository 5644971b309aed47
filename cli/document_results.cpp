#include "cli/document_results.h"

#include <algorithm>
#include <iostream>

#include "cli/evaluation.h"
#include "cli/exit_codes.h"

namespace dini::cli {

void DocumentResults::add(const std::string& path, const Json& told, int code) {
  Json file = told;
  file["file"] = path;
  file["errors"] = Json::array();
  files_.push_back(std::move(file));
  code_ = std::max(code_, code);
}

void DocumentResults::add_failure(const std::string& path, const Problems& problems, int code,
                                  const SourceText* source) {
  if (!console_.json()) console_.problems(problems, source);
  files_.push_back({{"file", path}, {"errors", problems_json(problems, source)}});
  code_ = std::max(code_, code);
}

int DocumentResults::finish() const {
  if (console_.json()) std::cout << written({{"succeeded", code_ == exit_ok}, {"files", files_}});
  return code_;
}

}  // namespace dini::cli
