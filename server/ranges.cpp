#include "server/ranges.h"

#include <algorithm>
#include <optional>

#include "server/responses.h"
#include "server/text.h"

namespace dini::server {
namespace {

/// From the first to the last byte, both included.
struct Part {
  std::size_t first = 0;
  std::size_t last = 0;
};

/// What a header asks for: nothing when it is not one part in bytes. The part may lie beyond the end.
std::optional<Part> part_of(std::string_view range, std::size_t size) {
  constexpr std::string_view unit = "bytes=";
  if (!range.starts_with(unit)) return std::nullopt;
  const std::string_view text = trim(range.substr(unit.size()));
  const auto dash = text.find('-');
  if (dash == std::string_view::npos) return std::nullopt;
  const auto first = whole_number(text.substr(0, dash)), last = whole_number(text.substr(dash + 1));
  if (dash == 0) {
    if (!last) return std::nullopt;
    return *last == 0 ? Part{size, size} : Part{size - std::min(size, *last), size - 1};
  }
  if (!first) return std::nullopt;
  if (dash + 1 == text.size()) return Part{*first, size - 1};
  if (!last || *last < *first) return std::nullopt;
  return Part{*first, std::min(*last, size - 1)};
}

}  // namespace

Parameter range_header() {
  return {.place = Parameter::Place::header,
          .name = "Range",
          .doc = "One part of the file, as `bytes=first-last`; several at once are answered with the whole file.",
          .example = "bytes=0-99"};
}

Reply with_range(Reply whole, const Context& context, std::string_view tag) {
  whole.headers.emplace_back("Accept-Ranges", "bytes");
  const std::size_t size = whole.size();
  const std::string_view if_range = context.request().header("If-Range");
  const std::optional<Part> part = part_of(context.request().header("Range"), size);
  if (context.request().method != "GET" || !part || (!if_range.empty() && if_range != tag)) return whole;
  if (part->first >= size) {
    Reply reply = problem_reply(
        Problem{.code = "range-not-satisfiable", .detail = "The file has " + std::to_string(size) + " bytes."},
        context.exchange());
    reply.headers.emplace_back("Content-Range", "bytes */" + std::to_string(size));
    return reply;
  }
  whole.status = 206;
  whole.headers.emplace_back("Content-Range", "bytes " + std::to_string(part->first) + "-" +
                                                  std::to_string(part->last) + "/" + std::to_string(size));
  whole.body = {share(whole.body.front()->substr(part->first, part->last - part->first + 1))};
  return whole;
}

}  // namespace dini::server
