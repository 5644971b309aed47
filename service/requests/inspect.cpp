#include "service/requests/request_type.h"
#include "service/requests/requests.h"

namespace dini {
namespace {

const RequestType<InspectBody>& request() {
  static const auto declared =
      RequestType<InspectBody>("InspectRequest", "Which wire of a graph to look at.")
          .graph(
              &InspectRequest::graph,
              "The graph document, or the name of a graph that is kept: `chair`, or `chair@3` for one of its versions.")
          .parameters(&InspectRequest::parameters)
          .member("node", &InspectRequest::node, "The node whose output is looked at.", needed().example("boosted"))
          .member("output", &InspectRequest::output, "The output of that node.",
                  left_out_means("its first one").example("shape"))
          .member("full", &InspectRequest::full, "Whether meshes are told with all positions and indices.",
                  usually(false))
          .deadline(&InspectBody::deadline_milliseconds);
  return declared;
}

}  // namespace

const RequestDescription& inspect_description() { return request().description(); }

Result<InspectBody> read_inspect_body(Json body, const Engine& engine) {
  return request().read(std::move(body), engine);
}

}  // namespace dini
