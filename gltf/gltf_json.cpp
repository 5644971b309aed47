#include "gltf/gltf_json.h"

#include <cmath>
#include <utility>

#include "geometry/text_reader.h"

namespace dini {

namespace {

constexpr std::size_t most_json_bytes = std::size_t{4} << 20;
constexpr std::size_t most_values = 500'000;
constexpr int most_levels = 64;

/// Counts what a parser would build before it builds anything: brackets and commas outside of texts.
void check_size(std::string_view json) {
  if (json.size() > most_json_bytes) refuse_gltf("the JSON has more than 4 MiB");
  std::size_t values = 0;
  int level = 0;
  bool in_text = false;
  for (std::size_t i = 0; i < json.size(); ++i) {
    const char c = json[i];
    if (in_text) {
      if (c == '\\') ++i;
      in_text = c != '"';
      continue;
    }
    in_text = c == '"';
    if (c == ',' || c == '[' || c == '{') ++values;
    if (c == '[' || c == '{') ++level;
    if (c == ']' || c == '}') --level;
    if (level > most_levels) refuse_gltf("the JSON is nested deeper than 64 levels");
    if (values > most_values) refuse_gltf("the JSON has more than 500000 values");
  }
}

/// A whole number from 0, also one that is written as `4.0`.
std::optional<std::size_t> whole(const GltfJson& value) {
  if (value.is_number_unsigned()) return value.get<std::size_t>();
  constexpr double most = 9007199254740992;  // 2^53
  const double number = value.is_number_float() ? value.get<double>() : -1;
  if (!(number >= 0 && number < most) || number != std::trunc(number)) return std::nullopt;
  return static_cast<std::size_t>(number);
}

}  // namespace

void refuse_gltf(std::string detail) { throw GltfRefused{invalid_file(std::move(detail))}; }

GltfJson parse_gltf(std::string_view json) {
  check_size(json);
  GltfJson document = GltfJson::parse(json, nullptr, false);
  if (!document.is_object()) refuse_gltf("its JSON is none, or no object");
  return document;
}

const GltfJson* object_member(const GltfJson& object, const char* name) {
  const auto found = object.find(name);
  return found != object.end() && found->is_object() ? &*found : nullptr;
}

std::optional<std::size_t> whole_number(const GltfJson& object, const char* name) {
  const auto found = object.find(name);
  if (found == object.end()) return std::nullopt;
  const auto number = whole(*found);
  if (!number) refuse_gltf(in_quotes(name) + " must be a whole number from 0");
  return number;
}

std::size_t needed_number(const GltfJson& object, const char* name) {
  const auto number = whole_number(object, name);
  if (!number) refuse_gltf(in_quotes(name) + " is missing");
  return *number;
}

template <std::size_t N>
std::optional<std::array<double, N>> number_list(const GltfJson& object, const char* name) {
  const auto found = object.find(name);
  if (found == object.end()) return std::nullopt;
  std::array<double, N> numbers{};
  for (std::size_t k = 0; k < N; ++k) {
    const bool number = found->is_array() && found->size() == N && (*found)[k].is_number();
    numbers[k] = number ? (*found)[k].template get<double>() : std::nan("");
    if (!std::isfinite(numbers[k])) refuse_gltf(in_quotes(name) + " must be finite numbers");
  }
  return numbers;
}

template std::optional<std::array<double, 3>> number_list<3>(const GltfJson&, const char*);
template std::optional<std::array<double, 4>> number_list<4>(const GltfJson&, const char*);
template std::optional<std::array<double, 16>> number_list<16>(const GltfJson&, const char*);

std::vector<std::size_t> index_list(const GltfJson& object, const char* name) {
  const auto found = object.find(name);
  if (found == object.end()) return {};
  std::vector<std::size_t> indices;
  if (!found->is_array()) refuse_gltf(in_quotes(name) + " must be a list");
  for (const GltfJson& item : *found) {
    const auto index = whole(item);
    if (!index) refuse_gltf(in_quotes(name) + " must hold whole numbers from 0");
    indices.push_back(*index);
  }
  return indices;
}

std::string text_member(const GltfJson& object, const char* name, std::string_view missing) {
  const auto found = object.find(name);
  if (found == object.end()) return std::string(missing);
  if (!found->is_string()) refuse_gltf(in_quotes(name) + " must be a text");
  return found->get<std::string>();
}

bool is_true(const GltfJson& object, const char* name) {
  const auto found = object.find(name);
  return found != object.end() && found->is_boolean() && found->get<bool>();
}

const GltfJson* extension_of(const GltfJson& object, const char* name) {
  const GltfJson* extensions = object_member(object, "extensions");
  return extensions == nullptr ? nullptr : object_member(*extensions, name);
}

}  // namespace dini
