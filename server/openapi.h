#pragma once

#include <span>
#include <string>

#include "server/routes.h"

namespace dini::server {

/// The routes as an OpenAPI document (3.1): every method, header, body, status and problem code, with schemas and
/// examples. A GET route has a HEAD operation beside it. All are served below `base`.
Json openapi_document(std::span<const Route> routes, const std::string& version, const std::string& base = "");

}  // namespace dini::server
