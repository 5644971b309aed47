#include "geometry/ply_reader.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "geometry/face_builder.h"
#include "geometry/ply_items.h"
#include "geometry/text_reader.h"
#include "geometry/vertex_splitter.h"

namespace dini {

namespace {

class PlyReader {
 public:
  PlyReader(const PlyHeader& header, std::string_view bytes, const ImportLimits& limits, const Cancel& cancel)
      : header_(header), items_(bytes, header, cancel), limits_(limits), cancel_(cancel) {}

  ImportResult read() {
    for (const PlyElement& element : header_.elements) {
      if (element.name == "vertex") {
        read_vertices(element);
      } else if (element.name == "face") {
        read_faces(element);
      } else if (element.name == "tristrips") {
        read_strips(element);
      } else {
        pass_over(element);
      }
      if (items_.error()) return *items_.error();
    }
    warn(items_.rest());
    if (items_.error()) return *items_.error();
    faces_.warn(raw_.warnings);
    return finish_import(std::move(raw_), MeshFormat::ply, limits_, cancel_);
  }

 private:
  void warn(std::optional<std::string> sentence) {
    if (sentence) raw_.warnings.push_back(*std::move(sentence));
  }

  void pass_over(const PlyElement& element) {
    for (std::size_t i = 0; i < element.count && !items_.error(); ++i) {
      items_.begin();
      for (const PlyProperty& property : element.properties) items_.skip(property);
    }
    if (element.count == 0) return;
    warn(std::to_string(element.count) + " of the element " + in_quotes(element.name) +
         (element.count == 1 ? " is" : " are") + " left out");
  }

  /// One vertex or face; the corners of a face go to `corners_`.
  PlyNumbers read_row(const PlyElement& element, const PlyColumns& columns) {
    PlyNumbers numbers;
    items_.begin();
    for (std::size_t k = 0; k < element.properties.size(); ++k) {
      const PlyProperty& property = element.properties[k];
      if (columns[k] == PlyMeaning::other) {
        items_.skip(property);
      } else if (columns[k] == PlyMeaning::corners) {
        read_corners(property);
      } else {
        numbers[columns[k]] = items_.value(property);
      }
    }
    return numbers;
  }

  void read_vertices(const PlyElement& element) {
    if (!raw_.positions.empty()) return items_.fail("the vertices stand there twice");
    if (element.count > std::numeric_limits<std::uint32_t>::max()) {
      return items_.fail(too_many(limits_.vertices, "vertices"));
    }
    const PlyColumns columns = PlyColumns::of_vertices(element);
    if (!columns.has(PlyMeaning::x)) return items_.fail("the vertices have no x, y and z");
    // The header was checked: the file is long enough for that many.
    raw_.positions.reserve(element.count);
    for (std::size_t i = 0; i < element.count && !items_.error(); ++i) {
      const PlyNumbers row = read_row(element, columns);
      raw_.positions.push_back({row[PlyMeaning::x], row[PlyMeaning::y], row[PlyMeaning::z]});
      if (columns.has(PlyMeaning::nx)) {
        raw_.normals.push_back(given_normal({row[PlyMeaning::nx], row[PlyMeaning::ny], row[PlyMeaning::nz]}));
      }
      if (columns.has(PlyMeaning::u)) raw_.uvs.push_back({row[PlyMeaning::u], 1 - row[PlyMeaning::v]});
      if (columns.has(PlyMeaning::red)) raw_.colors.push_back(columns.color(row));
    }
    make_linear(raw_.colors, columns.full_value(PlyMeaning::red), columns.full_value(PlyMeaning::alpha));
    warn(columns.left_out(element));
  }

  bool can_follow(const PlyElement& element, const PlyColumns& columns) {
    if (raw_.positions.empty()) items_.fail("there are faces before any vertices");
    if (!columns.has(PlyMeaning::corners)) {
      items_.fail(in_quotes(element.name) + " has no list vertex_indices of whole numbers");
    }
    return !items_.error();
  }

  void read_faces(const PlyElement& element) {
    const PlyColumns columns = PlyColumns::of_faces(element, raw_.colors.empty());
    if (!can_follow(element, columns)) return;
    const bool colored = columns.has(PlyMeaning::red);
    VertexSplitter splitter(0, raw_.positions.size());
    std::vector<std::array<float, 4>> colors(colored ? raw_.positions.size() : 0, no_file_color);
    for (std::size_t i = 0; i < element.count && !items_.error(); ++i) {
      const PlyNumbers row = read_row(element, columns);
      if (!find_corners()) continue;
      if (colored) paint(columns.color(row), splitter, colors);
      faces_.add(corners_, places_, raw_);
    }
    if (colored) {
      splitter.append_copies(raw_);
      make_linear(colors, columns.full_value(PlyMeaning::red), columns.full_value(PlyMeaning::alpha));
      raw_.colors = std::move(colors);
    }
    warn(columns.left_out(element));
  }

  /// Gives the vertices of a face its color, or takes copies of those that have another one.
  void paint(const std::array<float, 4>& color, VertexSplitter& splitter, std::vector<std::array<float, 4>>& colors) {
    VertexSplitter::Value value{};
    std::transform(color.begin(), color.end(), value.begin(), [](float c) { return std::bit_cast<std::uint32_t>(c); });
    for (std::uint32_t& corner : corners_) {
      corner = splitter.at(corner, value);
      if (corner >= colors.size()) colors.resize(corner + 1);
      colors[corner] = color;
    }
    if (splitter.copies() > limits_.vertices) items_.fail(too_many(limits_.vertices, "vertices"));
  }

  void read_corners(const PlyProperty& list) {
    corners_.clear();
    const std::size_t count = items_.length(list);
    if (raw_.triangles.size() + count > limits_.triangles + 2) {
      return items_.fail(too_many(limits_.triangles, "triangles"));
    }
    for (std::size_t k = 0; k < count; ++k) {
      const double index = items_.value(list);
      if (items_.error()) return;
      corners_.push_back(vertex_from(index));
    }
  }

  std::uint32_t vertex_from(double index) {
    const std::size_t count = raw_.positions.size();
    if (index >= 0 && index < static_cast<double>(count) && index == std::trunc(index)) {
      return static_cast<std::uint32_t>(index);
    }
    items_.fail("a face uses vertex " + text_of(index) + " of " + std::to_string(count));
    return 0;
  }

  /// Finds the places of the corners; false for a face that is left out.
  bool find_corners() {
    if (items_.error()) return false;
    places_.clear();
    for (const std::uint32_t corner : corners_) places_.push_back(raw_.positions[corner]);
    return is_taken();
  }

  bool is_taken() {
    return faces_.takes(places_, [this] { return items_.place(); });
  }

  void read_strips(const PlyElement& element) {
    const PlyColumns columns = PlyColumns::of_faces(element, false);
    if (!can_follow(element, columns)) return;
    for (std::size_t i = 0; i < element.count && !items_.error(); ++i) {
      items_.begin();
      for (std::size_t k = 0; k < element.properties.size(); ++k) {
        const PlyProperty& property = element.properties[k];
        columns[k] == PlyMeaning::corners ? read_strip(property) : items_.skip(property);
      }
    }
    warn(columns.left_out(element));
  }

  /// Several strips in one list, with -1 between them.
  void read_strip(const PlyProperty& list) {
    const std::size_t count = items_.length(list);
    std::array<std::uint32_t, 3> last{};
    std::size_t length = 0;
    for (std::size_t k = 0; k < count && !items_.error(); ++k) {
      const double index = items_.value(list);
      if (index == -1) {
        end_strip(length);
        length = 0;
        continue;
      }
      last = {last[1], last[2], vertex_from(index)};
      if (++length >= 3 && !items_.error()) add_of_strip(last, length % 2 == 0);
    }
    end_strip(length);
  }

  /// A strip turns over with every triangle; those that use a vertex twice only lead to the next place.
  void add_of_strip(const std::array<std::uint32_t, 3>& triangle, bool turned) {
    const auto [a, b, c] = triangle;
    if (a == b || b == c || c == a) return;
    corners_ = turned ? std::vector<std::uint32_t>{b, a, c} : std::vector<std::uint32_t>{a, b, c};
    if (find_corners()) faces_.add(corners_, places_, raw_);
    if (raw_.triangles.size() > limits_.triangles) items_.fail(too_many(limits_.triangles, "triangles"));
  }

  /// One that is too short for a triangle counts as a face that is.
  void end_strip(std::size_t length) {
    places_.resize(std::min<std::size_t>(length, 2));
    if (length > 0 && length < 3) is_taken();
  }

  const PlyHeader& header_;
  PlyItems items_;
  const ImportLimits& limits_;
  const Cancel& cancel_;
  RawMesh raw_;
  FaceBuilder faces_;
  std::vector<std::uint32_t> corners_;  ///< of the face that is being read, with the place of each
  std::vector<Vector> places_;
};

}  // namespace

ImportResult read_ply(std::string_view bytes, const ImportLimits& limits, const Cancel& cancel) {
  const auto header = read_ply_header(bytes);
  if (!header) return header.error();
  return PlyReader(*header, bytes, limits, cancel).read();
}

}  // namespace dini
