#pragma once

// Reference numbers for the constructions of "Boosted Surfaces", computed independently with 40 digits.

#include <fstream>

#include "geometry/json.h"

namespace dini::support {

/// tests/data/boosted_surfaces.json; the program that uses it defines DINI_TEST_DATA.
inline const dini::Json& reference() {
  static const dini::Json data = dini::Json::parse(std::ifstream(DINI_TEST_DATA "/boosted_surfaces.json"));
  return data;
}

}  // namespace dini::support
