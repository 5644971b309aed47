#include "geometry/ply_reader.h"

#include <algorithm>
#include <bit>
#include <limits>

#include "geometry/ply_header.h"
#include "geometry/polygon.h"
#include "geometry/raw_mesh.h"
#include "geometry/text_reader.h"

namespace dini {

namespace {

/// The values after the header, one after the other, as doubles, which hold every type exactly.
class ValueReader {
 public:
  ValueReader(std::string_view data, PlyEncoding encoding) : data_(data), encoding_(encoding) {}

  /// Nothing at the end of the file, and for a word that is no number of the type.
  std::optional<double> next(PlyType type) {
    if (encoding_ == PlyEncoding::ascii) {
      const std::string_view word = take_word(data_);
      if (!is_integer(type)) return number_from<double>(word);
      const auto number = number_from<std::int64_t>(word);
      return number ? std::optional<double>(static_cast<double>(*number)) : std::nullopt;
    }
    const std::size_t size = size_of(type);
    if (data_.size() < size) return std::nullopt;
    std::uint64_t bits = 0;
    for (std::size_t i = 0; i < size; ++i) {
      const std::size_t at = encoding_ == PlyEncoding::little_endian ? size - 1 - i : i;
      bits = bits << 8 | static_cast<unsigned char>(data_[at]);
    }
    data_.remove_prefix(size);
    return value_of(bits, type);
  }

  std::size_t rest() const { return data_.size(); }

 private:
  static double value_of(std::uint64_t bits, PlyType type) {
    switch (type) {
      case PlyType::int8:
        return static_cast<std::int8_t>(bits);
      case PlyType::int16:
        return static_cast<std::int16_t>(bits);
      case PlyType::int32:
        return static_cast<std::int32_t>(bits);
      case PlyType::float32:
        return static_cast<double>(std::bit_cast<float>(static_cast<std::uint32_t>(bits)));
      case PlyType::float64:
        return std::bit_cast<double>(bits);
      default:
        return static_cast<double>(bits);
    }
  }

  std::string_view data_;
  PlyEncoding encoding_;
};

/// What a property of a vertex means to us.
enum class Meaning { other, x, y, z, nx, ny, nz, u, v, red, green, blue, alpha };

Meaning meaning_of(std::string_view name) {
  constexpr std::array<std::pair<std::string_view, Meaning>, 16> names = {{{"x", Meaning::x},
                                                                           {"y", Meaning::y},
                                                                           {"z", Meaning::z},
                                                                           {"nx", Meaning::nx},
                                                                           {"ny", Meaning::ny},
                                                                           {"nz", Meaning::nz},
                                                                           {"s", Meaning::u},
                                                                           {"t", Meaning::v},
                                                                           {"u", Meaning::u},
                                                                           {"v", Meaning::v},
                                                                           {"texture_u", Meaning::u},
                                                                           {"texture_v", Meaning::v},
                                                                           {"red", Meaning::red},
                                                                           {"green", Meaning::green},
                                                                           {"blue", Meaning::blue},
                                                                           {"alpha", Meaning::alpha}}};
  for (const auto& [known, meaning] : names) {
    if (known == name) return meaning;
  }
  return Meaning::other;
}

/// The value of a color property that stands for full light.
double full_scale(PlyType type) {
  return type == PlyType::uint8 ? 255 : type == PlyType::uint16 ? 65535 : is_integer(type) ? 255 : 1;
}

class PlyReader {
 public:
  PlyReader(const PlyHeader& header, std::string_view data, const ImportLimits& limits, const Cancel& cancel)
      : header_(header), values_(data, header.encoding), limits_(limits), cancel_(cancel), steps_(cancel) {}

  ImportResult read() {
    for (const PlyElement& element : header_.elements) {
      if (element.name == "vertex") {
        read_vertices(element);
      } else if (element.name == "face") {
        read_faces(element);
      } else {
        for (std::size_t i = 0; i < element.count && !error_; ++i) {
          for (const PlyProperty& property : element.properties) pass_over(property);
        }
      }
      if (error_) return *std::move(error_);
    }
    return finish_import(std::move(raw_), MeshFormat::ply, limits_, cancel_);
  }

 private:
  void fail(const std::string& what) {
    if (!error_) error_ = invalid_file(what);
  }

  double value(PlyType type) {
    if (!error_ && steps_.stopped()) error_ = stopped_reading();
    if (error_) return 0;
    const auto number = values_.next(type);
    if (!number) fail("the data ends too early, or a number is none");
    return number.value_or(0);
  }

  /// The length of a list, of which the file has to hold as many values as it says.
  std::size_t length_of(const PlyProperty& property) {
    const double length = value(*property.length);
    const std::size_t each = header_.encoding == PlyEncoding::ascii ? 1 : size_of(property.type);
    const std::size_t most = values_.rest() / each;
    if (error_ || (length >= 0 && length <= static_cast<double>(most))) {
      return error_ ? 0 : static_cast<std::size_t>(length);
    }
    fail("a list is longer than the rest of the file, or has a negative length");
    return 0;
  }

  void pass_over(const PlyProperty& property) {
    const std::size_t count = property.length ? length_of(property) : 1;
    for (std::size_t i = 0; i < count && !error_; ++i) value(property.type);
  }

  void read_vertices(const PlyElement& element) {
    if (!raw_.positions.empty()) return fail("the vertices stand there twice");
    if (element.count > limits_.vertices) {
      error_ = too_many(limits_.vertices, "vertices");
      return;
    }
    std::array<bool, 13> has{};
    std::vector<Meaning> meanings;
    for (const PlyProperty& property : element.properties) {
      meanings.push_back(property.length ? Meaning::other : meaning_of(property.name));
      has[static_cast<std::size_t>(meanings.back())] = true;
    }
    const auto has_all = [&](Meaning first, Meaning last) {
      const auto begin = has.begin() + static_cast<std::ptrdiff_t>(first);
      return std::all_of(begin, has.begin() + static_cast<std::ptrdiff_t>(last) + 1, [](bool one) { return one; });
    };
    if (!has_all(Meaning::x, Meaning::z)) return fail("the vertices have no x, y and z");
    for (std::size_t i = 0; i < element.count; ++i) {
      std::array<double, 13> at{};
      at[static_cast<std::size_t>(Meaning::alpha)] = 1;
      for (std::size_t k = 0; k < meanings.size(); ++k) {
        const PlyProperty& property = element.properties[k];
        if (property.length) {
          pass_over(property);
          continue;
        }
        const double number = value(property.type);
        at[static_cast<std::size_t>(meanings[k])] =
            meanings[k] >= Meaning::red ? number / full_scale(property.type) : number;
      }
      if (error_) return;
      raw_.positions.push_back({at[1], at[2], at[3]});
      if (has_all(Meaning::nx, Meaning::nz)) raw_.normals.push_back({at[4], at[5], at[6]});
      if (has_all(Meaning::u, Meaning::v)) raw_.uvs.push_back({at[7], 1 - at[8]});
      if (has_all(Meaning::red, Meaning::blue)) {
        raw_.colors.push_back({linear_color(at[9]), linear_color(at[10]), linear_color(at[11]),
                               static_cast<float>(std::clamp(at[12], 0.0, 1.0))});
      }
    }
  }

  void read_faces(const PlyElement& element) {
    if (raw_.positions.empty()) return fail("there are faces before any vertices");
    const auto is_corners = [](const PlyProperty& property) {
      return property.length && is_integer(property.type) &&
             (property.name == "vertex_indices" || property.name == "vertex_index");
    };
    if (std::none_of(element.properties.begin(), element.properties.end(), is_corners)) {
      return fail("the faces have no list vertex_indices of whole numbers");
    }
    for (std::size_t i = 0; i < element.count && !error_; ++i) {
      for (const PlyProperty& property : element.properties) {
        is_corners(property) ? read_corners(property) : pass_over(property);
      }
    }
  }

  void read_corners(const PlyProperty& property) {
    const std::size_t count = length_of(property);
    if (error_) return;
    if (count < 3) return fail("a face has fewer than three corners");
    if (raw_.triangles.size() + count - 2 > limits_.triangles) {
      error_ = too_many(limits_.triangles, "triangles");
      return;
    }
    polygon_.clear();
    corners_.clear();
    for (std::size_t k = 0; k < count; ++k) {
      const double index = value(property.type);
      if (error_) return;
      if (!(index >= 0 && index < static_cast<double>(raw_.positions.size()))) {
        return fail("a face uses vertex " + std::to_string(static_cast<std::int64_t>(index)) + " of " +
                    std::to_string(raw_.positions.size()));
      }
      polygon_.push_back(static_cast<std::uint32_t>(index));
      corners_.push_back(raw_.positions[polygon_.back()]);
    }
    pieces_.clear();
    cutter_.cut(corners_, pieces_);
    for (const auto& [a, b, c] : pieces_) raw_.triangles.push_back({polygon_[a], polygon_[b], polygon_[c]});
  }

  const PlyHeader& header_;
  ValueReader values_;
  const ImportLimits& limits_;
  const Cancel& cancel_;
  CancelEvery steps_;
  RawMesh raw_;
  PolygonCutter cutter_;
  std::vector<std::uint32_t> polygon_;
  std::vector<Vector> corners_;
  std::vector<std::array<std::uint32_t, 3>> pieces_;
  std::optional<ImportError> error_;
};

}  // namespace

ImportResult read_ply(std::string_view bytes, const ImportLimits& limits, const Cancel& cancel) {
  const auto header = read_ply_header(bytes);
  if (const auto* error = std::get_if<ImportError>(&header)) return *error;
  const PlyHeader& known = std::get<PlyHeader>(header);
  return PlyReader(known, bytes.substr(known.size), limits, cancel).read();
}

}  // namespace dini
