#include "server/sweep_line.h"

namespace dini::server {

std::string sweep_line(Application& application, const jobs::VariantOutcome& outcome) {
  Json line = {{"index", outcome.index}, {"parameters", outcome.setting}};
  if (outcome.computed) {
    line.update(application.engine.report(**outcome.prepared, **outcome.computed, Sent::request, Extent::outcome));
    line["status"] = "succeeded";
    if (const SharedFile& model = (*outcome.computed)->model) {
      application.artifacts.add(model);
      line["model"]["address"] = artifact_address(*model, application.settings.base_path);
    }
  } else {
    line["status"] = "failed";
    line["errors"] = to_json(outcome.computed.problems());
  }
  return dump(line);
}

}  // namespace dini::server
