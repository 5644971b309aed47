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
  /// `before` stands before the program, such as a command that limits it.
  explicit ServingProgram(const std::vector<std::string>& options = {}, const std::string& program = dini_path(),
                          const std::vector<std::string>& before = {}) {
    const auto file = std::filesystem::temp_directory_path() / ("dini-port-" + std::to_string(::getpid()));
    std::filesystem::remove(file);
    std::vector<std::string> words = before;
    for (const std::string& word :
         {program, std::string("serve"), std::string("--data"), std::string("none"), std::string("--port"),
          std::string("0"), std::string("--port-file"), file.string()}) {
      words.push_back(word);
    }
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
