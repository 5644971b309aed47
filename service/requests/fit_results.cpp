#include "service/requests/results.h"
#include "service/requests/schema.h"

namespace dini {

Json fit_schemas() {
  using namespace schema;
  const Json parameters = map_of(number(""), "By name.");
  const Json start = object({{"from", parameters},
                             {"failed", yes_no("Whether the graph has nothing there.")},
                             {"parameters", parameters, true},
                             {"objective", number("What it came to."), true}},
                            "One place where the search began.");
  const Json target =
      object({{"wanted", anything("A number, or all of them.")}, {"found", anything("A number, or all of them.")}},
             "A target.");
  const Json derivative = object(
      {{"values", list(anything("A number, or three for a vector, a point or a vertex."),
                       "As the values of the output, the last axis fastest; of meshes all vertices, one after the "
                       "other.")},
       {"error", number("None of the numbers is farther from the true one, as far as differences can tell.")}},
      "How an output grows for a unit of a parameter.");
  return {
      {"Fit",
       object({{"parameters", map_of(number(""), "What was found, by name.")},
               {"objective", number("What is left of what was to be small: the sum of squares, and what was minimized "
                                    "in proportion to where it began.")},
               {"outcome", word({"converged", "evaluations", "deadline", "conditions"},
                                "Why it ended: nothing near is better; the evaluations or the time were over; or "
                                "nothing was found that keeps all targets.")},
               {"targets", map_of(target, "By place.")},
               {"minimized", map_of(number(""), "By place.")},
               {"distance",
                object({{"root_mean_square", number("In meters, both ways together.")},
                        {"largest", number("In meters, among the places that were looked at.")}},
                       "From the mesh; there when one was given."),
                true},
               {"at_bounds", list(text(""), "Parameters that ended at one of their bounds.")},
               {"undetermined",
                list(object({{"parameters", list(text(""), "By name.")}, {"detail", text("One sentence.")}},
                            "Parameters that may have other values as well."),
                     "What the request does not determine.")},
               {"starts", list(start, "Where the search began, and what came of it.")},
               {"evaluations", whole("Of the graph.")}},
              "What a fit found.")},
      {"Gradient", object({{"at", map_of(number(""), "The values of the parameters, by name.")},
                           {"of", map_of(object({{"type", text("The type of the values.")},
                                                 {"by", map_of(derivative, "By parameter.")}},
                                                "One output."),
                                         "By place.")}},
                          "How outputs change with parameters.")}};
}

}  // namespace dini
