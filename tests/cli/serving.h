#pragma once

#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <memory>
#include <string>
#include <unistd.h>
#include <vector>

#include "tests/cli/program.h"
#include "tests/support/eventually.h"

namespace dini::support {

/// `dini serve` on a free port, once it listens; it keeps nothing unless the options say where.
class ServingProgram {
 public:
  explicit ServingProgram(const std::vector<std::string>& options = {}, const std::string& program = dini_path()) {
    const auto file = std::filesystem::temp_directory_path() / ("dini-port-" + std::to_string(::getpid()));
    std::filesystem::remove(file);
    std::vector<std::string> words = {program, "serve", "--data", "none", "--port", "0", "--port-file", file.string()};
    words.insert(words.end(), options.begin(), options.end());
    program_ = std::make_unique<Program>(words);
    REQUIRE(eventually([&] { return (std::ifstream(file) >> port_) && port_ != 0; }));
    std::filesystem::remove(file);
  }

  int port() const { return port_; }
  Program& program() { return *program_; }

 private:
  std::unique_ptr<Program> program_;
  int port_ = 0;
};

}  // namespace dini::support
