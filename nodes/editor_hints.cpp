#include "nodes/editor_hints.h"

#include <array>
#include <string>

#include "geometry/palette.h"

namespace dini {

namespace {

struct Beginning {
  const char* node;
  const char* input;
  double value;
};

// Without softening a null pair of length 1 and strength 1 takes points at distance d to infinity where d^2 + softening
// equals d; from a quarter on there is no such place, and at a half the strongest pull is well below it.
constexpr std::array<Beginning, 1> beginnings = {{{"warp", "softening", 0.5}}};

/// Of palettes with five and with seven colors, none is missed.
constexpr int palette_steps = 12;

Json colors_of(Palette palette) {
  Json colors = Json::array();
  for (int step = 0; step <= palette_steps; ++step) {
    const std::array<float, 4> color = palette_color(palette, static_cast<double>(step) / palette_steps);
    colors.push_back({color[0], color[1], color[2]});
  }
  return colors;
}

Json palettes() {
  return {{"diverging", colors_of(Palette::diverging)},
          {"sequential", colors_of(Palette::sequential)},
          {"cyclic", colors_of(Palette::cyclic)}};
}

Json legend_of(const std::string& id) {
  if (id == "color_by") {
    return {{"palette", "palette"}, {"ends", {"minimum", "maximum"}}, {"colors", palettes()}};
  }
  if (id == "curvature_color") {
    return {{"palette", "palette"},
            {"range", "range"},
            {"found", {"minimum", "maximum"}},
            {"kind", "kind"},
            {"units", {{"gauss", "m⁻²"}, {"mean", "m⁻¹"}}},
            {"colors", palettes()}};
  }
  return nullptr;
}

}  // namespace

void add_editor_hints(Json& card) {
  const std::string id = card["id"].get<std::string>();
  for (const Beginning& beginning : beginnings) {
    if (id != beginning.node) continue;
    for (Json& input : card["inputs"]) {
      if (input["name"] == beginning.input) input["begin"] = beginning.value;
    }
  }
  if (Json legend = legend_of(id); !legend.is_null()) card["legend"] = std::move(legend);
}

}  // namespace dini
