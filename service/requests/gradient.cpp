#include "service/requests/fit_request.h"
#include "service/requests/request_type.h"

namespace dini {
namespace {

const RequestType<GradientBody>& request() {
  static const auto declared =
      RequestType<GradientBody>("GradientRequest", "What of a graph changes with which parameters.")
          .graph(
              &GradientRequest::graph,
              "The graph document, or the name of a graph that is kept: `chair`, or `chair@3` for one of its versions.")
          .parameters(&GradientRequest::parameters)
          .member("of", &GradientRequest::of,
                  "Outputs (`node` or `node.output`) of numbers, vectors, points or meshes; of a mesh all vertices.",
                  left_out_means("what the only `export` node writes").example(Json::array({"skin"})))
          .member("by", &GradientRequest::by, "Parameters that are numbers.",
                  left_out_means("all that are numbers").example(Json::array({"reach"})))
          .deadline(&GradientBody::deadline_milliseconds);
  return declared;
}

}  // namespace

const RequestDescription& gradient_description() { return request().description(); }

Result<GradientBody> read_gradient_body(Json body, const Engine& engine) {
  return request().read(std::move(body), engine);
}

}  // namespace dini
