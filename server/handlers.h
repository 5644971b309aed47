#pragma once

#include "server/routes.h"

namespace dini::server {

/// GET /healthz: the process answers.
Reply health(Call& call);
/// GET /version: the engine and every limit by name.
Reply version(Call& call);
/// GET /v1/nodes: the catalogue.
Reply nodes(Call& call);
/// GET /v1/examples and /v1/examples/{id}.
Reply example_list(Call& call);
Reply example(Call& call);
/// GET /images/examples/{name}: the picture of an example.
Reply example_picture(Call& call);
/// POST /v1/validate: everything that is wrong, without evaluating.
Reply validate(Call& call);
/// POST /v1/inspect: the value on one wire.
Reply inspect(Call& call);
/// POST /v1/evaluate: the model, the report, or both.
Reply evaluate(Call& call);
/// POST /v1/assets: a mesh file for `import`.
Reply add_asset(Call& call);
/// GET anything else: a file of the page.
Reply page_file(Call& call);

/// A body from outside as JSON; the media type must say so, which also keeps foreign web forms out.
Result<Json> read_json(const Call& call);

/// A JSON answer that clients may keep but must ask about; 304 when they have it.
Reply tagged_json(const Call& call, const std::string& body, const std::string& tag);

}  // namespace dini::server
