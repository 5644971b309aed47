#pragma once

#include <cstddef>
#include <optional>
#include <type_traits>
#include <utility>

namespace dini {

template <class T>
inline constexpr bool is_std_optional = false;
template <class T>
inline constexpr bool is_std_optional<std::optional<T>> = true;

/// Stands for a value of any type where only types matter; never made. An optional takes what its value takes.
struct AnyValue {
  template <class T>
  requires(!is_std_optional<T>) operator T() const;
};

template <class T, std::size_t... I>
constexpr bool takes_values(std::index_sequence<I...>) {
  return requires { T{(static_cast<void>(I), AnyValue{})...}; };
}

/// How many members an aggregate has; each base counts as one.
template <class T, std::size_t N = 0>
constexpr std::size_t field_count() {
  static_assert(std::is_aggregate_v<T>, "the inputs of a function are an aggregate");
  if constexpr (takes_values<T>(std::make_index_sequence<N + 1>{})) {
    return field_count<T, N + 1>();
  } else {
    return N;
  }
}

}  // namespace dini
