#include "service/requests/fit_request.h"
#include "service/requests/request_type.h"

namespace dini {
namespace {

const RequestType<FitBody>& request() {
  static const auto declared =
      RequestType<FitBody>("FitRequest", "Which parameters of a graph to change, and what is to come of it.")
          .graph(
              &FitRequest::graph,
              "The graph document, or the name of a graph that is kept: `chair`, or `chair@3` for one of its versions.")
          .member("parameters", &FitRequest::parameters,
                  "Values by parameter: those that do not vary keep them, the others begin there.",
                  left_out_means("their defaults"))
          .member("vary", &FitRequest::vary,
                  "The parameters that may change, all of them numbers: by name `[lowest, highest]`, or `[]` for the "
                  "bounds of the parameter itself.",
                  needed().example({{"reach", Json::array()}}))
          .member("targets", &FitRequest::targets,
                  "By output (`node` or `node.output`) the number that is wanted there, or a list of all its numbers. "
                  "Beside `minimize` they are conditions; else all are met as well as they can be, by least squares of "
                  "what is missing in proportion.",
                  left_out_means("none").example({{"amounts", {0, 0.25, 0.5, 0.75, 1, 1.25, 1.5, 1.75}}}))
          .member("target_mesh", &FitRequest::target_mesh,
                  "The mesh file to be like, by the `sha256` or the name that `POST /v1/assets` answered with.",
                  left_out_means("none"))
          .member("mesh", &FitRequest::mesh, "The output (`node` or `node.output`) that is to be like it.",
                  left_out_means("the one that the only `export` node writes"))
          .member("minimize", &FitRequest::minimize,
                  "Outputs (`node` or `node.output`) whose numbers are to be as small as they can.",
                  left_out_means("none"))
          .member("starts", &FitRequest::starts,
                  "From how many places the search begins: the given one, and the best of others within the bounds.",
                  usually(4).range(1, FitRequest::most_starts))
          .member("evaluations", &FitRequest::evaluations,
                  "How often the graph is evaluated at most, those for derivatives included.",
                  usually(5'000).range(1, FitRequest::most_evaluations))
          .deadline(&FitBody::deadline_milliseconds, "job_milliseconds");
  return declared;
}

}  // namespace

const RequestDescription& fit_description() { return request().description(); }

Result<FitBody> read_fit_body(Json body, const Engine& engine) { return request().read(std::move(body), engine); }

}  // namespace dini
