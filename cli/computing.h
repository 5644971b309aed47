#pragma once

#include <CLI/CLI.hpp>
#include <memory>
#include <string>
#include <tbb/global_control.h>

#include "graph/problem.h"

namespace dini::cli {

/// The options of every command that computes: how many threads, and which instructions. Neither changes a byte of the
/// result; both exist to show that.
class Computing {
 public:
  void add_options(CLI::App& command);

  /// Applies them until the end of this object. The problem has code `usage`.
  Problems apply();

  /// How many threads compute.
  std::size_t threads() const;

 private:
  int threads_ = 0;
  std::string instruction_set_;
  std::unique_ptr<tbb::global_control> control_;
};

}  // namespace dini::cli
