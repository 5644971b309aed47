#include "fitting/gradient.h"

#include <array>

#include "server/computing.h"
#include "server/graph_body.h"
#include "server/handlers.h"
#include "server/negotiation.h"
#include "server/responses.h"
#include "service/requests/schema.h"

namespace dini::server {
namespace {

constexpr std::string_view value_type = "application/json";
constexpr std::string_view colored_type = "model/gltf-binary";

Digest key_of(const GradientRequest& request, std::string_view type) {
  DigestBuilder digest;
  digest.text("gradient").text(type).digest(request.graph->hash).text(dump(request.parameters));
  digest.integer(request.of.size());
  for (const std::string& place : request.of) digest.text(place);
  for (const std::string& name : request.by) digest.text(name);
  return digest.finish();
}

Result<SharedBytes> work(const Engine& engine, const GradientRequest& request, bool as_colors, const Job& job) {
  const auto found = fitting::gradient(engine, request, job.cancel);
  if (!found) return found.problems();
  if (!as_colors) return share(dump(to_json(*found)));
  auto file = fitting::colored(*found, job.cancel);
  if (!file) return file.problems();
  return share(*std::move(file));
}

}  // namespace

Operation describe_gradient() {
  return {
      .id = "gradient",
      .group = "Graphs",
      .title = "What changes with which parameters, and how much",
      .doc =
          "Derivatives of outputs by parameters, with their errors. As `model/gltf-binary` the meshes of `of`, each "
          "vertex in the color of how fast it moves with the one parameter of `by`.",
      .parameters = {accept_header("The numbers, or a model in their colors."), supersede_key_header()},
      .request = &gradient_description(),
      .answers = {{.doc = "The derivatives.",
                   .contents = {{.type = std::string(value_type), .schema = schema::reference("Gradient")},
                                {.type = std::string(colored_type)}},
                   .headers = {"Cache-Control"}}},
      .problems = codes_of(ProblemKind::graph, {"not-acceptable"}),
      .computes = true};
}

void gradient(const Context& context) {
  constexpr std::array types = {value_type, colored_type};
  const auto type = accepted_type(context.request().header("Accept"), types);
  if (!type) return reply_problems(context, type.problems());
  auto given = read_graph_body(context);
  if (!given) return reply_problems(context, given.problems());
  auto body = read_gradient_body(std::move(given->json), context.engine());
  if (!body) return reply_problems(context, body.problems());
  const auto deadline = deadline_of(context, body->deadline_milliseconds);
  context.call->note_graph(body->graph->hash);
  const auto request = std::make_shared<const GradientRequest>(*std::move(body));
  const auto memory = fitting::check(context.engine(), *request, Cancel(deadline));
  if (!memory) return reply_problems(context, memory.problems());
  compute<std::string>(
      context, {.key = key_of(*request, *type), .bytes = *memory, .deadline = deadline},
      [&engine = context.engine(), request, as_colors = *type == colored_type](const Job& job) {
        return work(engine, *request, as_colors, job);
      },
      [type = std::string(*type)](const SharedBytes& bytes) {
        return Reply{.type = type, .body = {bytes}, .headers = {{"Cache-Control", "no-store"}}};
      });
}

}  // namespace dini::server
