#include "service/requests/results.h"

#include "service/parts.h"
#include "service/requests/schema.h"

namespace dini {
namespace {

using namespace schema;

Json graph_document() {
  return object(
      {{"format", whole("The format of the document: 1.")},
       {"nodes", map_of(anything("A node: its type, its inputs, and whether it is bypassed."), "The nodes by id.")},
       {"parameters", map_of(anything("A parameter: type, default, bounds, label."), "By name."), true},
       {"meta", anything("Title, description, camera; never read by an evaluation."), true},
       {"ui", anything("Where an editor shows the nodes; never read by an evaluation."), true},
       {"$schema", text("The address of the schema of the document."), true}},
      "A graph document.");
}

Json problem_entry() {
  return object(
      {{"code", text("A stable word that programs look at; each has its page at `/problems/<code>`.")},
       {"detail", text("One sentence with the numbers and what would be accepted.")},
       {"node", text("The node to blame."), true},
       {"port", text("The input or output of that node."), true},
       {"pointer", text("The place in the body of the request (RFC 6901)."), true},
       {"fix", list(anything("An operation."), "A JSON Patch (RFC 6902) of the body that removes the problem."), true}},
      "One thing that is wrong, or worth a warning.");
}

Json axis() {
  return object({{"name", text("Axes of one name are paired.")},
                 {"size", whole("How many values lie along it.")},
                 {"closed", yes_no("Whether the last value is followed by the first.")}},
                "One axis of a family of values.");
}

Json wire() {
  return object({{"type", text("The type of its values: a wire type of the catalogue.")},
                 {"axes", list(reference("Axis"), "The axes that the values run over, the last one fastest.")}},
                "What is known of an output before anything is computed.");
}

Json cost() {
  return object({{"samples", whole("Values on all wires.")},
                 {"vertices", whole("Vertices of all meshes.")},
                 {"triangles", whole("Triangles of all meshes.")},
                 {"bytes", whole("A bound of the memory.")},
                 {"work", whole("Nanoseconds of one processor, about.")}},
                "What was predicted before anything was computed.");
}

Json validation() {
  return object({{"valid", yes_no("Whether nothing is wrong.")},
                 {"errors", list(reference("ProblemEntry"), "Everything that is wrong; root causes only.")},
                 {"blocked", list(text(""), "Nodes that are well but stand behind one that is not.")},
                 {"wires", map_of(reference("Wire"), "By `node.output`, as far as they follow from what is known.")},
                 {"cost", reference("Cost")}},
                "What is known of a graph without evaluating it.");
}

Json inspection() {
  return object({{"type", text("The type of the values: a wire type of the catalogue.")},
                 {"axes", list(reference("Axis"), "The axes that the values run over.")},
                 {"values", list(anything("A number, a point, a circle ...: docs/http.md has the form of each type."),
                                 "All values in one flat list, the last axis fastest.")}},
                "The value on a wire, in full double precision.");
}

Json node_run() {
  return object({{"type", text("The id of its node type.")},
                 {"milliseconds", number("How long it ran.")},
                 {"cached", yes_no("Whether its result was known.")},
                 {"outputs", map_of(reference("Wire"), "By name.")}},
                "What one node did.");
}

Json check_result() {
  return object({{"node", text("The `check` node.")},
                 {"passed", yes_no("Whether it holds; one that does not fails the request.")},
                 {"values", list(anything("A value that was checked."), "All values that were checked.")}},
                "One check that ran.");
}

/// The file of an output, with what else the answer tells of it.
Json model(std::vector<Property> more = {}) {
  std::vector<Property> properties = {
      {"bytes", whole("Of the file.")},
      {"vertices", whole("Of all meshes.")},
      {"triangles", whole("Of all meshes.")},
      {"position_error",
       number("In meters: no point in the file is farther than that from the one that was computed.")},
      {"normal_error", number("In radians, of glTF files: no normal is farther from its original; 0 without any."),
       true},
      {"uv_error", number("Of each texture coordinate, where 1 is the size of a picture, of glTF files."), true},
      {"color_error", number("Of each channel of a color, where 1 is white, of glTF files."), true},
      {"sha256", text("Of the file.")}};
  properties.insert(properties.end(), more.begin(), more.end());
  return object(properties, "The file of the output; there with an output.");
}

Json file_with_address() {
  return model({{"address", text("Where the file can be fetched while there is room for it.")}});
}

/// One part of a model: a mesh, or how many curves or points there are.
Json told_part() {
  return object(
      {{"name", text("Of the part in the file: the node that made it, with its place on every axis, `skin[3,0]`.")},
       {"type",
        word({"mesh", "circle", "point"}, "What it is made of; the members below `count` are those of meshes.")},
       {"count", whole("Of the circles, or of the points."), true},
       {"vertices", whole("Positions that triangles use; those that are equal count once."), true},
       {"triangles", whole("Those with three distinct corners."), true},
       {"area", number("In m^2."), true},
       {"volume", number("In m^3, positive where faces look outward; enclosed only when `watertight`."), true},
       {"watertight", yes_no("Whether each edge has two triangles, which run along it in opposite directions."), true},
       {"boundary_loops", whole("Closed loops of edges with one triangle."), true},
       {"components", whole("Pieces that do not hang together."), true},
       {"self_intersections",
        whole("Pairs of triangles that meet, counted up to " + std::to_string(most_told_intersections) + "."), true},
       {"least_thickness", number("Of the thinnest wall, in meters; 0 where nothing is opposite."), true},
       {"center_of_mass", list(number(""), "Of the solid, in meters."), true},
       {"inertia", list(number(""), "Moments about x, y and z through the center, in m^5: times the density kg m^2."),
        true}},
      "What one part of a model is.");
}

/// What a report and the line of a variant tell alike.
std::vector<Property> outcome(Json model, bool optional) {
  return {
      {"checks", list(reference("CheckResult"), "Every check that ran."), optional},
      {"warnings", list(reference("ProblemEntry"), "What is worth knowing although the request succeeded."), optional},
      {"fingerprint", text("64 hexadecimal digits: the hash of what the output depends on; there with an output."),
       true},
      {"output", text("The `export` node; there with an output."), true},
      {"model", std::move(model), true},
      {"measures",
       map_of(anything("The value of an output without axes, else the list of its values, the last axis fastest."),
              "By the places that were asked for; there when some were."),
       true}};
}

Json report() {
  std::vector<Property> properties = {
      {"engine", text("The version of the engine.")},
      {"etag", text("The tag of the model, with its quotes.")},
      {"quality", word({"draft", "final"}, "What was asked for.")},
      {"milliseconds", map_of(number(""), "By step: prepare, evaluate, encode, parts, preview; 0 for what was known.")},
      {"cost", reference("Cost")},
      {"nodes", map_of(reference("NodeRun"), "Every node by id.")},
      {"parts", list(reference("ToldPart"), "What each part of the model is; there when it was asked for."), true},
      {"preview",
       object({{"bytes", whole("Of the file.")},
               {"nodes", list(text(""), "The nodes that are drawn.")},
               {"sha256", text("Of the file.")}},
              "The file of the preview; there when something is previewed."),
       true}};
  for (Property& property : outcome(model(), false)) properties.push_back(std::move(property));
  return object(properties, "Times, sizes, checks and warnings of an evaluation.");
}

/// One of several outputs of a variant.
Json swept_output() {
  return object({{"status", word({"succeeded", "failed"}, "How the output fared.")},
                 {"errors", list(reference("ProblemEntry"), "Why it failed."), true},
                 {"warnings", list(reference("ProblemEntry"), "What is worth knowing although it succeeded."), true},
                 {"fingerprint", text("64 hexadecimal digits: the hash of what the output depends on."), true},
                 {"model", file_with_address(), true}},
                "One of several outputs of a variant; those that failed stop no other.");
}

Json sweep_line() {
  std::vector<Property> properties = {
      {"index", whole("Of the variant; there unless the sweep was stopped."), true},
      {"parameters", map_of(anything("A value."), "What varies; there unless the sweep was stopped."), true},
      {"status", word({"succeeded", "failed", "stopped"},
                      "How the variant fared; `stopped` is the last line of a sweep that was.")},
      {"errors", list(reference("ProblemEntry"), "Why it failed, or why the sweep was stopped."), true},
      {"next", whole("The first variant that was not told; there when the sweep was stopped."), true}};
  for (Property& property : outcome(file_with_address(), true)) properties.push_back(std::move(property));
  properties.push_back(
      {"outputs", map_of(reference("SweptOutput"), "By name; there when the request lists `outputs`."), true});
  return object(properties, "One line of the answer to a sweep.");
}

Json asset_summary() {
  return object({{"sha256", text("64 hexadecimal digits: what graphs write to mean this file.")},
                 {"bytes", whole("Of the file.")},
                 {"format", word({"obj", "ply", "stl", "glb"}, "Told by its content.")},
                 {"vertices", whole("After seams are split.")},
                 {"triangles", whole("Of the mesh.")},
                 {"warnings", list(text(""), "Sentences about what of the file the mesh has not.")}},
                "What is known of a mesh file.");
}

/// Cards are described by themselves: what is in one beside these depends on the node.
Json card(std::vector<Property> properties, std::string doc) {
  Json schema = object(properties, std::move(doc));
  schema["additionalProperties"] = true;
  return schema;
}

Json node_card() {
  const Json port = card({{"name", text("As documents write it.")},
                          {"title", text("As people read it.")},
                          {"types", list(text(""), "The wire types that it may have.")},
                          {"description", text("One sentence.")}},
                         "An input or output; inputs have defaults, units and ranges too.");
  return card({{"id", text("As documents write it.")},
               {"title", text("As people read it.")},
               {"family", text("The family that it is listed in.")},
               {"synonyms", list(text(""), "Other words, in lower case, that people look for.")},
               {"description", text("One sentence.")},
               {"version", whole("Raised when results change.")},
               {"inputs", list(port, "In the order in which people see them.")},
               {"outputs", list(port, "In the order in which people see them.")}},
              "A node type.");
}

Json catalogue() {
  const Json named = card({{"name", text("")}}, "");
  return object({{"engine", text("The version of the engine.")},
                 {"types", list(named, "The wire types, with color and meaning.")},
                 {"families", list(named, "The families of nodes, in their order.")},
                 {"formats", list(card({{"name", text("")},
                                        {"media_types", list(text(""), "The first is what answers say.")},
                                        {"extension", text("With its period.")},
                                        {"description", text("")}},
                                       "A format that models are written in."),
                                  "The usual one first.")},
                 {"nodes", list(reference("NodeCard"), "Every node type.")}},
                "Everything that a form, a palette or a generator of documentation needs.");
}

Json with_stored_graphs(Json schemas) {
  schemas.update(stored_graph_schemas());
  schemas.update(job_schemas());
  schemas.update(explain_schemas());
  schemas.update(fit_schemas());
  return schemas;
}

}  // namespace

const Json& result_schemas() {
  static const Json schemas = with_stored_graphs({{"Graph", graph_document()},
                                                  {"ProblemEntry", problem_entry()},
                                                  {"Axis", axis()},
                                                  {"Wire", wire()},
                                                  {"Cost", cost()},
                                                  {"Validation", validation()},
                                                  {"Inspection", inspection()},
                                                  {"NodeRun", node_run()},
                                                  {"CheckResult", check_result()},
                                                  {"Report", report()},
                                                  {"SweepLine", sweep_line()},
                                                  {"SweptOutput", swept_output()},
                                                  {"ToldPart", told_part()},
                                                  {"AssetSummary", asset_summary()},
                                                  {"NodeCard", node_card()},
                                                  {"Catalogue", catalogue()}});
  return schemas;
}

}  // namespace dini
