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

}  // namespace

const RequestDescription& sweep_description() { return request().description(); }

Result<SweepBody> read_sweep_body(Json body, const Engine& engine) {
  Result<SweepBody> read = request().read(std::move(body), engine);
  if (!read) return read;
  read->without_output = !read->models;
  read->notes = Json::object();  // no file carries its document
  return read;
}

}  // namespace dini
