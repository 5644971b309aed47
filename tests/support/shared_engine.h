#pragma once

#include "service/engine.h"

namespace dini::support {

/// The engine of all tests of the program that ask nothing special of it.
inline const Engine& engine() {
  static const std::unique_ptr<Engine> made = make_engine();
  return *made;
}

}  // namespace dini::support
