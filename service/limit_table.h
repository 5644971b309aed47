#pragma once

// Limits are declared once: `GET /version`, the flags and environment variables of `dini serve`, and docs/http.md
// follow from these tables. The default of a limit is that of the member that keeps it.

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <variant>

#include "graph/limits.h"

namespace dini {

/// One number that bounds something, kept in a member of Owner.
template <class Owner>
struct Limit {
  std::string_view name;  ///< snake_case
  std::string_view unit;
  std::variant<std::size_t Owner::*, std::chrono::milliseconds Owner::*> member;
  std::string_view doc;  ///< what is bounded, in a few words
  std::uint64_t least = 1;
  std::uint64_t most = std::uint64_t{1} << 40;
  std::string_view zero_means = {};  ///< what the default 0 stands for

  std::uint64_t get(const Owner& owner) const {
    if (const auto* number = std::get_if<std::size_t Owner::*>(&member)) return owner.**number;
    return static_cast<std::uint64_t>((owner.*std::get<std::chrono::milliseconds Owner::*>(member)).count());
  }
  void set(Owner& owner, std::uint64_t value) const {
    if (const auto* number = std::get_if<std::size_t Owner::*>(&member)) {
      owner.** number = value;
    } else {
      owner.*std::get<std::chrono::milliseconds Owner::*>(member) = std::chrono::milliseconds(value);
    }
  }
};

/// The flag of `dini serve` that sets a limit: --body-bytes.
std::string flag_of(std::string_view limit);
/// The environment variable that does: DINI_BODY_BYTES.
std::string variable_of(std::string_view limit);

/// The limits of graphs, evaluations and files.
std::span<const Limit<Limits>> evaluation_limits();

}  // namespace dini
