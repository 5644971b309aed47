#pragma once

#include <filesystem>
#include <fstream>
#include <iterator>

#include "service/engine.h"

namespace dini::support {

/// An engine that knows the mesh files which the examples name; the program that uses it defines DINI_EXAMPLES.
inline std::unique_ptr<Engine> example_engine(const Limits& limits = {}) {
  std::unique_ptr<Engine> engine = make_engine(limits);
  for (const auto& entry : std::filesystem::directory_iterator(std::string(DINI_EXAMPLES) + "/assets")) {
    std::ifstream file(entry.path(), std::ios::binary);
    const std::string bytes{std::istreambuf_iterator<char>(file), {}};
    engine->add_asset(bytes, entry.path().filename().string(), Cancel());
  }
  return engine;
}

}  // namespace dini::support
