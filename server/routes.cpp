#include "server/routes.h"

#include <array>
#include <new>
#include <spdlog/spdlog.h>
#include <string_view>

#include "server/access.h"
#include "server/handlers.h"
#include "server/responses.h"
#include "server/text.h"

namespace dini::server {
namespace {

struct Route {
  std::string_view method;
  std::string_view path;  ///< a last segment in braces stands for any one segment
  Reply (*handler)(Call&);
};

constexpr std::array routes = {
    Route{"GET", "/healthz", health},
    Route{"GET", "/version", version},
    Route{"GET", "/v1/nodes", nodes},
    Route{"GET", "/v1/examples", example_list},
    Route{"GET", "/v1/examples/{id}", example},
    Route{"POST", "/v1/validate", validate},
    Route{"POST", "/v1/inspect", inspect},
    Route{"POST", "/v1/evaluate", evaluate},
    Route{"GET", "/images/examples/{name}", example_picture},
    Route{"POST", "/v1/assets", add_asset},
};

/// True when the path is the route's; `argument` gets what its braces stand for.
bool matches(std::string_view pattern, std::string_view path, std::string& argument) {
  const auto brace = pattern.find('{');
  if (brace == std::string_view::npos) return pattern == path;
  if (!path.starts_with(pattern.substr(0, brace))) return false;
  const std::string_view rest = path.substr(brace);
  if (rest.empty() || rest.find('/') != std::string_view::npos) return false;
  argument = rest;
  return true;
}

Reply dispatch(Call& call) {
  if (auto problem = check_access(call.request, call.application.settings)) {
    return problem_reply(*std::move(problem), call.exchange);
  }
  const bool reads = call.request.method == "GET" || call.request.method == "HEAD";
  std::string allowed;
  for (const Route& route : routes) {
    if (!matches(route.path, call.request.path, call.argument)) continue;
    if (route.method == call.request.method || (reads && route.method == "GET")) return route.handler(call);
    allowed = route.method == "GET" ? "GET, HEAD" : route.method;
  }
  if (allowed.empty() && reads) return page_file(call);
  if (allowed.empty() && call.application.page.find(call.request.path) != nullptr) allowed = "GET, HEAD";
  if (allowed.empty()) {
    return problem_reply(Problem{.code = "not-found", .detail = "There is no such address."}, call.exchange);
  }
  Reply reply = problem_reply(
      Problem{.code = "method-not-allowed", .detail = "This address takes " + allowed + " only."}, call.exchange);
  reply.headers.emplace_back("Allow", allowed);
  return reply;
}

}  // namespace

std::size_t body_limit(std::string_view method, std::string_view target, const Limits& limits) {
  const bool takes_file = method == "POST" && target.substr(0, target.find('?')) == "/v1/assets";
  return takes_file ? limits.asset_bytes : limits.body_bytes;
}

Reply answer(Application& application, const httplib::Request& request, Exchange& exchange) {
  Call call{application, request, exchange, {}};
  try {
    return dispatch(call);
  } catch (const std::bad_alloc&) {
    return problem_reply(Problem{.code = "out-of-memory", .detail = "There is not enough memory for this now."},
                         exchange);
  } catch (const std::exception& error) {
    spdlog::error("{} {}", exchange.id, escape_controls(error.what()));
  } catch (...) {
    spdlog::error("{} an exception of no known kind", exchange.id);
  }
  return problem_reply(
      Problem{.code = "internal", .detail = "Something went wrong here; the log has it under this request's id."},
      exchange);
}

}  // namespace dini::server
