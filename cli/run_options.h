#pragma once

#include <CLI/CLI.hpp>
#include <atomic>
#include <cstddef>
#include <string>

#include "cli/computing.h"
#include "service/engine.h"

namespace dini::cli {

/// How a command goes through the many things that it makes: the options `--jobs`, `--deadline-ms`, `--fail-fast`,
/// `--keep-going`, and `--threads` and `--instruction-set` beside them.
class RunOptions {
 public:
  /// `one` and `many` are what the command makes, as "case" and "cases".
  void add_options(CLI::App& command, const std::string& one, const std::string& many);

  /// Applies threads and instructions until the end of this object. The problem has code `usage`.
  Problems apply() { return computing_.apply(); }

  /// How many things are made at once.
  std::size_t at_once() const { return jobs_ > 0 ? jobs_ : computing_.threads(); }

  /// The work on one thing, which is given up at its deadline.
  Job job() const;

  bool fail_fast() const { return fail_fast_; }

 private:
  std::size_t jobs_ = 0;
  std::size_t deadline_ms_ = 0;
  bool fail_fast_ = false;
  bool keep_going_ = false;
  Computing computing_;
};

/// Whether one thing more is begun: not after one has failed, with `--fail-fast`.
class FailFast {
 public:
  explicit FailFast(const RunOptions& options) : applies_(options.fail_fast()) {}

  bool stopped() const { return stopped_; }
  void after(bool succeeded) {
    if (applies_ && !succeeded) stopped_ = true;
  }

 private:
  const bool applies_;
  std::atomic<bool> stopped_ = false;
};

}  // namespace dini::cli
