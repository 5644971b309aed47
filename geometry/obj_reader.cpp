#include "geometry/obj_reader.h"

#include <unordered_map>

#include "geometry/hash_seed.h"
#include "geometry/polygon.h"
#include "geometry/raw_mesh.h"
#include "geometry/text_reader.h"

namespace dini {

namespace {

/// What one corner of a face refers to; -1 for a texture coordinate or a normal that it does not have.
struct Corner {
  std::int64_t position = -1, uv = -1, normal = -1;

  friend bool operator==(const Corner&, const Corner&) = default;
};

/// Seeded; the order of the table never shows.
struct CornerHash {
  std::size_t operator()(const Corner& corner) const {
    std::uint64_t bits = hash_seed();
    for (const std::int64_t index : {corner.position, corner.uv, corner.normal}) {
      bits = hash_with(bits, static_cast<std::uint64_t>(index));
    }
    return static_cast<std::size_t>(bits);
  }
};

class ObjReader {
 public:
  ObjReader(std::string_view text, const ImportLimits& limits, const Cancel& cancel)
      : lines_(text), limits_(limits), cancel_(cancel), steps_(cancel) {}

  ImportResult read() {
    while (const auto line = next_line()) {
      if (!stopped()) read_line(*line);
      if (error_) return *std::move(error_);
    }
    if (uvs_.empty()) raw_.uvs.clear();
    if (normals_.empty()) raw_.normals.clear();
    if (!any_color_) raw_.colors.clear();
    return finish_import(std::move(raw_), MeshFormat::obj, limits_, cancel_);
  }

 private:
  /// The next line, joined with those after it for as long as one ends with a backslash.
  std::optional<std::string_view> next_line() {
    auto line = lines_.next();
    if (!line || !line->ends_with('\\')) return line;
    joined_.clear();
    while (line && line->ends_with('\\') && !stopped()) {
      joined_.append(line->substr(0, line->size() - 1)) += ' ';
      line = lines_.next();
    }
    if (line) joined_ += *line;
    return joined_;
  }

  bool stopped() {
    if (!error_ && steps_.stopped()) error_ = stopped_reading();
    return error_.has_value();
  }

  void fail(const std::string& what) {
    if (!error_) error_ = invalid_file("line " + std::to_string(lines_.number()) + ": " + what);
  }

  void read_line(std::string_view line) {
    line = line.substr(0, line.find('#'));
    const std::string_view keyword = take_word(line);
    if (keyword == "v") {
      read_position(line);
    } else if (keyword == "vt") {
      const std::vector<double>& numbers = numbers_of(line, 1, 3);
      if (!error_) uvs_.push_back({numbers[0], numbers.size() > 1 ? 1 - numbers[1] : 1});
    } else if (keyword == "vn") {
      const std::vector<double>& numbers = numbers_of(line, 3, 3);
      if (!error_) normals_.push_back({numbers[0], numbers[1], numbers[2]});
    } else if (keyword == "f") {
      read_face(line);
    }
  }

  /// The numbers of a line, at most eight of them.
  const std::vector<double>& numbers_of(std::string_view line, std::size_t least, std::size_t most) {
    numbers_.clear();
    for (std::string_view word = take_word(line); !word.empty(); word = take_word(line)) {
      const auto number = number_from<double>(word);
      if (!number) fail("a number is none, or not finite");
      if (numbers_.size() == most) fail("there are more than " + std::to_string(most) + " numbers");
      if (error_) return numbers_;
      numbers_.push_back(*number);
    }
    if (numbers_.size() < least) fail("there are fewer than " + std::to_string(least) + " numbers");
    return numbers_;
  }

  /// x y z, then nothing, a weight that only free-form curves use, a color, or both.
  void read_position(std::string_view line) {
    const std::vector<double>& numbers = numbers_of(line, 3, 7);
    if (error_) return;
    positions_.push_back({numbers[0], numbers[1], numbers[2]});
    std::array<float, 4> color = {1, 1, 1, 1};
    if (numbers.size() >= 6) {
      any_color_ = true;
      for (std::size_t k = 0; k < 3; ++k) color[k] = linear_color(numbers[numbers.size() - 3 + k]);
    }
    if (any_color_) {
      colors_.resize(positions_.size() - 1, {1, 1, 1, 1});
      colors_.push_back(color);
    }
  }

  /// A 1-based index, or one that counts back from the latest when negative, as a 0-based one.
  std::int64_t index_from(std::string_view word, std::size_t count) {
    const auto number = number_from<std::int64_t>(word);
    const auto size = static_cast<std::int64_t>(count);
    if (!number || *number == 0 || *number > size || *number < -size) {
      fail("an index is none, or leads to nothing that stands before it");
      return 0;
    }
    return *number > 0 ? *number - 1 : size + *number;
  }

  Corner corner_from(std::string_view word) {
    Corner corner;
    const std::size_t first = word.find('/');
    corner.position = index_from(word.substr(0, first), positions_.size());
    if (first == std::string_view::npos) return corner;
    word.remove_prefix(first + 1);
    const std::size_t second = word.find('/');
    const std::string_view uv = word.substr(0, second);
    const std::string_view normal = second == std::string_view::npos ? "" : word.substr(second + 1);
    if (!uv.empty()) corner.uv = index_from(uv, uvs_.size());
    if (!normal.empty()) corner.normal = index_from(normal, normals_.size());
    return corner;
  }

  void read_face(std::string_view line) {
    polygon_.clear();
    corners_.clear();
    for (std::string_view word = take_word(line); !word.empty() && !stopped(); word = take_word(line)) {
      const Corner corner = corner_from(word);
      if (error_) return;
      polygon_.push_back(vertex_of(corner));
      corners_.push_back(positions_[static_cast<std::size_t>(corner.position)]);
      // Looked at while the face is read: one line can be the whole file.
      if (raw_.positions.size() > limits_.vertices) {
        error_ = too_many(limits_.vertices, "vertices");
      } else if (raw_.triangles.size() + polygon_.size() > limits_.triangles + 2) {
        error_ = too_many(limits_.triangles, "triangles");
      }
    }
    if (!error_ && polygon_.size() < 3) fail("a face has fewer than three corners");
    if (error_) return;
    pieces_.clear();
    cutter_.cut(corners_, pieces_);
    for (const auto& [a, b, c] : pieces_) raw_.triangles.push_back({polygon_[a], polygon_[b], polygon_[c]});
  }

  std::uint32_t vertex_of(const Corner& corner) {
    const auto next = static_cast<std::uint32_t>(raw_.positions.size());
    const auto [found, fresh] = vertices_.try_emplace(corner, next);
    if (!fresh) return found->second;
    const auto at = static_cast<std::size_t>(corner.position);
    raw_.positions.push_back(positions_[at]);
    raw_.uvs.push_back(corner.uv < 0 ? std::array<double, 2>{0, 0} : uvs_[static_cast<std::size_t>(corner.uv)]);
    raw_.normals.push_back(corner.normal < 0 ? Vector{} : normals_[static_cast<std::size_t>(corner.normal)]);
    raw_.colors.push_back(at < colors_.size() ? colors_[at] : std::array<float, 4>{1, 1, 1, 1});
    return next;
  }

  LineReader lines_;
  const ImportLimits& limits_;
  const Cancel& cancel_;
  CancelEvery steps_;
  std::string joined_;
  std::vector<Vector> positions_, normals_;
  std::vector<std::array<double, 2>> uvs_;
  std::vector<std::array<float, 4>> colors_;
  bool any_color_ = false;
  std::unordered_map<Corner, std::uint32_t, CornerHash> vertices_;
  RawMesh raw_;
  PolygonCutter cutter_;
  std::vector<double> numbers_;
  std::vector<std::uint32_t> polygon_;
  std::vector<Vector> corners_;
  std::vector<std::array<std::uint32_t, 3>> pieces_;
  std::optional<ImportError> error_;
};

}  // namespace

ImportResult read_obj(std::string_view text, const ImportLimits& limits, const Cancel& cancel) {
  return ObjReader(text, limits, cancel).read();
}

}  // namespace dini
