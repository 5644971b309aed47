#include "server/handlers.h"

namespace dini::server {

Reply schema(const Context& context) {
  return static_reply(context.request(), context.application.document_schema, "application/schema+json");
}

}  // namespace dini::server
