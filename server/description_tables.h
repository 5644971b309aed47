#pragma once

// The declarations as tables to read: docs/http.md and GET /docs show the same ones.

#include <span>
#include <string>
#include <vector>

#include "server/routes.h"

namespace dini::server {

/// Cells are text with `code` between backticks.
struct Table {
  std::vector<std::string> headings;
  std::vector<std::vector<std::string>> rows;
  std::string link_folder = {};  ///< the page of each first cell is in this folder; empty: there is none
};

/// Method, address, and what a route does.
Table routes_table(std::span<const Route> routes);
/// What can be set in the body of a request.
Table members_table(const RequestDescription& request);
/// Path, query and headers; what a client may leave out is said in words.
Table parameters_table(const Operation& operation);
/// What comes back when all is well, by status and media type.
Table answers_table(const Operation& operation);
/// The members of a JSON answer, or of a component of it; no rows for one that has none of its own.
Table schema_table(const Json& schema);
/// The codes that an operation may answer, by status.
Table operation_problems_table(const Route& route, const Operation& operation);
/// Every limit: name, default, unit, what it bounds, and what sets it.
Table limits_table();
/// Every code of a kind.
Table codes_table(ProblemKind kind);
/// Every status of a problem with its codes.
Table statuses_table();
/// The headers of answers.
Table headers_table();

}  // namespace dini::server
