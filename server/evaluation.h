#pragma once

// Answering an evaluation, wherever its graph and its parameters come from.

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "server/application.h"
#include "service/requests/requests.h"

namespace dini::server {

/// Every media type that an evaluation is answered in, the one that is answered to who takes all first: the formats of
/// files, the report, and both as parts.
std::vector<std::string_view> evaluation_types(std::span<const FileFormat> formats);

/// The type that a client likes best, or the problem that lists them all.
Result<std::string_view> evaluation_type(const Engine& engine, std::string_view accept);

/// The name of the format of a media type; empty for one that is no file's.
std::string format_of_answer(const Engine& engine, std::string_view type);

/// How an evaluation is answered besides what it comes to.
struct Presentation {
  std::string cache_control = "no-cache";
  bool attachment = false;  ///< to be saved rather than shown
  bool parts = false;       ///< `Range` is looked at
};

/// Checks the request, unless one of its identity was checked before, and answers: that something is wrong, 304, what
/// is known, or what comes of computing it.
void answer_evaluation(const Context& context, std::string_view type, const std::shared_ptr<const EvaluateBody>& body,
                       const Presentation& presentation = {});

}  // namespace dini::server
