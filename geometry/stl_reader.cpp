#include "geometry/stl_reader.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>

#include "geometry/counted.h"
#include "geometry/face_builder.h"
#include "geometry/key_numbers.h"
#include "geometry/raw_mesh.h"
#include "geometry/text_reader.h"

namespace dini {

namespace {

constexpr std::size_t count_at = 80;  ///< where a binary file has its number of triangles
constexpr std::size_t head_bytes = 84;
constexpr std::size_t triangle_bytes = 50;

std::uint32_t whole_at(std::string_view bytes, std::size_t at) {
  std::uint32_t value = 0;
  for (std::size_t k = 4; k-- > 0;) value = value << 8 | static_cast<unsigned char>(bytes[at + k]);
  return value;
}

double real_at(std::string_view bytes, std::size_t at) {
  return static_cast<double>(std::bit_cast<float>(whole_at(bytes, at)));
}

std::size_t told_size(std::string_view bytes) {
  return head_bytes + triangle_bytes * std::size_t{whole_at(bytes, count_at)};
}

/// The first word is the same in capitals.
bool begins_with_solid(std::string_view text) {
  const std::string_view word = take_word(text);
  return std::ranges::equal(word, std::string_view("solid"), [](char a, char b) { return (a | 0x20) == b; });
}

/// Text has no byte that no text has.
bool is_text(std::string_view bytes) {
  return std::none_of(bytes.begin(), bytes.end(), [](char c) { return c >= 0 && c < '\t'; });
}

bool is_binary(std::string_view bytes) {
  return bytes.size() >= head_bytes && (bytes.size() == told_size(bytes) || !is_text(bytes));
}

/// The mesh as it grows, triangle by triangle.
class StlMesh {
 public:
  explicit StlMesh(const ImportLimits& limits) : limits_(limits) {}

  /// `place` says where a triangle stands that is left out.
  template <class Place>
  void add(const std::array<Vector, 3>& corners, const Place& place) {
    if (!faces_.takes(corners, place)) return;
    std::array<std::uint32_t, 3> vertices{};
    for (std::size_t k = 0; k < 3; ++k) vertices[k] = vertex_at(corners[k]);
    faces_.add(vertices, corners, raw_);
  }

  void warn(std::string sentence) { raw_.warnings.push_back(std::move(sentence)); }

  std::optional<ImportError> error() const {
    if (raw_.triangles.size() > limits_.triangles) return too_many(limits_.triangles, "triangles");
    return std::nullopt;
  }

  ImportResult finish(const Cancel& cancel) && {
    faces_.warn(raw_.warnings);
    return finish_import(std::move(raw_), MeshFormat::stl, limits_, cancel);
  }

 private:
  std::uint32_t vertex_at(const Vector& place) {
    KeyNumbers<6>::Key key{};
    std::size_t part = 0;
    for (const double coordinate : {place.x, place.y, place.z}) {
      const auto bits = std::bit_cast<std::uint64_t>(coordinate == 0 ? 0.0 : coordinate);  // -0 is 0
      key[part++] = static_cast<std::uint32_t>(bits);
      key[part++] = static_cast<std::uint32_t>(bits >> 32);
    }
    const auto [number, fresh] = vertices_.number_of(key);
    if (fresh) raw_.positions.push_back(place);
    return number;
  }

  const ImportLimits& limits_;
  RawMesh raw_;
  FaceBuilder faces_;
  KeyNumbers<6> vertices_;
};

ImportResult read_binary(std::string_view bytes, const ImportLimits& limits, const Cancel& cancel) {
  const std::size_t count = whole_at(bytes, count_at);
  if (bytes.size() < told_size(bytes)) {
    return invalid_file("it is cut short: " + std::to_string(count) + " triangles need " +
                        std::to_string(told_size(bytes)) + " bytes, the file has " + std::to_string(bytes.size()));
  }
  if (count > limits.triangles) return too_many(limits.triangles, "triangles");
  StlMesh mesh(limits);
  CancelEvery steps(cancel);
  std::size_t colored = 0;
  for (std::size_t i = 0; i < count; ++i) {
    if (steps.stopped()) return stopped_reading();
    const std::size_t begin = head_bytes + triangle_bytes * i;
    std::array<Vector, 3> corners{};
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t at = begin + 12 * (k + 1);  // behind the normal
      corners[k] = {real_at(bytes, at), real_at(bytes, at + 4), real_at(bytes, at + 8)};
    }
    colored += bytes[begin + 48] != 0 || bytes[begin + 49] != 0 ? 1 : 0;
    mesh.add(corners, [&] { return "byte " + std::to_string(begin); });
  }
  if (colored > 0) {
    mesh.warn(counted(colored, "triangle has a color or other attribute that is",
                      "triangles have colors or other attributes that are") +
              " left out");
  }
  if (const std::size_t rest = bytes.size() - told_size(bytes); rest > 0) {
    mesh.warn(counted(rest, "byte", "bytes") + " behind the last triangle " + (rest == 1 ? "is" : "are") + " left out");
  }
  return std::move(mesh).finish(cancel);
}

class TextReader {
 public:
  TextReader(std::string_view text, const ImportLimits& limits, const Cancel& cancel)
      : lines_(text), mesh_(limits), cancel_(cancel), steps_(cancel) {}

  ImportResult read() {
    while (const auto line = lines_.next()) {
      if (steps_.stopped()) return stopped_reading();
      if (auto error = read_line(*line)) return *std::move(error);
      if (auto error = mesh_.error()) return *std::move(error);
    }
    if (inside_) return fail("the file ends within a facet");
    return std::move(mesh_).finish(cancel_);
  }

 private:
  ImportError fail(const std::string& what) const {
    return invalid_file("line " + std::to_string(lines_.number()) + ": " + what);
  }

  /// Keywords lead each line; names behind "solid" may be anything, and normals are not taken.
  std::optional<ImportError> read_line(std::string_view line) {
    std::string keyword(take_word(line));
    for (char& c : keyword) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    if (keyword == "vertex") return read_vertex(line);
    if (keyword == "facet") return begin_facet();
    if (keyword == "endfacet") return end_facet();
    const bool known = keyword.empty() || keyword == "solid" || keyword == "endsolid" || keyword == "outer" ||
                       keyword == "endloop" || keyword == "color";
    if (!known) return fail(in_quotes(keyword) + " is no word of an STL");
    return std::nullopt;
  }

  std::optional<ImportError> begin_facet() {
    if (inside_) return fail("a facet begins within a facet");
    inside_ = true;
    count_ = 0;
    return std::nullopt;
  }

  std::optional<ImportError> read_vertex(std::string_view line) {
    if (!inside_) return fail("a vertex stands outside of a facet");
    if (count_ == corners_.size()) return fail("a facet has more than three vertices");
    std::array<double, 3> numbers{};
    for (double& number : numbers) {
      const std::string_view word = take_word(line);
      const std::optional<double> read = real_from(word);
      if (!read)
        return fail(word.empty() ? "a vertex has fewer than three numbers" : in_quotes(word) + " is no number");
      number = *read;
    }
    if (!take_word(line).empty()) return fail("a vertex has more than three numbers");
    corners_[count_++] = {numbers[0], numbers[1], numbers[2]};
    return std::nullopt;
  }

  std::optional<ImportError> end_facet() {
    if (!inside_ || count_ != corners_.size()) return fail("a facet ends that has no three vertices");
    inside_ = false;
    mesh_.add(corners_, [this] { return "line " + std::to_string(lines_.number()); });
    return std::nullopt;
  }

  LineReader lines_;
  StlMesh mesh_;
  const Cancel& cancel_;
  CancelEvery steps_;
  bool inside_ = false;
  std::array<Vector, 3> corners_{};
  std::size_t count_ = 0;
};

}  // namespace

bool begins_like_stl(std::string_view bytes) {
  if (bytes.size() >= head_bytes && bytes.size() == told_size(bytes)) return true;
  return begins_with_solid(without_byte_order_mark(bytes).substr(0, head_bytes));
}

std::optional<std::string> stl_size_hint(std::string_view bytes) {
  if (bytes.size() < head_bytes) return std::nullopt;
  return "a binary STL of " + std::to_string(whole_at(bytes, count_at)) + " triangles would have " +
         std::to_string(told_size(bytes)) + " bytes, this file has " + std::to_string(bytes.size());
}

ImportResult read_stl(std::string_view bytes, const ImportLimits& limits, const Cancel& cancel) {
  if (is_binary(bytes)) return read_binary(bytes, limits, cancel);
  return TextReader(without_byte_order_mark(bytes), limits, cancel).read();
}

}  // namespace dini
