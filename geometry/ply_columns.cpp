#include "geometry/ply_columns.h"

#include <algorithm>
#include <string_view>

#include "geometry/counted.h"
#include "geometry/text_reader.h"

namespace dini {

namespace {

struct Name {
  std::string_view name;
  PlyMeaning meaning;
};

constexpr std::array<Name, 24> known_names = {{{"x", PlyMeaning::x},
                                               {"y", PlyMeaning::y},
                                               {"z", PlyMeaning::z},
                                               {"nx", PlyMeaning::nx},
                                               {"ny", PlyMeaning::ny},
                                               {"nz", PlyMeaning::nz},
                                               {"s", PlyMeaning::u},
                                               {"t", PlyMeaning::v},
                                               {"u", PlyMeaning::u},
                                               {"v", PlyMeaning::v},
                                               {"texture_u", PlyMeaning::u},
                                               {"texture_v", PlyMeaning::v},
                                               {"red", PlyMeaning::red},
                                               {"green", PlyMeaning::green},
                                               {"blue", PlyMeaning::blue},
                                               {"alpha", PlyMeaning::alpha},
                                               {"r", PlyMeaning::red},
                                               {"g", PlyMeaning::green},
                                               {"b", PlyMeaning::blue},
                                               {"a", PlyMeaning::alpha},
                                               {"diffuse_red", PlyMeaning::red},
                                               {"diffuse_green", PlyMeaning::green},
                                               {"diffuse_blue", PlyMeaning::blue},
                                               {"diffuse_alpha", PlyMeaning::alpha}}};

PlyMeaning meaning_of(const PlyProperty& property) {
  if (property.length) {
    const bool named = property.name == "vertex_indices" || property.name == "vertex_index";
    return named && is_integer(property.type) ? PlyMeaning::corners : PlyMeaning::other;
  }
  const auto found = std::ranges::find(known_names, std::string_view(property.name), &Name::name);
  return found == known_names.end() ? PlyMeaning::other : found->meaning;
}

/// Bytes above 127 that are declared as signed come as negative ones.
double channel_value(double value, const std::optional<PlyType>& type) {
  return type == PlyType::int8 && value < 0 ? value + 256 : value;
}

}  // namespace

PlyColumns::PlyColumns(const PlyElement& element) {
  for (const PlyProperty& property : element.properties) {
    const PlyMeaning meaning = meaning_of(property);
    const bool taken = meaning == PlyMeaning::other || has(meaning);
    meanings_.push_back(taken ? PlyMeaning::other : meaning);
    if (!taken) types_[static_cast<std::size_t>(meaning)] = property.type;
  }
  const auto drop_incomplete = [&](PlyMeaning first, PlyMeaning last, PlyMeaning last_dropped) {
    const auto begin = types_.begin() + static_cast<std::ptrdiff_t>(first);
    const auto end = types_.begin() + static_cast<std::ptrdiff_t>(last) + 1;
    if (!std::all_of(begin, end, [](const auto& type) { return type.has_value(); })) drop(first, last_dropped);
  };
  drop_incomplete(PlyMeaning::x, PlyMeaning::z, PlyMeaning::z);
  drop_incomplete(PlyMeaning::nx, PlyMeaning::nz, PlyMeaning::nz);
  drop_incomplete(PlyMeaning::u, PlyMeaning::v, PlyMeaning::v);
  drop_incomplete(PlyMeaning::red, PlyMeaning::blue, PlyMeaning::alpha);
}

PlyColumns PlyColumns::of_vertices(const PlyElement& element) {
  PlyColumns columns(element);
  columns.drop(PlyMeaning::corners, PlyMeaning::corners);
  return columns;
}

PlyColumns PlyColumns::of_faces(const PlyElement& element, bool with_colors) {
  PlyColumns columns(element);
  columns.drop(PlyMeaning::x, with_colors ? PlyMeaning::v : PlyMeaning::alpha);
  return columns;
}

std::optional<std::string> PlyColumns::left_out(const PlyElement& element) const {
  constexpr std::size_t most_listed = 3;
  std::string listed;
  std::size_t count = 0;
  for (std::size_t k = 0; k < meanings_.size(); ++k) {
    if (meanings_[k] != PlyMeaning::other) continue;
    if (++count <= most_listed) listed += (count == 1 ? ": " : ", ") + in_quotes(element.properties[k].name);
  }
  if (count == 0 || element.count == 0) return std::nullopt;
  return counted(count, "property", "properties") + " of " + in_quotes(element.name) + (count == 1 ? " is" : " are") +
         " left out" + listed + (count > most_listed ? " and others" : "");
}

std::array<float, 4> PlyColumns::color(const PlyNumbers& row) const {
  const auto channel = [&](PlyMeaning meaning) { return channel_value(row[meaning], type_of(meaning)); };
  return file_color(channel(PlyMeaning::red), channel(PlyMeaning::green), channel(PlyMeaning::blue),
                    has(PlyMeaning::alpha) ? std::optional(channel(PlyMeaning::alpha)) : std::nullopt);
}

FullValue PlyColumns::full_value(PlyMeaning channel) const {
  const PlyType type = type_of(channel).value_or(PlyType::uint8);
  if (!is_integer(type)) return {};
  return {255, size_of(type) == 1 ? 255.0 : type == PlyType::int16 ? 32767.0 : 65535.0};
}

void PlyColumns::drop(PlyMeaning first, PlyMeaning last) {
  const auto dropped = [&](PlyMeaning meaning) { return meaning >= first && meaning <= last; };
  std::replace_if(meanings_.begin(), meanings_.end(), dropped, PlyMeaning::other);
  for (std::size_t k = 0; k < types_.size(); ++k) {
    if (dropped(static_cast<PlyMeaning>(k))) types_[k].reset();
  }
}

}  // namespace dini
