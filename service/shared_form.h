#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "graph/node_result.h"

namespace dini {

/// The result of an export node, its one file and all warnings, as bytes: JSON in one line, then the bytes of the file.
std::string shared_form(const NodeResult& result);
/// What `shared_form` wrote; nothing for other bytes.
std::optional<NodeResult> read_shared_form(std::string_view form);

}  // namespace dini
