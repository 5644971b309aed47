#include "server/request_body.h"

#include <algorithm>
#include <limits>

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
    problems_.push_back(
        {.code = "type-mismatch", .detail = "The body must be an object with " + quoted_list(known) + "."});
    body_ = Json::object();
    return;
  }
  for (const auto& [name, value] : body_.items()) {
    if (std::ranges::find(known, name) != known.end()) continue;
    const std::string shown = cut(name, 64);
    problems_.push_back(
        {.code = "unknown-member",
         .detail = "There is no member '" + shown + "'" + did_you_mean(shown, {known.begin(), known.end()}),
         .pointer = pointer_to(shown)});
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
    problems_.push_back({.code = "not-in-choices",
                         .detail = "'" + cut(value, 64) + "' is none of " + quoted_list(choices) + ".",
                         .pointer = pointer_to(name)});
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

std::optional<std::int64_t> RequestBody::positive_integer(std::string_view name) {
  const Json* value = find(name, false);
  if (value == nullptr) return std::nullopt;
  if (!value->is_number_integer()) {
    wrong_type(name, "a whole number");
    return std::nullopt;
  }
  constexpr auto largest = std::numeric_limits<std::int64_t>::max();
  const bool positive = value->is_number_unsigned() && value->get<std::uint64_t>() > 0;
  if (!positive || value->get<std::uint64_t>() > static_cast<std::uint64_t>(largest)) {
    problems_.push_back({.code = "out-of-range",
                         .detail = "'" + std::string(name) + "' must be at least 1.",
                         .pointer = pointer_to(name)});
    return std::nullopt;
  }
  return static_cast<std::int64_t>(value->get<std::uint64_t>());
}

std::optional<std::int64_t> RequestBody::integer(std::string_view name) {
  const Json* value = find(name, false);
  if (value == nullptr) return std::nullopt;
  constexpr auto largest = std::numeric_limits<std::int64_t>::max();
  if (!value->is_number_integer()) {
    wrong_type(name, "a whole number");
    return std::nullopt;
  }
  if (value->is_number_unsigned() && value->get<std::uint64_t>() > static_cast<std::uint64_t>(largest)) return largest;
  return value->get<std::int64_t>();
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
    problems_.push_back({.code = "required-input-missing",
                         .detail = "The body needs a member '" + std::string(name) + "'.",
                         .pointer = pointer_to(name)});
  }
  return nullptr;
}

void RequestBody::wrong_type(std::string_view name, std::string_view expected) {
  problems_.push_back({.code = "type-mismatch",
                       .detail = "'" + std::string(name) + "' must be " + std::string(expected) + ".",
                       .pointer = pointer_to(name)});
}

}  // namespace dini::server
