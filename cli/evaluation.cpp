#include "cli/evaluation.h"

#include <algorithm>
#include <chrono>
#include <iomanip>
#include <new>
#include <sstream>

#include "cli/exit_codes.h"
#include "cli/terminal.h"
#include "geometry/counted.h"
#include "geometry/place_text.h"
#include "graph/stopped.h"

namespace dini::cli {
namespace {

/// What a step comes to, also when it throws.
template <class Step>
Outcome outcome_of(const Step& step) {
  try {
    return step();
  } catch (const std::bad_alloc&) {
    return failed({out_of_memory()}, exit_limit);
  } catch (const std::exception& error) {
    return failed({{.code = "internal", .detail = error.what()}}, exit_our_bug);
  }
}

Outcome computed(const Engine& engine, const Result<SharedPrepared>& prepared, const Job& job) {
  if (!prepared) return failed(prepared.problems(), exit_code_for(prepared.problems(), Stage::checking));
  const auto computed = engine.compute(**prepared, job);
  if (!computed) return failed(computed.problems(), exit_code_for(computed.problems(), Stage::evaluating));
  return {.report = engine.report(**prepared, **computed, Sent::document),
          .file = (*computed)->model != nullptr ? (*computed)->model : (*computed)->preview};
}

/// `watertight, 1 piece, 0 pairs of triangles meet, least thickness 0.1 m, volume 2.5 m^3`
std::string solid_text(const Json& part) {
  const auto count = [&](const char* member, std::string_view one, std::string_view many) {
    return counted(part.at(member).get<std::size_t>(), one, many);
  };
  return (part.at("watertight") == true ? "watertight" : "open, " + count("boundary_loops", "border", "borders")) +
         ", " + count("components", "piece", "pieces") + ", " +
         count("self_intersections", "pair of triangles meets", "pairs of triangles meet") + ", least thickness " +
         short_text(part.at("least_thickness")) + " m, volume " + short_text(part.at("volume")) + " m^3";
}

}  // namespace

Outcome failed(const Problems& problems, int code) { return {.code = code, .problems = problems}; }

Job job_within(std::size_t milliseconds) {
  using Clock = Cancel::Clock;
  return {
      Cancel(milliseconds == 0 ? Clock::time_point::max() : Clock::now() + std::chrono::milliseconds(milliseconds))};
}

Outcome evaluated(const Engine& engine, const Result<SharedPrepared>& prepared, const Job& job) {
  return outcome_of([&] { return computed(engine, prepared, job); });
}

Outcome evaluated(const Engine& engine, const EvaluateRequest& request, const Job& job) {
  return outcome_of([&] { return computed(engine, engine.prepare(request, job.cancel), job); });
}

std::string written(const Json& json) { return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n"; }

Json report_of(const Outcome& outcome, const SourceText* source) {
  Json report = outcome.report;
  report["succeeded"] = outcome.code == exit_ok;
  report["errors"] = problems_json(outcome.problems, source);
  return report;
}

std::string summary_of(const Json& report) {
  const bool preview = !report.contains("model");
  const Json model = report.value(preview ? "preview" : "model", Json::object());
  std::string text = report.value("output", "preview") + ":";
  for (const auto* measure : {"bytes", "vertices", "triangles"}) {
    if (model.contains(measure)) text += (text.back() == ':' ? " " : ", ") + model.at(measure).dump() + " " + measure;
  }
  return printable(text);
}

std::string parts_of(const Json& report) {
  std::string text;
  for (const Json& part : report.value("parts", Json::array())) {
    const std::string name = "  " + printable(part.at("name").get<std::string>()) + ": ";
    text +=
        name + (part.at("type") == "mesh" ? solid_text(part) : part.at("count").dump() + " drawn as lines or points");
    text += "\n";
  }
  return text;
}

std::string times_of(const Json& report) {
  std::vector<std::pair<double, std::string>> times;
  const Json nodes = report.value("nodes", Json::object());
  for (const auto& [id, node] : nodes.items()) {
    if (!node.value("cached", false)) times.emplace_back(node.value("milliseconds", 0.0), id);
  }
  std::ranges::stable_sort(times, std::ranges::greater(), &std::pair<double, std::string>::first);
  std::ostringstream text;
  text << std::fixed << std::setprecision(2);
  for (const auto& [milliseconds, id] : times) {
    text << std::setw(10) << milliseconds << " ms  " << printable(id) << " (" << nodes[id].value("type", "") << ")\n";
  }
  return text.str();
}

}  // namespace dini::cli
