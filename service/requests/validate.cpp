#include "service/requests/request_type.h"
#include "service/requests/requests.h"

namespace dini {
namespace {

const RequestType<ValidateBody>& request() {
  static const auto declared =
      RequestType<ValidateBody>("ValidateRequest", "A graph to be checked.")
          .graph(&ValidateBody::graph, "The graph document.")
          .member("parameters", &ValidateBody::parameters, "Values for the parameters of the graph, by name.",
                  left_out_means("their defaults").example({{"reach", 0.5}}))
          .member("deadline_ms", &ValidateBody::deadline_milliseconds,
                  "When the work is stopped, counted from the first byte of the request.",
                  left_out_means("`interactive_milliseconds`, which it never goes past").range(1, {}).unit("ms"));
  return declared;
}

}  // namespace

const RequestDescription& validate_description() { return request().description(); }

Result<ValidateBody> read_validate_body(Json body) { return request().read(std::move(body)); }

}  // namespace dini
