#pragma once

#include "geometry/json.h"

namespace dini {

/// Adds to the card of a node what editors need to know of it, and what evaluation never looks at:
/// `begin` of an input, what a new node is given there, where the default stays for the sake of older documents;
/// `legend`, which inputs and outputs tell the scale of the colors that the node gives to meshes, and the linear colors
/// of the palettes at even places. Cards without such hints stay as they are.
void add_editor_hints(Json& card);

}  // namespace dini
