#pragma once

namespace dini {

/// The version of the engine, as the project's CMakeLists.txt says it. It is part of every entity tag and of every
/// file, so it is raised whenever any result changes.
extern const char* const engine_version;

}  // namespace dini
