#pragma once

#include <string>

#include "algebra/vector.h"

namespace dini {

/// A length in a few digits, for sentences: "0.0125".
std::string short_text(double number);

/// A place in a few digits, for sentences: "(1, 0, -0.25)".
std::string place_text(const Vector& place);

}  // namespace dini
