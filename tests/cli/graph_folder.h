#pragma once

#include <string>

#include "geometry/json.h"
#include "tests/support/folder.h"

namespace dini::support {

/// A folder for graph documents and what commands make of them.
struct GraphFolder : Folder {
  std::string at(const std::string& name) const { return (path() / name).string(); }
  std::string graph(const std::string& name, const Json& json) const {
    write(name, json.dump());
    return at(name);
  }
};

}  // namespace dini::support
