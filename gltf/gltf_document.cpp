#include "gltf/gltf_document.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "gltf/glb_container.h"

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

std::size_t component_size(std::uint64_t type) {
  switch (type) {
    case 5120:  // signed and unsigned bytes
    case 5121:
      return 1;
    case 5122:  // and shorts
    case 5123:
      return 2;
    case 5125:  // unsigned
    case 5126:  // real
      return 4;
    default:
      refuse_gltf("an accessor has an unknown component type");
  }
}

std::size_t width_of(const std::string& type) {
  constexpr std::array<std::string_view, 4> names = {"SCALAR", "VEC2", "VEC3", "VEC4"};
  const auto found = std::find(names.begin(), names.end(), type);
  if (found == names.end()) refuse_gltf("an accessor has an unknown type");
  return static_cast<std::size_t>(found - names.begin()) + 1;
}

double component_at(const char* bytes, std::uint64_t type, bool normalized) {
  std::uint32_t bits = 0;
  for (std::size_t i = component_size(type); i-- > 0;) bits = bits << 8 | static_cast<unsigned char>(bytes[i]);
  switch (type) {
    case 5120:
      return normalized ? std::max(static_cast<std::int8_t>(bits) / 127.0, -1.0) : static_cast<std::int8_t>(bits);
    case 5121:
      return normalized ? bits / 255.0 : bits;
    case 5122:
      return normalized ? std::max(static_cast<std::int16_t>(bits) / 32767.0, -1.0) : static_cast<std::int16_t>(bits);
    case 5123:
      return normalized ? bits / 65535.0 : bits;
    case 5126:
      return static_cast<double>(std::bit_cast<float>(bits));
    default:
      return bits;
  }
}

}  // namespace

void refuse_gltf(std::string detail) { throw GltfRefused{invalid_file(std::move(detail))}; }

std::optional<std::size_t> whole_number(const GltfJson& object, const char* name) {
  const auto found = object.find(name);
  if (found == object.end()) return std::nullopt;
  if (!found->is_number_unsigned()) refuse_gltf("\"" + std::string(name) + "\" must be a whole number from 0");
  return found->get<std::size_t>();
}

std::size_t needed_number(const GltfJson& object, const char* name) {
  const auto number = whole_number(object, name);
  if (!number) refuse_gltf("\"" + std::string(name) + "\" is missing");
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
    if (!std::isfinite(numbers[k])) refuse_gltf("\"" + std::string(name) + "\" must be finite numbers");
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
  if (!found->is_array()) refuse_gltf("\"" + std::string(name) + "\" must be a list");
  for (const GltfJson& item : *found) {
    if (!item.is_number_unsigned()) refuse_gltf("\"" + std::string(name) + "\" must hold whole numbers from 0");
    indices.push_back(item.get<std::size_t>());
  }
  return indices;
}

GltfDocument::GltfDocument(std::string_view glb, const Cancel& cancel) : cancel_(cancel) {
  const auto chunks = split_glb(glb);
  if (!chunks) refuse_gltf("it is no complete GLB of version 2");
  check_size(chunks->json);
  root_ = GltfJson::parse(chunks->json, nullptr, false);
  if (!root_.is_object()) refuse_gltf("its JSON is none");
  binary_ = chunks->binary;
}

std::size_t GltfDocument::count(const char* name) const {
  const auto found = root_.find(name);
  if (found == root_.end()) return 0;
  if (!found->is_array()) refuse_gltf("\"" + std::string(name) + "\" must be a list");
  return found->size();
}

const GltfJson& GltfDocument::entry(const char* name, std::size_t index) const {
  if (index >= count(name)) {
    refuse_gltf("entry " + std::to_string(index) + " of \"" + name + "\" is used, there are " +
                std::to_string(count(name)));
  }
  const GltfJson& found = root_.at(name)[index];
  if (!found.is_object()) refuse_gltf("the entries of \"" + std::string(name) + "\" must be objects");
  return found;
}

std::size_t GltfDocument::accessor_count(std::size_t accessor) const {
  return needed_number(entry("accessors", accessor), "count");
}

GltfDocument::Layout GltfDocument::layout(std::size_t accessor) const {
  const GltfJson& description = entry("accessors", accessor);
  if (description.contains("sparse")) refuse_gltf("sparse accessors are not supported");
  if (!description.contains("bufferView")) refuse_gltf("an accessor has no buffer view");
  Layout found;
  found.count = accessor_count(accessor);
  found.type = needed_number(description, "componentType");
  const auto type = description.find("type");
  found.width = width_of(type != description.end() && type->is_string() ? type->get<std::string>() : "");
  const auto normalized = description.find("normalized");
  found.normalized = normalized != description.end() && normalized->is_boolean() && normalized->get<bool>();
  found.component = component_size(found.type);

  const GltfJson& view = entry("bufferViews", needed_number(description, "bufferView"));
  const GltfJson& buffer = entry("buffers", needed_number(view, "buffer"));
  if (buffer.contains("uri")) refuse_gltf("a buffer has a URI; only the binary chunk of the file itself is read");
  if (needed_number(view, "buffer") != 0) refuse_gltf("a buffer has no data");
  const std::size_t begin = whole_number(view, "byteOffset").value_or(0);
  const std::size_t length = needed_number(view, "byteLength");
  if (begin > binary_.size() || length > binary_.size() - begin) refuse_gltf("a buffer view leads out of its buffer");
  const std::size_t offset = whole_number(description, "byteOffset").value_or(0);
  const std::size_t each = found.width * found.component;
  found.stride = whole_number(view, "byteStride").value_or(each);
  if (found.stride < each || found.stride > 252) refuse_gltf("a buffer view has an impossible stride");
  // All factors are small or compared by division, so nothing wraps around.
  const bool fits = found.count > 0 && offset <= length && length - offset >= each &&
                    found.count - 1 <= (length - offset - each) / found.stride;
  if (!fits) refuse_gltf("an accessor is empty, or leads out of its buffer view");
  found.bytes = binary_.substr(begin + offset, length - offset);
  return found;
}

std::vector<double> GltfDocument::read(const Layout& layout) const {
  std::vector<double> numbers;
  numbers.reserve(layout.count * layout.width);
  CancelEvery steps(cancel_);
  for (std::size_t i = 0; i < layout.count; ++i) {
    if (steps.stopped()) throw GltfRefused{stopped_reading()};
    for (std::size_t k = 0; k < layout.width; ++k) {
      const char* bytes = layout.bytes.data() + i * layout.stride + k * layout.component;
      numbers.push_back(component_at(bytes, layout.type, layout.normalized));
    }
  }
  return numbers;
}

std::vector<double> GltfDocument::numbers(std::size_t accessor, std::size_t width) const {
  const Layout found = layout(accessor);
  if (found.width != width) refuse_gltf("an accessor has the wrong type for its attribute");
  return read(found);
}

std::vector<double> GltfDocument::colors(std::size_t accessor, std::size_t& width) const {
  const Layout found = layout(accessor);
  width = found.width;
  if (width != 3 && width != 4) refuse_gltf("a color has three or four components");
  return read(found);
}

std::vector<std::uint32_t> GltfDocument::indices(std::size_t accessor, std::size_t most) const {
  const Layout found = layout(accessor);
  if (found.count > most) throw GltfRefused{too_many(most, "indices in one piece")};
  if (found.width != 1 || (found.type != 5121 && found.type != 5123 && found.type != 5125)) {
    refuse_gltf("indices must be unsigned whole numbers");
  }
  std::vector<std::uint32_t> indices;
  indices.reserve(found.count);
  for (const double number : read(found)) indices.push_back(static_cast<std::uint32_t>(number));
  return indices;
}

}  // namespace dini
