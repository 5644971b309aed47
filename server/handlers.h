#pragma once

#include "server/application.h"

namespace dini::server {

/// GET /healthz: the process answers.
Reply health(const Context& context);
/// GET /version: the engine and every limit by name.
Reply version(const Context& context);
/// GET /v1/nodes: the catalogue.
Reply nodes(const Context& context);
/// GET /schema/graph-1.json: the JSON Schema of the graph document.
Reply schema(const Context& context);
/// GET /v1/examples and /v1/examples/{id}.
Reply example_list(const Context& context);
Reply example(const Context& context);
/// GET /images/examples/{name}: the picture of an example.
Reply example_picture(const Context& context);
/// POST /v1/validate: everything that is wrong, without evaluating.
Reply validate(const Context& context);
/// POST /v1/inspect: the value on one wire.
void inspect(const Context& context);
/// POST /v1/evaluate: the model, the report, or both.
void evaluate(const Context& context);
/// POST /v1/assets: a mesh file for `import`.
void add_asset(const Context& context);
/// GET anything else: a file of the page.
Reply page_file(const Context& context);

/// A body from outside as JSON; the media type must say so, which also keeps foreign web forms out.
Result<Json> read_json(const Context& context);

}  // namespace dini::server
