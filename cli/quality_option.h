#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "service/engine.h"

namespace dini::cli {

/// The option `--quality` of commands that evaluate.
class QualityOption {
 public:
  void add_option(CLI::App& command) {
    command.add_option("--quality", word_, "draft or final (default)")->check(CLI::IsMember({"draft", "final"}));
  }
  Quality value() const { return word_ == "draft" ? Quality::draft : Quality::final; }

 private:
  std::string word_ = "final";
};

}  // namespace dini::cli
