#include "server/routes.h"

#include <array>
#include <map>
#include <new>
#include <optional>
#include <set>
#include <spdlog/spdlog.h>

#include "server/access.h"
#include "server/handlers.h"
#include "server/query.h"
#include "server/responses.h"
#include "server/text.h"
#include "server/wrong_tokens.h"

namespace dini::server {
namespace {

std::size_t graph_body(const Limits& limits) { return limits.body_bytes; }
std::size_t file_body(const Limits& limits) { return limits.asset_bytes; }

constexpr std::array all_routes = {
    Route{"GET", "/", page_file, describe_page},
    Route{"GET", "/healthz", health, describe_health},
    Route{"GET", "/readyz", ready, describe_ready},
    Route{"GET", "/metrics", metrics, describe_metrics},
    Route{"GET", "/version", version, describe_version},
    Route{"GET", "/openapi.json", openapi, describe_openapi},
    Route{"GET", "/docs", docs, describe_docs},
    Route{"GET", "/docs/style.css", docs_style, describe_docs_style},
    Route{"GET", "/problems/{code}", problem_page, describe_problem_page},
    Route{"GET", "/v1/nodes", nodes, describe_nodes},
    Route{"GET", "/schema/graph-1.json", schema, describe_schema},
    Route{"GET", "/v1/examples", example_list, describe_example_list},
    Route{"GET", "/v1/examples/{id}", example, describe_example},
    Route{"GET", "/images/examples/{name}", example_picture, describe_example_picture},
    Route{"POST", "/v1/evaluate", evaluate, describe_evaluate, graph_body},
    Route{"POST", "/v1/validate", validate, describe_validate, graph_body},
    Route{"POST", "/v1/explain", explain, describe_explain, graph_body},
    Route{"POST", "/v1/inspect", inspect, describe_inspect, graph_body},
    Route{"POST", "/v1/gradient", gradient, describe_gradient, graph_body},
    Route{"POST", "/v1/fit", create_fit, describe_create_fit, graph_body},
    Route{"POST", "/v1/sweeps", sweep, describe_sweep, graph_body},
    Route{"POST", "/v1/jobs", create_job, describe_create_job, graph_body},
    Route{"GET", "/v1/jobs/{id}", get_job, describe_get_job},
    Route{"GET", "/v1/jobs/{id}/events", job_events, describe_job_events},
    Route{"POST", "/v1/jobs/{id}/cancel", cancel_job, describe_cancel_job},
    Route{"GET", "/v1/jobs/{id}/result", job_result, describe_job_result},
    Route{"GET", "/v1/graphs", graph_list, describe_graph_list},
    Route{"GET", "/v1/graphs/{id}", get_graph, describe_get_graph},
    Route{"PUT", "/v1/graphs/{id}", put_graph, describe_put_graph, graph_body},
    Route{"DELETE", "/v1/graphs/{id}", delete_graph, describe_delete_graph},
    Route{"GET", "/v1/graphs/{id}/versions", graph_versions, describe_graph_versions},
    Route{"GET", "/v1/graphs/{id}/diff", graph_difference, describe_graph_difference},
    Route{"GET", "/v1/graphs/{id}/interface", graph_interface, describe_graph_interface},
    Route{"GET", "/v1/graphs/{id}/outputs/{output}", graph_output, describe_graph_output},
    Route{"GET", "/embed/{id}", embed_page, describe_embed_page},
    Route{"GET", "/v1/artifacts/{sha256}", artifact, describe_artifact},
    Route{"POST", "/v1/assets", add_asset, describe_add_asset, file_body},
    Route{"GET", "/v1/assets/{sha256}", asset, describe_asset},
};

bool reads(std::string_view method) { return method == "GET" || method == "HEAD"; }

/// What the braces of a path stand for; nothing when an address is not the route's.
std::optional<std::vector<std::string>> matched(std::string_view pattern, std::string_view path) {
  std::vector<std::string> arguments;
  const auto take_segment = [](std::string_view& rest) {
    const auto end = rest.find('/', 1);
    const std::string_view segment = rest.substr(0, end);
    rest.remove_prefix(segment.size());
    return segment;
  };
  while (!pattern.empty() && !path.empty()) {
    const std::string_view wanted = take_segment(pattern), given = take_segment(path);
    if (wanted.starts_with("/{") && given.size() > 1) {
      arguments.emplace_back(given.substr(1));
    } else if (wanted != given) {
      return std::nullopt;
    }
  }
  if (!pattern.empty() || !path.empty()) return std::nullopt;
  return arguments;
}

/// The route of a request, or the methods that its address takes; both empty for an address that is none.
struct Found {
  const Route* route = nullptr;
  std::vector<std::string> arguments = {};
  std::string allowed = {};
};

Found find_route(const Application& application, const Request& request) {
  Found found;
  for (const Route& route : all_routes) {
    auto arguments = matched(route.path, request.path);
    if (!arguments) continue;
    if (route.method == request.method || (route.method == "GET" && request.method == "HEAD")) {
      return {&route, *std::move(arguments), {}};
    }
    found.allowed +=
        (found.allowed.empty() ? "" : ", ") + std::string(route.method == "GET" ? "GET, HEAD" : route.method);
  }
  if (found.allowed.empty() && application.page.find(request.path) != nullptr) found.allowed = "GET, HEAD";
  if (!found.allowed.empty()) found.allowed += ", OPTIONS";
  return found;
}

/// The names that the query of a route may have; null when it may have any.
const std::vector<std::string>* declared_query(const Route& route) {
  static const auto declared = [] {
    std::map<const Route*, std::vector<std::string>> names;
    for (const Route& each : all_routes) {
      const Operation operation = each.describe();
      if (!operation.takes_any_query) names.emplace(&each, query_names(operation.parameters));
    }
    return names;
  }();
  const auto found = declared.find(&route);
  return found != declared.end() ? &found->second : nullptr;
}

/// What is wrong with the names in the query of a request.
std::optional<Problem> wrong_query(const Route& route, const Request& request) {
  if (request.query.empty()) return std::nullopt;
  const auto* names = declared_query(route);
  if (names == nullptr) return std::nullopt;
  const auto read = read_query(request, *names);
  if (read) return std::nullopt;
  return read.problems().front();
}

/// What the address takes, and for a page of another origin what it may send there. No request is ever refused for the
/// headers that are listed.
Reply options_reply(const std::string& allowed, const Exchange& exchange) {
  Reply reply{.status = 204, .headers = {{"Allow", allowed}, {"Cache-Control", "no-store"}}};
  if (exchange.shared_with.empty()) return reply;
  reply.headers.emplace_back("Access-Control-Allow-Methods", allowed);
  reply.headers.emplace_back("Access-Control-Allow-Headers",
                             "Accept, Authorization, Content-Type, Idempotency-Key, If-Match, If-None-Match, "
                             "If-Range, Last-Event-ID, Prefer, Range, Supersede, Supersede-Key, traceparent, "
                             "X-Request-Id");
  reply.headers.emplace_back("Access-Control-Max-Age", "600");
  return reply;
}

/// Every method that some address takes.
std::string all_methods() {
  std::set<std::string_view> methods = {"HEAD", "OPTIONS"};
  for (const Route& route : all_routes) methods.insert(route.method);
  std::string list;
  for (const std::string_view method : methods) list.append(list.empty() ? "" : ", ").append(method);
  return list;
}

/// Text as it is written in the path of an address.
std::string encoded_path(std::string_view path) {
  constexpr std::string_view hexadecimal = "0123456789ABCDEF";
  std::string text;
  for (const char c : path) {
    const auto byte = static_cast<unsigned char>(c);
    const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
                       std::string_view("/-._~@").find(c) != std::string_view::npos;
    if (plain) {
      text += c;
    } else {
      text.append("%").append(1, hexadecimal[byte >> 4]).append(1, hexadecimal[byte & 15]);
    }
  }
  return text;
}

/// The address that is meant by one that is none: with a slash too many, or the base path without its own. Only what
/// is known here is ever answered, so that nobody is sent elsewhere.
std::optional<std::string> meant_address(const Application& application, const Request& request) {
  std::string path = request.path;
  if (path.empty()) {
    path = "/";
  } else if (path.size() > 1 && path.ends_with('/')) {
    path.pop_back();
    Request meant;
    meant.method = request.method;
    meant.path = path;
    const Found found = find_route(application, meant);
    if (found.route == nullptr && found.allowed.empty()) return std::nullopt;
  } else {
    return std::nullopt;
  }
  std::string address = application.settings.base_path + encoded_path(path);
  if (!request.query.empty()) address += "?" + request.query;
  return address;
}

Reply no_route(const Application& application, const Request& request, const Found& found, const Exchange& exchange) {
  if (auto address = meant_address(application, request)) {
    return {.status = 308, .headers = {{"Location", *std::move(address)}, {"Cache-Control", "no-store"}}};
  }
  if (found.allowed.empty()) {
    return problem_reply(Problem{.code = "not-found", .detail = "There is no such address."}, exchange);
  }
  Reply reply = problem_reply(
      Problem{.code = "method-not-allowed", .detail = "This address takes " + found.allowed + " only."}, exchange);
  reply.headers.emplace_back("Allow", found.allowed);
  return reply;
}

}  // namespace

std::span<const Route> routes() { return all_routes; }

std::string_view pattern_of(const Application& application, std::string_view method, std::string_view path) {
  std::string_view of_address;
  for (const Route& route : all_routes) {
    if (!matched(route.path, path)) continue;
    if (route.method == method || (route.method == "GET" && method == "HEAD")) return route.path;
    of_address = route.path;
  }
  if (!of_address.empty()) return of_address;
  return application.page.find(std::string(path)) != nullptr ? "page" : "other";
}

namespace {

/// What a request is told that lacks the right token, or after too many wrong ones of its address when it may try
/// again.
Reply refuse_stranger(const Application& application, const Request& request, Problem problem,
                      const Exchange& exchange) {
  const auto now = WrongTokens::Clock::now();
  const auto wait =
      carries_token(request) ? application.wrong_tokens.count(Address::parse(exchange.client), now) : std::nullopt;
  if (!wait) return problem_reply(std::move(problem), exchange);
  const std::string seconds = std::to_string(std::chrono::ceil<std::chrono::seconds>(*wait).count());
  Reply reply = problem_reply(Problem{.code = "too-many-wrong-tokens",
                                      .detail = "At most " + std::to_string(application.settings.wrong_tokens) +
                                                " wrong tokens a minute are looked at from one address; try again in " +
                                                seconds + " s, or send the token of this server."},
                              exchange);
  reply.headers.emplace_back("Retry-After", seconds);
  return reply;
}

}  // namespace

std::variant<std::size_t, Reply> admit(const Application& application, const RequestHead& head,
                                       const Exchange& exchange) {
  if (auto problem = check_access(head.request, application.settings)) {
    if (problem->code == "unauthorized") {
      return refuse_stranger(application, head.request, *std::move(problem), exchange);
    }
    return problem_reply(*std::move(problem), exchange);
  }
  // Without a body nothing is won by refusing early.
  if (head.content_length == 0 && !head.lacks_length && !head.is_chunked) return std::size_t{0};
  const Found found = find_route(application, head.request);
  if (found.route == nullptr) return no_route(application, head.request, found, exchange);
  if (head.lacks_length && found.route->body_limit != nullptr) {
    return problem_reply(
        Problem{.code = "length-required", .detail = "Send Content-Length with the body, or the body in chunks."},
        exchange);
  }
  return found.route->body_limit != nullptr ? found.route->body_limit(application.engine.limits()) : 0;
}

void answer_with(const Context& context, const std::function<std::optional<Reply>()>& step) {
  const auto reply = [&](const Problem& problem) { context.call->reply(problem_reply(problem, context.exchange())); };
  try {
    if (auto made = step()) context.call->reply(*std::move(made));
    return;
  } catch (const std::bad_alloc&) {
    context.application.release_memory();
    return reply({.code = "out-of-memory", .detail = "There is not enough memory for this now."});
  } catch (const std::exception& error) {
    spdlog::error("{} {}", context.exchange().id, escape_controls(error.what()));
  } catch (...) {
    spdlog::error("{} an exception of no known kind", context.exchange().id);
  }
  reply({.code = "internal", .detail = "Something went wrong here; the log has it under this request's id."});
}

void answer(Application& application, const std::shared_ptr<Call>& call) {
  Context context{application, call};
  const Request& request = call->request;
  Found found = find_route(application, request);
  if (found.route == nullptr && reads(request.method) && found.allowed.find("GET") != std::string::npos) {
    return answer_with(context, [&] { return page_file(context); });
  }
  if (request.method == "OPTIONS" && (request.path == "*" || !found.allowed.empty())) {
    return answer_with(
        context, [&] { return options_reply(request.path == "*" ? all_methods() : found.allowed, call->exchange); });
  }
  if (found.route == nullptr) {
    return answer_with(context, [&] { return no_route(application, request, found, call->exchange); });
  }
  if (auto problem = wrong_query(*found.route, request)) {
    return answer_with(context, [&] { return problem_reply(*std::move(problem), call->exchange); });
  }
  context.arguments = std::move(found.arguments);
  if (const auto* instant = std::get_if<InstantHandler>(&found.route->handler)) {
    return answer_with(context, [&] { return (*instant)(context); });
  }
  try {
    std::get<LaterHandler>(found.route->handler)(context);
  } catch (...) {
    answer_with(context, []() -> Reply { throw; });
  }
}

}  // namespace dini::server
