#pragma once

#include <string>
#include <vector>

#include "graph/document.h"
#include "graph/registry.h"

namespace dini {

/// The nodes of a document that make a file, and those of unknown type that may have been meant to.
struct Exports {
  std::vector<std::string> known;
  std::vector<std::string> unknown;
};

Exports exports_of(const Registry& registry, const Document& document);

/// The node to export: the one asked for, which may be an instance of a group that makes the file, else the only one
/// that makes a file. Problems list what there is.
Result<std::string> find_output(const Registry& registry, const Document& document, const std::string& asked);

}  // namespace dini
