#pragma once

#include <CLI/CLI.hpp>
#include <functional>

#include "cli/program.h"

namespace dini::cli {

/// Each adds one command with its options and help. When the command is given, `chosen` becomes what runs it and
/// answers the exit code. `make_engine` must outlive that.
using Command = std::function<int()>;
void add_serve(CLI::App& program, Command& chosen, const EngineMaker& make_engine);
void add_worker(CLI::App& program, Command& chosen, const EngineMaker& make_engine);
void add_queue(CLI::App& program, Command& chosen);
void add_eval(CLI::App& program, Command& chosen, const EngineMaker& make_engine);
void add_sweep(CLI::App& program, Command& chosen, const EngineMaker& make_engine);
void add_fit(CLI::App& program, Command& chosen, const EngineMaker& make_engine);
void add_test(CLI::App& program, Command& chosen, const EngineMaker& make_engine);
void add_validate(CLI::App& program, Command& chosen, const EngineMaker& make_engine);
void add_inspect(CLI::App& program, Command& chosen, const EngineMaker& make_engine);
void add_diff(CLI::App& program, Command& chosen);
void add_explain(CLI::App& program, Command& chosen, const EngineMaker& make_engine);
void add_hash(CLI::App& program, Command& chosen, const EngineMaker& make_engine);
void add_fmt(CLI::App& program, Command& chosen);
void add_upgrade(CLI::App& program, Command& chosen, const EngineMaker& make_engine);
void add_merge(CLI::App& program, Command& chosen, const EngineMaker& make_engine);
void add_nodes(CLI::App& program, Command& chosen, const EngineMaker& make_engine);
void add_store(CLI::App& program, Command& chosen);
void add_describe(CLI::App& program, Command& chosen);
void add_completion(CLI::App& program, Command& chosen);

}  // namespace dini::cli
