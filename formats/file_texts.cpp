#include "formats/file_texts.h"

#include <charconv>
#include <cmath>

#include "geometry/file_colors.h"

namespace dini {

namespace {

constexpr std::size_t color_step = 16;  ///< Colors of tiles are multiples of it, but for 65535.

std::uint8_t byte_of(double share) { return static_cast<std::uint8_t>(std::lround(255 * share)); }

double clamped(double share) { return share > 0 ? std::min(share, 1.0) : 0.0; }

}  // namespace

std::string program_of(const FileOptions& options) {
  const Json engine = options.about.is_object() ? options.about.value("engine", Json()) : Json();
  return engine.is_string() ? "Dini " + engine.get<std::string>() : "Dini";
}

std::string about_line(const FileOptions& options, bool with_graph) {
  if (!options.about.is_object()) return "";
  Json about = options.about;
  if (!with_graph) about.erase("document");
  return about.dump(-1, ' ', true, Json::error_handler_t::replace);
}

void append_number(std::string& text, float value) {
  char digits[32];
  text.append(digits, std::to_chars(digits, digits + sizeof(digits), value).ptr);
}

void append_count(std::string& text, std::size_t value) {
  char digits[24];
  text.append(digits, std::to_chars(digits, digits + sizeof(digits), value).ptr);
}

PictureColor picture_color(const Color& linear) {
  return {byte_of(picture_share(linear[0])), byte_of(picture_share(linear[1])), byte_of(picture_share(linear[2])),
          byte_of(clamped(linear[3]))};
}

VertexColors::VertexColors(const PlainPart& part) : part_(part), of_part_(picture_color(part.color)) {
  if (part.mesh.colors.empty()) return;
  constexpr std::size_t steps = 4096;
  for (std::size_t k = 0; k <= steps; ++k) {
    shares_.push_back(byte_of(picture_share(static_cast<double>(k) / static_cast<double>(steps))));
  }
}

PictureColor VertexColors::operator[](std::size_t vertex) const {
  if (part_.mesh.colors.empty()) return of_part_;
  const auto& [red, green, blue, alpha] = part_.mesh.colors[vertex];
  const auto share = [&](std::uint16_t value) { return shares_[(value + color_step - 1) / color_step]; };
  return {share(red), share(green), share(blue), byte_of(static_cast<double>(alpha) / 65535)};
}

}  // namespace dini
