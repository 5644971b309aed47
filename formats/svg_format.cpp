#include <algorithm>
#include <cmath>

#include "formats/file_texts.h"
#include "formats/formats.h"
#include "formats/plain_scene.h"
#include "geometry/markup.h"

namespace dini {

namespace {

/// What a drawing holds, in its millimeters, seen from above: x to the right, y up.
struct Extent {
  double least_x = 0, least_y = 0, most_x = 0, most_y = 0;

  explicit Extent(const PlainScene& scene, double factor) {
    bool first = true;
    for (const PlainPart& part : scene.parts) {
      for (const auto& [x, y, z] : part.curves.points) {
        const double right = factor * static_cast<double>(x), up = factor * static_cast<double>(y);
        least_x = first ? right : std::min(least_x, right);
        most_x = first ? right : std::max(most_x, right);
        least_y = first ? up : std::min(least_y, up);
        most_y = first ? up : std::max(most_y, up);
        first = false;
      }
    }
  }

  double width() const { return most_x - least_x; }
  double height() const { return most_y - least_y; }
};

class SvgWriter {
 public:
  SvgWriter(const PlainScene& scene, const FileOptions& options, const Cancel& cancel)
      : factor_(scene.in_millimeters ? 1 : 1000), extent_(scene, factor_), steps_(cancel) {
    line_ = std::max({extent_.width(), extent_.height(), 1e-3}) / 1000;
    // The lines at the border have a half of their width outside.
    const double margin = 2 * line_;
    const double width = extent_.width() + 2 * margin, height = extent_.height() + 2 * margin;
    text_ = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<svg xmlns=\"http://www.w3.org/2000/svg\" version=\"1.1\"";
    append(" width=\"", width);
    append("mm\" height=\"", height);
    append("mm\" viewBox=\"", extent_.least_x - margin);
    append(" ", -extent_.most_y - margin);
    append(" ", width);
    append(" ", height);
    text_ += "\">\n<!-- " + program_of(options) + ", unit: millimeter, seen from above -->\n";
  }

  void write(const PlainPart& part) {
    const auto [red, green, blue, alpha] = picture_color(part.color);
    text_ += "<g id=\"" + escaped_markup(part.name) + "\" fill=\"none\" stroke=\"#";
    for (const std::uint8_t channel : {red, green, blue}) {
      constexpr const char* digits = "0123456789abcdef";
      text_ += {digits[channel / 16], digits[channel % 16]};
    }
    append("\" stroke-width=\"", line_);
    text_ += "\" stroke-linejoin=\"round\">\n";
    std::size_t begin = 0;
    for (const std::size_t end : part.curves.ends) {
      if (steps_.stopped()) return;
      write_run(part.curves.points, begin, end);
      begin = end;
    }
    text_ += "</g>\n";
  }

  bool stopped() { return steps_.stopped(); }
  std::string take() && { return std::move(text_) + "</svg>\n"; }

 private:
  /// A run that ends where it starts is a closed path.
  void write_run(const FloatPoints& points, std::size_t begin, std::size_t end) {
    const bool closed = end - begin > 3 && points[begin] == points[end - 1];
    text_ += "<path d=\"";
    for (std::size_t i = begin; i < end - (closed ? 1 : 0) && !steps_.stopped(); ++i) {
      append(i == begin ? "M" : "L", factor_ * static_cast<double>(points[i][0]));
      append(" ", -factor_ * static_cast<double>(points[i][1]));
    }
    text_ += closed ? "Z\"/>\n" : "\"/>\n";
  }

  void append(const char* before, double value) {
    text_ += before;
    append_number(text_, static_cast<float>(value) + 0.0F);  // no minus before zero
  }

  double factor_;
  Extent extent_;
  CancelEvery steps_;
  double line_ = 0;
  std::string text_;
};

Expected<WrittenFile, FileError> write(const Scene& scene, const FileOptions& options, const Cancel& cancel) {
  auto plain = plain_scene(
      scene, options, {.format = "SVG", .meshes = false, .curves = true, .colors = true, .millimeters = true}, cancel);
  if (!plain) return plain.error();
  SvgWriter writer(*plain, options, cancel);
  for (const PlainPart& part : plain->parts) writer.write(part);
  if (writer.stopped()) return FileError{"encode-failed", "writing was stopped"};
  return std::move(*plain).file(std::move(writer).take());
}

}  // namespace

FileFormat svg_format() {
  return {
      .name = "svg",
      .media_types = {"image/svg+xml"},
      .extension = ".svg",
      .doc = "SVG in millimeters: the curves and circles of the scene seen from above, such as the contours of slices.",
      .write = write,
      .vertex_bytes = 96};
}

}  // namespace dini
