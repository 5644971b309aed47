#include "service/requests/request_type.h"
#include "service/requests/requests.h"

namespace dini {
namespace {

const RequestType<ValidateBody>& request() {
  static const auto declared =
      RequestType<ValidateBody>("ValidateRequest", "A graph to be checked.")
          .graph(
              &ValidateBody::graph,
              "The graph document, or the name of a graph that is kept: `chair`, or `chair@3` for one of its versions.")
          .parameters(&ValidateBody::parameters)
          .deadline(&ValidateBody::deadline_milliseconds);
  return declared;
}

}  // namespace

const RequestDescription& validate_description() { return request().description(); }

Result<ValidateBody> read_validate_body(Json body, const Engine& engine) {
  return request().read(std::move(body), engine);
}

}  // namespace dini
