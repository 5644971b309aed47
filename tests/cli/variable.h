#pragma once

#include <cstdlib>
#include <string>
#include <utility>

namespace dini::support {

/// An environment variable for the programs that are started while this lives.
struct Variable {
  Variable(std::string variable, const std::string& value) : name(std::move(variable)) {
    ::setenv(name.c_str(), value.c_str(), 1);
  }
  ~Variable() { ::unsetenv(name.c_str()); }
  std::string name;
};

}  // namespace dini::support
