#include <algorithm>

#include "graph/nearest.h"
#include "service/requests/quality.h"
#include "service/requests/request_type.h"
#include "service/requests/requests.h"

namespace dini {

namespace {

const RequestType<SweepBody>& request() {
  static const auto declared =
      RequestType<SweepBody>("SweepRequest", "One graph evaluated for many settings of its parameters.")
          .graph(
              &EvaluateRequest::graph,
              "The graph document, or the name of a graph that is kept: `chair`, or `chair@3` for one of its versions.")
          .member("parameters", &EvaluateRequest::parameters, "Values that all variants share, by parameter.",
                  left_out_means("the defaults of those that do not vary"))
          .member("grid", &SweepAxes::grid,
                  "Lists of values by parameter, all combined; the last parameter of the alphabet varies fastest.",
                  left_out_means("another of the three is given").example({{"reach", {0.5, 1, 1.5}}}))
          .member("zip", &SweepAxes::zip,
                  "Lists of one length by parameter: the first values of all, then the second ones, and so on.",
                  left_out_means("another of the three is given"))
          .objects("list", &SweepAxes::list, "Values by parameter, for one variant each.",
                   left_out_means("another of the three is given"))
          .member("output", &EvaluateRequest::output, "The `export` node whose models are made.",
                  left_out_means("the only one of the graph"))
          .member("outputs", &SweepBody::outputs,
                  "Several `export` nodes whose models are made of each variant, told by their names in its line.",
                  left_out_means("`output` alone"))
          .member("models", &SweepBody::models, "Whether models are made at all, or only measures and checks.",
                  usually(true))
          .member("measures", &EvaluateRequest::measures,
                  "Outputs (`node` or `node.output`) whose values are told for each variant.", left_out_means("none"))
          .member("quality", &EvaluateRequest::quality, "A draft is made faster, of fewer triangles.", usually("final"))
          .member("first", &SweepBody::first,
                  "The variant to begin with, counted from 0: to go on with a sweep that broke off.",
                  usually(0).range(0, {}))
          .deadline(&SweepBody::deadline_milliseconds, "sweep_milliseconds");
  return declared;
}

Problem at_outputs(const std::string& rest, std::string code, std::string detail) {
  return {.code = std::move(code), .detail = std::move(detail), .pointer = "/outputs" + rest, .in_request = true};
}

}  // namespace

Problems faults_in_outputs(const std::vector<std::string>& outputs, const Graph& graph, const Engine& engine) {
  if (outputs.empty()) return {at_outputs("", "required-input-missing", "outputs names no output")};
  // A graph that cannot be read says so itself, in every variant.
  const Result<Json> interface = engine.interface(graph);
  const auto known = interface ? interface->value("outputs", std::vector<std::string>()) : std::vector<std::string>();
  std::string list;
  for (const std::string& name : known) list += (list.empty() ? "" : ", ") + name;
  Problems faults;
  for (auto name = outputs.begin(); name != outputs.end(); ++name) {
    const std::string place = "/" + std::to_string(name - outputs.begin());
    if (std::find(outputs.begin(), name, *name) != name) {
      faults.push_back(at_outputs(place, "out-of-range", "\"" + *name + "\" is listed twice; one of them goes"));
    } else if (interface && std::ranges::find(known, *name) == known.end()) {
      faults.push_back(at_outputs(place, "unknown-output",
                                  "\"" + *name + "\" is no export node of the graph" + did_you_mean(*name, known) +
                                      (known.empty() ? "" : "; there is " + list)));
    }
  }
  return faults;
}

const RequestDescription& sweep_description() { return request().description(); }

Result<SweepBody> read_sweep_body(Json body, const Engine& engine) {
  Result<SweepBody> read = request().read(std::move(body), engine);
  if (!read) return read;
  if (read->outputs) {
    if (!read->output.empty()) {
      return at_outputs("", "out-of-range", "output is given as well; one of them goes");
    }
    if (!read->models) return at_outputs("", "out-of-range", "no models are made; leave outputs out, or models");
    if (Problems faults = faults_in_outputs(*read->outputs, *read->graph, engine); !faults.empty()) return faults;
  }
  read->without_output = !read->models;
  read->notes = Json::object();  // no file carries its document
  return read;
}

}  // namespace dini
