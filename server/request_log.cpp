#include "server/request_log.h"

#include <array>
#include <cmath>
#include <cstdio>

#include "server/text.h"
#include "service/engine.h"

namespace dini::server {
namespace {

constexpr std::size_t method_bytes = 16;

std::string in_milliseconds(double value) {
  std::array<char, 32> number{};
  std::snprintf(number.data(), number.size(), "%.1f", value);
  return number.data();
}

double to_microseconds(double milliseconds) { return std::round(1000 * milliseconds) / 1000; }

/// What the answer's cache was for it; empty when it has none.
std::string_view cache_of(const Access& access) { return access.status == 304 ? "304" : access.notes.cache; }

}  // namespace

std::string request_text(const Access& access, const Exchange& exchange, std::string_view route) {
  std::string text = escape_controls(access.method, method_bytes) + " " + escape_controls(access.path) + " " +
                     std::to_string(access.status) + " " + in_milliseconds(exchange.milliseconds()) + "ms " +
                     std::to_string(access.bytes) + "B " + exchange.id;
  const auto add = [&](std::string_view name, std::string_view value) {
    if (!value.empty()) text.append(" ").append(name).append("=").append(value);
  };
  add("route", route);
  add("graph", access.notes.graph);
  add("cache", cache_of(access));
  for (const auto& [stage, took] : access.notes.timings) add(stage, in_milliseconds(took));
  add("client", exchange.client);
  add("trace", exchange.trace);
  return text;
}

std::string request_members(const Access& access, const Exchange& exchange, std::string_view route) {
  Json milliseconds = {{"total", to_microseconds(exchange.milliseconds())}};
  for (const auto& [stage, took] : access.notes.timings) milliseconds[stage] = to_microseconds(took);
  Json line = {{"message", "request"},
               {"id", exchange.id},
               {"route", route},
               {"method", escape_controls(access.method, method_bytes)},
               {"path", escape_controls(access.path)},
               {"status", access.status},
               {"bytes", access.bytes},
               {"milliseconds", std::move(milliseconds)}};
  if (!exchange.client.empty()) line["client"] = exchange.client;
  if (!access.notes.graph.empty()) line["graph"] = access.notes.graph;
  if (!cache_of(access).empty()) line["cache"] = cache_of(access);
  if (!exchange.trace.empty()) {
    line["trace"] = exchange.trace;
    line["span"] = exchange.span;
  }
  const std::string object = dump(line);
  return object.substr(1, object.size() - 2);
}

}  // namespace dini::server
