#include "service/requests/results.h"
#include "service/requests/schema.h"

namespace dini {
namespace {

using namespace schema;

Json version() {
  return object({{"id", text("The name of the graph.")},
                 {"version", whole("Counts from 1.")},
                 {"title", text("What the document calls itself in `meta`.")},
                 {"bytes", whole("Of the document.")},
                 {"hash", text("64 hexadecimal digits: of what the graph means, as files and reports say it.")},
                 {"created", text("When the version was kept: RFC 3339, in UTC.")},
                 {"etag", text("The tag of the document, with its quotes: for `If-Match`.")},
                 {"address", text("Where the version can be read.")}},
                "A version of a graph.");
}

/// What came, what went, and what changed in what stayed.
Json difference(const std::string& what) {
  return object(
      {{"added", list(text(""), what + " that the later version has besides.")},
       {"removed", list(text(""), what + " that the later version has no more.")},
       {"changed", map_of(anything("What changed in it, each `from` what it was `to` what it is."), "By name.")}},
      what + ".");
}

}  // namespace

Json stored_graph_schemas() {
  return {{"GraphVersion", version()},
          {"GraphPage", object({{"graphs", list(reference("GraphVersion"), "The current versions, by name.")},
                                {"next", text("For `after`: there when more graphs come after this page."), true}},
                               "A page of the list of graphs.")},
          {"GraphVersions",
           object({{"versions", list(reference("GraphVersion"), "The newest first.")}}, "Every version of a graph.")},
          {"GraphDifference", object({{"from", whole("The number of a version.")},
                                      {"to", whole("The number of a version.")},
                                      {"nodes", difference("Nodes")},
                                      {"parameters", difference("Parameters")},
                                      {"groups", difference("Groups"), true}},
                                     "What differs between two versions.")},
          {"GraphInterface", object({{"id", text("The name of the graph.")},
                                     {"version", whole("That this is of.")},
                                     {"hash", text("Of what the graph means.")},
                                     {"parameters", anything("A JSON Schema of an object: the parameters.")},
                                     {"outputs", list(text(""), "The nodes that make a file.")}},
                                    "What a graph looks like from outside.")}};
}

}  // namespace dini
