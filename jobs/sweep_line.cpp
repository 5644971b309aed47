#include "jobs/sweep_line.h"

namespace dini::jobs {
namespace {

/// What the report of an output tells, with the address of its file.
Json succeeded(const Engine& engine, const OutputOutcome& output, const std::string& base_path) {
  const Computed& computed = **output.computed;
  Json told = engine.report(**output.prepared, computed, Sent::request, Extent::outcome);
  told["status"] = "succeeded";
  if (computed.model != nullptr) told["model"]["address"] = artifact_address(*computed.model, base_path);
  return told;
}

Json failed(const Problems& problems) { return {{"status", "failed"}, {"errors", to_json(problems)}}; }

/// Several outputs by name. What is of the variant, its checks and measures, stands beside them, once.
Json by_output(const Engine& engine, const VariantOutcome& outcome, const std::string& base_path) {
  Json line = outcome.failed() ? failed(outcome.problems()) : Json{{"status", "succeeded"}};
  for (const OutputOutcome& output : outcome.outputs) {
    Json told = output.computed ? succeeded(engine, output, base_path) : failed(output.computed.problems());
    for (const char* const of_variant : {"checks", "measures"}) {
      if (told.contains(of_variant)) line[of_variant] = std::move(told[of_variant]);
      told.erase(of_variant);
    }
    told.erase("output");
    line["outputs"][output.output] = std::move(told);
  }
  return line;
}

store::JobLine written(std::size_t index, const Json& setting, Json line, bool is_failed,
                       std::vector<SharedFile> files) {
  line["index"] = index;
  line["parameters"] = setting;
  return {.index = index, .failed = is_failed, .text = dump(line), .files = std::move(files)};
}

}  // namespace

std::string artifact_address(const File& file, std::string_view base_path) {
  return std::string(base_path) + "/v1/artifacts/" + to_hex(file.sha256);
}

store::JobLine sweep_line(const Engine& engine, const VariantOutcome& outcome, const std::string& base_path) {
  Json line;
  if (outcome.lists_outputs) {
    line = by_output(engine, outcome, base_path);
  } else if (outcome.failed()) {
    line = failed(outcome.problems());
  } else {
    line = succeeded(engine, outcome.outputs.front(), base_path);
  }
  return written(outcome.index, outcome.setting, std::move(line), outcome.failed(), outcome.files());
}

store::JobLine failed_line(std::size_t index, const Json& setting, const Problems& problems) {
  return written(index, setting, failed(problems), true, {});
}

}  // namespace dini::jobs
