#include "server/negotiation.h"

#include <charconv>

#include "server/text.h"

namespace dini::server {
namespace {

/// How well one media range fits an offer: 0 not, 1 `*/*`, 2 `type/*`, 3 exactly.
int fit(std::string_view range, std::string_view offer) {
  if (equal_ignoring_case(range, offer)) return 3;
  if (range == "*/*") return 1;
  const auto slash = range.find('/');
  const bool any_subtype = slash != std::string_view::npos && range.substr(slash) == "/*";
  return any_subtype && equal_ignoring_case(range.substr(0, slash + 1), offer.substr(0, slash + 1)) ? 2 : 0;
}

/// The `q` among the parameters of a media range; 1 without one, 0 when it is nonsense.
double quality(std::span<const std::string_view> parameters) {
  for (const std::string_view parameter : parameters) {
    if (!parameter.starts_with("q=") && !parameter.starts_with("Q=")) continue;
    double value = 0;
    const auto [end, error] = std::from_chars(parameter.data() + 2, parameter.data() + parameter.size(), value);
    return error == std::errc() && value >= 0 && value <= 1 ? value : 0;
  }
  return 1;
}

}  // namespace

std::optional<std::string_view> choose_type(std::string_view accept, std::span<const std::string_view> offers) {
  if (trim(accept).empty()) return offers.front();
  std::optional<std::string_view> best;
  double best_quality = 0;
  for (const std::string_view offer : offers) {
    int best_fit = 0;
    double offer_quality = 0;
    for (const std::string_view range : split(accept, ',')) {
      const auto parts = split(range, ';');
      const int range_fit = parts.empty() ? 0 : fit(parts.front(), offer);
      if (range_fit <= best_fit) continue;
      best_fit = range_fit;
      offer_quality = quality(std::span(parts).subspan(1));
    }
    if (offer_quality > best_quality) {
      best = offer;
      best_quality = offer_quality;
    }
  }
  return best;
}

Result<std::string_view> accepted_type(std::string_view accept, std::span<const std::string_view> offers) {
  if (const auto type = choose_type(accept, offers)) return *type;
  std::string list;
  for (const std::string_view offer : offers) list.append(list.empty() ? "" : ", ").append(offer);
  return Problem{.code = "not-acceptable", .detail = "Available are " + list + "."};
}

bool accepts_coding(std::string_view accept_encoding, std::string_view coding) {
  bool accepts = false;
  for (const std::string_view range : split(accept_encoding, ',')) {
    const auto parts = split(range, ';');
    if (parts.empty()) continue;
    const bool is_named = equal_ignoring_case(parts.front(), coding);
    if (is_named || parts.front() == "*") accepts = quality(std::span(parts).subspan(1)) > 0;
    if (is_named) return accepts;
  }
  return accepts;
}

bool names_tag(std::string_view if_none_match, std::string_view tag) {
  for (std::string_view candidate : split(if_none_match, ',')) {
    if (candidate.starts_with("W/")) candidate.remove_prefix(2);
    if (candidate == tag || candidate == "*") return true;
  }
  return false;
}

}  // namespace dini::server
