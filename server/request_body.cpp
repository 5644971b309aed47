#include "server/request_body.h"

#include <algorithm>
#include <cmath>

#include "graph/nearest.h"
#include "server/text.h"

namespace dini::server {
namespace {

/// A JSON pointer to a member (RFC 6901).
std::string pointer_to(std::string_view name) {
  std::string pointer = "/";
  for (const char c : name) c == '~' ? pointer += "~0" : c == '/' ? pointer += "~1" : pointer += c;
  return pointer;
}

std::string quoted_list(std::initializer_list<std::string_view> names) {
  std::string text;
  for (const std::string_view name : names) text += (text.empty() ? "'" : ", '") + std::string(name) + "'";
  return text;
}

}  // namespace

RequestBody::RequestBody(Json body, std::initializer_list<std::string_view> known) : body_(std::move(body)) {
  if (!body_.is_object()) {
    problems_.add(
        Problem{.code = "type-mismatch", .detail = "The body must be an object with " + quoted_list(known) + "."});
    body_ = Json::object();
    return;
  }
  for (const auto& [name, value] : body_.items()) {
    if (std::ranges::find(known, name) != known.end()) continue;
    problems_.add([&, &unknown = name] {
      const std::string shown = cut(unknown, 64);
      return Problem{.code = "unknown-member",
                     .detail = "There is no member '" + shown + "'" + did_you_mean(shown, {known.begin(), known.end()}),
                     .pointer = pointer_to(shown),
                     .in_request = true};
    });
  }
}

Json RequestBody::object(std::string_view name, bool required) {
  const Json* value = find(name, required);
  if (value == nullptr) return Json::object();
  if (!value->is_object()) wrong_type(name, "an object");
  return *value;
}

std::string RequestBody::text(std::string_view name, bool required) {
  const Json* value = find(name, required);
  if (value == nullptr) return {};
  if (const auto* text = value->get_ptr<const std::string*>()) return *text;
  wrong_type(name, "text");
  return {};
}

std::string RequestBody::choice(std::string_view name, std::initializer_list<std::string_view> choices) {
  if (find(name, false) == nullptr) return std::string(*choices.begin());
  std::string value = text(name, false);
  if (body_.at(std::string(name)).is_string() && std::ranges::find(choices, value) == choices.end()) {
    problems_.add(Problem{.code = "not-in-choices",
                          .detail = "'" + cut(value, 64) + "' is none of " + quoted_list(choices) + ".",
                          .pointer = pointer_to(name),
                          .in_request = true});
  }
  return value;
}

bool RequestBody::boolean(std::string_view name) {
  const Json* value = find(name, false);
  if (value == nullptr) return false;
  if (const auto* boolean = value->get_ptr<const bool*>()) return *boolean;
  wrong_type(name, "true or false");
  return false;
}

std::optional<std::int64_t> RequestBody::integer(std::string_view name) {
  const Json* value = find(name, false);
  if (value == nullptr) return std::nullopt;
  const double number = value->is_number() ? value->get<double>() : 0.5;
  if (number != std::floor(number)) {
    wrong_type(name, "a whole number");
    return std::nullopt;
  }
  // What lies beyond is out of any range as well.
  constexpr double largest = 9007199254740992;
  return static_cast<std::int64_t>(std::clamp(number, -largest, largest));
}

std::optional<std::int64_t> RequestBody::positive_integer(std::string_view name) {
  const std::optional<std::int64_t> value = integer(name);
  if (!value || *value >= 1) return value;
  problems_.add(Problem{.code = "out-of-range",
                        .detail = "'" + std::string(name) + "' must be at least 1.",
                        .pointer = pointer_to(name),
                        .in_request = true});
  return std::nullopt;
}

std::vector<std::string> RequestBody::texts(std::string_view name) {
  const Json* value = find(name, false);
  if (value == nullptr) return {};
  if (!value->is_array() || !std::ranges::all_of(*value, [](const Json& item) { return item.is_string(); })) {
    wrong_type(name, "a list of texts");
    return {};
  }
  return value->get<std::vector<std::string>>();
}

const Json* RequestBody::find(std::string_view name, bool required) {
  const auto found = body_.find(std::string(name));
  if (found != body_.end()) return &*found;
  if (required) {
    problems_.add(Problem{.code = "required-input-missing",
                          .detail = "The body needs a member '" + std::string(name) + "'.",
                          .pointer = pointer_to(name),
                          .in_request = true});
  }
  return nullptr;
}

void RequestBody::wrong_type(std::string_view name, std::string_view expected) {
  problems_.add(Problem{.code = "type-mismatch",
                        .detail = "'" + std::string(name) + "' must be " + std::string(expected) + ".",
                        .pointer = pointer_to(name),
                        .in_request = true});
}

}  // namespace dini::server
