#pragma once

#include <string>

#include "service/engine.h"

namespace dini::jobs {

/// What all must have in common who compute for one another: the version of the engine, and those limits that decide
/// what an answer says. As "0.2.2-1f3a99c0".
std::string queue_identity(const Engine& engine);

/// The version of the engine.
std::string version_of(const Engine& engine);

}  // namespace dini::jobs
