#include "server/sweep_line.h"

namespace dini::server {
namespace {

/// What the report of an output tells, with the address of its file.
Json succeeded(Application& application, const jobs::OutputOutcome& output) {
  const Computed& computed = **output.computed;
  Json told = application.engine.report(**output.prepared, computed, Sent::request, Extent::outcome);
  told["status"] = "succeeded";
  if (computed.model != nullptr) {
    application.artifacts.add(computed.model);
    told["model"]["address"] = artifact_address(*computed.model, application.settings.base_path);
  }
  return told;
}

Json failed(const Problems& problems) { return {{"status", "failed"}, {"errors", to_json(problems)}}; }

/// Several outputs by name. What is of the variant, its checks and measures, stands beside them, once.
Json by_output(Application& application, const jobs::VariantOutcome& outcome) {
  Json line = outcome.failed() ? failed(outcome.problems()) : Json{{"status", "succeeded"}};
  for (const jobs::OutputOutcome& output : outcome.outputs) {
    Json told = output.computed ? succeeded(application, output) : failed(output.computed.problems());
    for (const char* const of_variant : {"checks", "measures"}) {
      if (told.contains(of_variant)) line[of_variant] = std::move(told[of_variant]);
      told.erase(of_variant);
    }
    told.erase("output");
    line["outputs"][output.output] = std::move(told);
  }
  return line;
}

}  // namespace

std::string sweep_line(Application& application, const jobs::VariantOutcome& outcome) {
  Json line;
  if (outcome.lists_outputs) {
    line = by_output(application, outcome);
  } else if (outcome.failed()) {
    line = failed(outcome.problems());
  } else {
    line = succeeded(application, outcome.outputs.front());
  }
  line["index"] = outcome.index;
  line["parameters"] = outcome.setting;
  return dump(line);
}

}  // namespace dini::server
