#pragma once

#include <functional>
#include <memory>

#include "service/engine.h"

namespace dini::cli {

/// Makes the engine that a command works with.
using EngineMaker = std::function<std::unique_ptr<Engine>(const Limits& limits)>;

/// The whole program: reads the words, runs the command that they name, answers the exit code. Never throws.
int run_program(int count, const char* const* words, const EngineMaker& make_engine);

}  // namespace dini::cli
