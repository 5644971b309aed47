#pragma once

#include <cassert>
#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

// Where memory runs out, the library leaves a value with a type and without its content, which only its destructor sees
// any more. Its assertion of that invariant would end the program; all others stay.
#define JSON_ASSERT(condition) assert((condition) || std::string_view(#condition).starts_with("m_type != "))
#include <nlohmann/json.hpp>

namespace dini {

/// The standard's allocator under a name of our own, which makes `Json` a type of our own.
template <class T>
struct JsonAllocator : std::allocator<T> {
  template <class Other>
  struct rebind {
    using other = JsonAllocator<Other>;
  };
  JsonAllocator() = default;
  template <class Other>
  JsonAllocator(const JsonAllocator<Other>&) noexcept {}
};

/// JSON, as the library reads and writes it. Nesting is bounded wherever text from outside is read.
using Json =
    nlohmann::basic_json<std::map, std::vector, std::string, bool, std::int64_t, std::uint64_t, double, JsonAllocator>;

}  // namespace dini

namespace nlohmann {

/// Takes a value apart level by level. The library's own way allocates, in a destructor: where memory has run out, that
/// ends the program.
template <>
inline void dini::Json::json_value::destroy(value_t type) {
  const auto end = [](auto* value) {
    using Value = std::remove_pointer_t<decltype(value)>;
    if (value == nullptr) return;
    std::destroy_at(value);
    dini::JsonAllocator<Value>().deallocate(value, 1);
  };
  switch (type) {
    case value_t::object:
      return end(object);
    case value_t::array:
      return end(array);
    case value_t::string:
      return end(string);
    case value_t::binary:
      return end(binary);
    default:
      return;
  }
}

// Compiled once, in json.cpp: nearly every file reads this one, and would make the same functions again.
extern template class basic_json<std::map, std::vector, std::string, bool, std::int64_t, std::uint64_t, double,
                                 dini::JsonAllocator>;
extern template class detail::serializer<dini::Json>;

}  // namespace nlohmann
