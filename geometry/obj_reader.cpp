#include "geometry/obj_reader.h"

#include <limits>

#include "geometry/face_builder.h"
#include "geometry/file_colors.h"
#include "geometry/key_numbers.h"
#include "geometry/obj_left_out.h"
#include "geometry/obj_lines.h"

namespace dini {

namespace {

/// What one corner of a face refers to: its position, texture coordinate and normal, the last two of which it may not
/// have.
using Corner = KeyNumbers<3>::Key;

constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

/// Adds a value to an attribute that may have begun with a later vertex than the mesh: those before have `missing`.
template <class Value>
void append(std::vector<Value>& values, std::size_t vertex, const Value& value, const Value& missing) {
  values.resize(vertex, missing);
  values.push_back(value);
}

class ObjReader {
 public:
  ObjReader(std::string_view text, const ImportLimits& limits, const Cancel& cancel)
      : steps_(cancel), lines_(text, steps_), limits_(limits), cancel_(cancel) {}

  ImportResult read() {
    while (const auto statement = lines_.next()) {
      if (!stopped()) read_statement(*statement);
      if (error_) return *std::move(error_);
    }
    const std::size_t count = raw_.positions.size();
    if (!raw_.uvs.empty()) raw_.uvs.resize(count);
    if (!raw_.normals.empty()) raw_.normals.resize(count);
    if (!raw_.colors.empty()) raw_.colors.resize(count, no_file_color);
    make_linear(raw_.colors);
    faces_.warn(raw_.warnings);
    left_out_.warn(raw_.warnings);
    return finish_import(std::move(raw_), MeshFormat::obj, limits_, cancel_);
  }

 private:
  bool stopped() {
    if (!error_ && steps_.stopped()) error_ = stopped_reading();
    return error_.has_value();
  }

  std::string place() const { return "line " + std::to_string(lines_.number()); }

  void fail(const std::string& what) {
    if (!error_) error_ = invalid_file(place() + ": " + what);
  }

  void read_statement(std::string_view statement) {
    const std::string_view keyword = take_word(statement);
    if (keyword.empty()) return;
    if (keyword == "v") {
      read_position(statement);
    } else if (keyword == "vt") {
      const std::vector<double>& numbers = numbers_of(statement, 1, 3);
      if (error_) return;
      uvs_.push_back({numbers[0], numbers.size() > 1 ? 1 - numbers[1] : 1});
      if (numbers.size() == 3 && numbers[2] != 0) left_out_.add_depth();
    } else if (keyword == "vn") {
      const std::vector<double>& numbers = numbers_of(statement, 3, 3);
      if (!error_) normals_.push_back(given_normal({numbers[0], numbers[1], numbers[2]}));
    } else if (keyword == "f" || keyword == "fo") {
      read_face(statement);
    } else {
      left_out_.add(keyword, lines_.number());
    }
  }

  /// The numbers of a statement, at most eight of them.
  const std::vector<double>& numbers_of(std::string_view statement, std::size_t least, std::size_t most) {
    numbers_.clear();
    for (std::string_view word = take_word(statement); !word.empty(); word = take_word(statement)) {
      const auto number = real_from(word);
      if (!number) fail(in_quotes(word) + " is no number");
      if (numbers_.size() == most) fail("there are more than " + std::to_string(most) + " numbers");
      if (error_) return numbers_;
      numbers_.push_back(*number);
    }
    if (numbers_.size() < least) fail("there are fewer than " + std::to_string(least) + " numbers");
    return numbers_;
  }

  /// x y z, and then: nothing; a weight that only free-form curves use; a color; a color with alpha; a weight and those
  /// four. Two numbers mean nothing. Some programs write a weight before a color without alpha, which looks like a
  /// color with alpha and is read as one.
  void read_position(std::string_view statement) {
    const std::vector<double>& numbers = numbers_of(statement, 3, 8);
    if (error_) return;
    const std::size_t count = numbers.size();
    positions_.push_back({numbers[0], numbers[1], numbers[2]});
    if (count == 5 || ((count == 4 || count == 8) && numbers[3] != 1)) left_out_.add_weight();
    if (count >= 6) {
      const std::size_t first = count == 8 ? 4 : 3;
      colors_.resize(positions_.size() - 1, no_file_color);
      colors_.push_back(file_color(numbers[first], numbers[first + 1], numbers[first + 2],
                                   count == 6 ? std::nullopt : std::optional(numbers[first + 3])));
    }
  }

  /// A 1-based index, or one that counts back from the latest when negative, as a 0-based one.
  std::uint32_t index_from(std::string_view word, std::string_view what, std::size_t count) {
    const auto number = whole_from(word);
    const auto size = static_cast<std::int64_t>(count);
    if (!number || *number == 0 || *number > size || *number < -size) {
      fail(in_quotes(word) + " is none of the " + std::to_string(count) + " " + std::string(what) + " before it");
      return 0;
    }
    return static_cast<std::uint32_t>(*number > 0 ? *number - 1 : size + *number);
  }

  Corner corner_from(std::string_view word) {
    const std::size_t first = word.find('/');
    Corner corner = {index_from(word.substr(0, first), "vertices", positions_.size()), none, none};
    if (first == std::string_view::npos) return corner;
    word.remove_prefix(first + 1);
    const std::size_t second = word.find('/');
    const std::string_view uv = word.substr(0, second);
    const std::string_view normal = second == std::string_view::npos ? "" : word.substr(second + 1);
    if (!uv.empty()) corner[1] = index_from(uv, "texture coordinates", uvs_.size());
    if (!normal.empty()) corner[2] = index_from(normal, "normals", normals_.size());
    return corner;
  }

  void read_face(std::string_view statement) {
    corners_.clear();
    places_.clear();
    for (std::string_view word = take_word(statement); !word.empty() && !stopped(); word = take_word(statement)) {
      const Corner corner = corner_from(word);
      if (error_) return;
      corners_.push_back(corner);
      places_.push_back(positions_[corner[0]]);
      // Looked at while the face is read: one line can be the whole file.
      if (raw_.triangles.size() + corners_.size() > limits_.triangles + 2) {
        error_ = too_many(limits_.triangles, "triangles");
      }
    }
    if (error_ || !faces_.takes(places_, [this] { return place(); })) return;
    vertices_.clear();
    for (const Corner& corner : corners_) vertices_.push_back(vertex_of(corner));
    if (raw_.positions.size() > limits_.vertices) {
      error_ = too_many(limits_.vertices, "vertices");
    } else {
      faces_.add(vertices_, places_, raw_);
    }
  }

  std::uint32_t vertex_of(const Corner& corner) {
    const auto [vertex, fresh] = known_.number_of(corner);
    if (!fresh) return vertex;
    const auto [position, uv, normal] = corner;
    raw_.positions.push_back(positions_[position]);
    if (uv != none) append(raw_.uvs, vertex, uvs_[uv], {0, 0});
    if (normal != none) append(raw_.normals, vertex, normals_[normal], {});
    if (position < colors_.size()) append(raw_.colors, vertex, colors_[position], no_file_color);
    return vertex;
  }

  CancelEvery steps_;
  ObjLines lines_;
  const ImportLimits& limits_;
  const Cancel& cancel_;
  std::vector<Vector> positions_, normals_;
  std::vector<std::array<double, 2>> uvs_;
  std::vector<std::array<float, 4>> colors_;  ///< of the first positions; empty while there are none
  KeyNumbers<3> known_;                       ///< corners by their vertex
  RawMesh raw_;
  FaceBuilder faces_;
  ObjLeftOut left_out_;
  std::vector<double> numbers_;
  std::vector<Corner> corners_;  ///< of the face that is being read, with the places and vertices of each
  std::vector<Vector> places_;
  std::vector<std::uint32_t> vertices_;
  std::optional<ImportError> error_;
};

}  // namespace

ImportResult read_obj(std::string_view text, const ImportLimits& limits, const Cancel& cancel) {
  return ObjReader(text, limits, cancel).read();
}

}  // namespace dini
