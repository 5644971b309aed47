#pragma once

namespace dini {

/// The version of the engine. It is part of every entity tag and of every file, so raise it when any result changes.
constexpr const char* engine_version = "0.1.0";

}  // namespace dini
