#include "service/requests/results.h"
#include "service/requests/schema.h"

namespace dini {

Json explain_schemas() {
  using namespace schema;
  const Json output = object({{"type", text("The type of its values.")},
                              {"axes", list(reference("Axis"), "The axes that the values run over.")},
                              {"vertices", whole("About so many in all meshes on the wire.")},
                              {"most_vertices", whole("Never more than these, also where surfaces are cut.")}},
                             "What an output will hold.");
  const Json reason = object(
      {{"because", word({"new", "parameter", "upstream", "evicted"},
                        "It was never asked for here; a parameter at its inputs changed since the graph was last "
                        "evaluated; what it reads has to run; its result had to make room.")},
       {"name", text("The parameter, or the node that it reads."), true}},
      "Why a node has to run.");
  const Json node =
      object({{"type", text("The type of the node.")},
              {"state",
               word({"runs", "known", "skipped"}, "It has to run; its result is kept; or nothing that runs needs it.")},
              {"outputs", map_of(output, "By name.")},
              {"why", list(reason, "Why it has to run."), true},
              {"bytes", whole("A bound of the memory that it takes."), true},
              {"work", whole("Nanoseconds of one processor that it is predicted to take."), true},
              {"milliseconds", number("The same by what nodes of its type have really taken here."), true}},
             "What an evaluation would do with a node.");
  return {{"Explanation",
           object({{"runs", whole("How many nodes have to run.")},
                   {"known", whole("How many results are kept that the others, or the answer, are made of.")},
                   {"work", whole("Predicted nanoseconds of one processor.")},
                   {"milliseconds", number("The same by what was measured here.")},
                   {"bytes", whole("A bound of the memory; 0 when nothing has to run.")},
                   {"nodes", map_of(node, "By id.")}},
                  "What an evaluation would do.")}};
}

}  // namespace dini
