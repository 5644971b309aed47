#pragma once

// The pages that people read in a browser. They are made of the same declarations as the OpenAPI document, without
// scripts: see docs/decisions/0027-docs-without-scripts.md.

#include <span>
#include <string>

#include "server/routes.h"

namespace dini::server {

/// GET /docs: every route with its members, answers and problems, all limits, and all codes.
std::string docs_html(std::span<const Route> routes, const std::string& version);

/// GET /problems/{code}.
std::string problem_page_html(const ProblemCode& code);

/// The style of both, light or dark as the reader's system is.
std::string_view docs_style_sheet();

}  // namespace dini::server
