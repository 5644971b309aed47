#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <string_view>
#include <variant>

#include "server/application.h"
#include "server/operation.h"
#include "server/request_head.h"

namespace dini::server {

/// Answers at once.
using InstantHandler = Reply (*)(const Context& context);
/// Sees to it that the call is answered, now or later, by whatever thread.
using LaterHandler = void (*)(const Context& context);

/// One address and method: everything that is done for a request, and told of it, follows from this. A GET route
/// answers HEAD too.
struct Route {
  std::string_view method;
  std::string_view path;  ///< segments in braces stand for any one segment
  std::variant<InstantHandler, LaterHandler> handler;
  Operation (*describe)();
  /// How long its body may be, by the limits; null when it takes none.
  std::size_t (*body_limit)(const Limits& limits) = nullptr;
};

std::span<const Route> routes();

/// The pattern of the route of a request, for counting: "page" for files of the page, "other" for no address.
std::string_view pattern_of(const Application& application, std::string_view method, std::string_view path);

/// By its head alone: how long the body of a request may be, or the answer if it is refused.
std::variant<std::size_t, Reply> admit(const Application& application, const RequestHead& head,
                                       const Exchange& exchange);

/// Finds the handler and lets it answer. Never throws: what a handler lets escape is our bug and becomes a bare 500.
void answer(Application& application, const std::shared_ptr<Call>& call);

/// Runs a step of answering, which may leave the answer to a later one; whatever escapes becomes an answer.
void answer_with(const Context& context, const std::function<std::optional<Reply>()>& step);

}  // namespace dini::server
