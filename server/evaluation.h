#pragma once

// Answering an evaluation, wherever its graph and its parameters come from.

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "server/application.h"
#include "server/operation.h"
#include "service/requests/requests.h"

namespace dini::server {

/// Every media type that an evaluation is answered in, the one that is answered to who takes all first: the formats of
/// files, the report, and both as parts.
std::vector<std::string_view> evaluation_types(std::span<const FileFormat> formats);

/// In what an evaluation is answered.
struct Form {
  std::string_view type;  ///< of the answer
  std::string format;     ///< the name of the format of the model in it; empty for the usual one
};

/// What `accept` likes best. Where `format` names a format, models are written in it whatever types of models that
/// says; without one the type says the format. Problems list what there is.
Result<Form> form_for(const Engine& engine, std::string_view accept, const std::string& format = "");

/// The same for a request whose query has nothing but a format.
Result<Form> asked_form(const Context& context);

/// The query parameter of that name, for descriptions.
Parameter format_parameter();

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
