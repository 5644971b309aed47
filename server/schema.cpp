#include "service/requests/schema.h"

#include "server/handlers.h"

namespace dini::server {

Operation describe_schema() {
  return {.id = "documentSchema",
          .group = "Catalogue",
          .title = "The form of the graph document",
          .doc = "The JSON Schema (2020-12) of the graph document, with every node type.",
          .parameters = {if_none_match_header()},
          .answers = {{.doc = "The schema.",
                       .contents = {{.type = "application/schema+json", .schema = schema::anything("A JSON Schema.")}},
                       .headers = {"ETag", "Cache-Control"}},
                      not_modified()}};
}

Reply schema(const Context& context) {
  return static_reply(context.request(), context.application.document_schema, "application/schema+json");
}

}  // namespace dini::server
