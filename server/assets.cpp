#include <algorithm>
#include <array>

#include "server/computation.h"
#include "server/handlers.h"
#include "server/responses.h"
#include "server/text.h"

namespace dini::server {
namespace {

/// The content tells the format; the type only keeps out what web forms send on their own.
bool is_mesh_type(std::string_view type) {
  constexpr std::array<std::string_view, 8> types = {
      "application/octet-stream", "model/gltf-binary", "model/obj",   "application/x-ply",
      "application/ply",          "model/ply",         "model/x-ply", "text/plain",
  };
  return std::ranges::any_of(types, [&](std::string_view known) { return equal_ignoring_case(known, type); });
}

}  // namespace

Reply add_asset(Call& call) {
  const std::string type = call.header("Content-Type");
  if (!is_mesh_type(trim(std::string_view(type).substr(0, type.find(';'))))) {
    return problem_reply(
        Problem{.code = "unsupported-media-type",
                .detail = "Send the file itself as application/octet-stream, model/gltf-binary, model/obj, "
                          "application/x-ply or text/plain."},
        call.exchange);
  }
  Computation computation(call, std::nullopt);
  const auto pass = computation.enter();
  if (!pass) return problem_reply(pass.problems(), call.exchange);
  const auto added = call.engine().add_asset(call.request.body, "", computation.cancel());
  if (!added) return problem_reply(added.problems(), call.exchange);
  Reply reply = json_reply({{"sha256", added->sha256},
                            {"bytes", added->bytes},
                            {"format", added->format},
                            {"vertices", added->vertices},
                            {"triangles", added->triangles},
                            {"warnings", added->warnings}},
                           201);
  reply.headers.emplace_back("Cache-Control", "no-store");
  return reply;
}

}  // namespace dini::server
