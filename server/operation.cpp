#include "server/operation.h"

#include <algorithm>
#include <array>
#include <set>

#include "server/access.h"
#include "service/engine.h"

namespace dini::server {
namespace {

constexpr std::array known_headers = {
    AnswerHeader{"ETag", "A hash of everything that can influence the answer; weak (`W/`) for one that holds times."},
    AnswerHeader{"Cache-Control", "How long the answer may be kept, and whether it must be asked about."},
    AnswerHeader{"Content-Disposition", "The name that a file would be saved under."},
    AnswerHeader{"Accept-Ranges", "`bytes`: parts of the file can be asked for."},
    AnswerHeader{"Content-Range", "Which part of how many bytes this is."},
    AnswerHeader{"Location", "The address of what was made."},
    AnswerHeader{"Content-Location", "The address at which this very answer stays."},
    AnswerHeader{"Preference-Applied", "`respond-async`: what was asked for by `Prefer` was done."},
    AnswerHeader{"Vary", "The headers of the request that the answer depends on."},
    AnswerHeader{"Allow", "The methods that the address takes; with 405."},
    AnswerHeader{
        "Retry-After",
        "Seconds to wait before the next try; with 429 and 503, and with 504 when all the time was spent waiting for a "
        "place."},
    AnswerHeader{"WWW-Authenticate", "`Bearer`; with 401."},
    AnswerHeader{"Server-Timing", "Milliseconds of each stage; with every answer."},
    AnswerHeader{"X-Request-Id", "Names the request in the log, and in a problem as `instance`; with every answer."},
};

/// What any request may be answered before its handler sees it.
constexpr std::array<std::string_view, 9> always = {"bad-request",        "request-timeout",     "uri-too-long",
                                                    "expectation-failed", "misdirected-request", "headers-too-large",
                                                    "internal",           "out-of-memory",       "http-version"};
constexpr std::array<std::string_view, 3> with_body = {"length-required", "unsupported-media-type", "busy"};
constexpr std::array<std::string_view, 8> with_json = {"not-json",      "required-input-missing", "unknown-member",
                                                       "type-mismatch", "limit-exceeded",         "more-problems",
                                                       "unknown-graph", "storage-failed"};
constexpr std::array<std::string_view, 5> with_computing = {"superseded", "canceled", "deadline", "busy",
                                                            "shutting-down"};

}  // namespace

std::string_view name_of(Parameter::Place place) {
  switch (place) {
    case Parameter::Place::path:
      return "path";
    case Parameter::Place::query:
      return "query";
    case Parameter::Place::header:
      break;
  }
  return "header";
}

std::span<const AnswerHeader> answer_headers() { return known_headers; }

Parameter accept_header(std::string doc) {
  return {.place = Parameter::Place::header,
          .name = "Accept",
          .doc = std::move(doc),
          .example = usual_formats().front().media_types.front()};
}

Parameter if_none_match_header() {
  return {.place = Parameter::Place::header,
          .name = "If-None-Match",
          .doc = "The `ETag` of an answer that the client has: it is answered 304 when that is still the answer.",
          .example = "\"0123456789abcdef\""};
}

Parameter supersede_key_header() {
  return {.place = Parameter::Place::header,
          .name = "Supersede-Key",
          .doc = "Any word: a newer request with the same one stops this one inside its kernels. For sliders.",
          .example = "slider-1"};
}

Parameter supersede_header() {
  return {
      .place = Parameter::Place::header,
      .name = "Supersede",
      .doc =
          "`after-current`: an older request of the key that runs already is finished, and only those that wait are "
          "replaced, so that a drag that never rests shows frames.",
      .schema = {{"type", "string"}, {"enum", {"after-current"}}},
      .example = "after-current"};
}

Answer not_modified() {
  return {.status = 304, .doc = "The client has this answer already.", .headers = {"ETag", "Cache-Control"}};
}

std::vector<std::string_view> codes_of(ProblemKind kind, const std::vector<std::string_view>& more) {
  std::vector<std::string_view> codes;
  for (const ProblemCode& known : problem_codes()) {
    if (known.kind == kind) codes.push_back(known.code);
  }
  codes.insert(codes.end(), more.begin(), more.end());
  return codes;
}

std::vector<std::string_view> every_problem(const Operation& operation, std::string_view method,
                                            std::string_view path) {
  std::set<std::string_view> may(operation.problems.begin(), operation.problems.end());
  may.insert(always.begin(), always.end());
  if (is_probe(path)) may.erase("misdirected-request");
  if (needs_token(path)) may.insert({"unauthorized", "too-many-wrong-tokens", "foreign-origin"});
  if (method != "GET") may.insert({"foreign-origin", "body-too-large"});
  if (!operation.takes_any_query) may.insert("unknown-member");
  if (operation.has_body()) may.insert(with_body.begin(), with_body.end());
  if (operation.request != nullptr) may.insert(with_json.begin(), with_json.end());
  if (operation.computes) may.insert(with_computing.begin(), with_computing.end());
  std::vector<std::string_view> codes;
  for (const ProblemCode& known : problem_codes()) {
    if (may.contains(known.code)) codes.push_back(known.code);
  }
  return codes;
}

}  // namespace dini::server
