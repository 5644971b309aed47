#include "service/requests/quality.h"
#include "service/requests/request_type.h"
#include "service/requests/requests.h"

namespace dini {

namespace {

const RequestType<EvaluateBody>& request() {
  static const auto declared =
      RequestType<EvaluateBody>("EvaluateRequest",
                                "What to make of a graph: the model of an output, a preview, or both.")
          .graph(
              &EvaluateRequest::graph,
              "The graph document, or the name of a graph that is kept: `chair`, or `chair@3` for one of its versions.")
          .parameters(&EvaluateRequest::parameters)
          .member("output", &EvaluateRequest::output, "The `export` node whose model is asked for.",
                  left_out_means("the only one of the graph, or none beside a preview").example("out"))
          .member("preview", &EvaluateRequest::preview,
                  "Nodes (`node`) or single outputs (`node.output`) to draw into a file of their own, in any order.",
                  left_out_means("none"))
          .member("measures", &EvaluateRequest::measures,
                  "Outputs (`node` or `node.output`) whose values the report tells, in any order.",
                  left_out_means("none"))
          .member("parts", &EvaluateRequest::parts,
                  "Whether the report tells of each part of the model how large it is and whether it is a solid, which "
                  "takes seconds for large models.",
                  usually(false))
          .member("quality", &EvaluateRequest::quality, "A draft is made faster, of fewer triangles.", usually("final"))
          .member("triangle_budget", &EvaluateRequest::triangle_budget,
                  "How many triangles all meshes of a draft have together at most; refused for a final answer.",
                  usually(Detail::usual_triangle_budget)
                      .range(EvaluateRequest::least_triangle_budget, EvaluateRequest::most_triangle_budget)
                      .unit("triangles"))
          .member(
              "draco", &EvaluateRequest::draco,
              "Whether meshes may be compressed with Draco; `false` is for programs that cannot read it, and counts "
              "more than the input `draco` of the `export` node. A preview is compressed always.",
              usually(true))
          .member("embed_graph", &EvaluateRequest::embed_graph,
                  "Whether the file carries the graph document in `asset.extras.document`.", usually(false))
          .deadline(&EvaluateBody::deadline_milliseconds);
  return declared;
}

}  // namespace

const RequestDescription& evaluate_description() { return request().description(); }

Result<EvaluateBody> read_evaluate_body(Json body, const Engine& engine) {
  Result<EvaluateBody> read = request().read(std::move(body), engine);
  if (read && !read->embed_graph) read->notes = Json::object();  // nobody will ask for them
  return read;
}

}  // namespace dini
