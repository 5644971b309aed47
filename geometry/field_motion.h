#pragma once

#include <optional>

#include "algebra/elements.h"
#include "geometry/scalar_field.h"

namespace dini {

/// The solid carried by a versor: the field pulled back, with its values made distances again. A ball without surface
/// is carried to a ball without surface, so where the field is no more than the distance from its surface, this one is
/// no more than that from the carried surface; and outside the image of the reach it is at least the distance from
/// there. Near the surface that is the value over the conformal factor. Nothing for what is no versor, such as a sum of
/// commuting rotors, or cannot be undone.
std::optional<SharedField> moved_field(SharedField field, const Versor& versor);

}  // namespace dini
