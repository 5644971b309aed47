#pragma once

#include <string>
#include <string_view>

namespace dini::cli {

/// A graph document in the layout of the examples: one node, parameter or note a line where it fits. The members of the
/// document come in the order in which docs/document.md lists them, those of a node as type, inputs, bypass; all others
/// stay where they are, and every value as it is spelled. The text is well-formed JSON of bounded depth. Laying out
/// what was laid out changes nothing.
std::string canonical_layout(std::string_view text);

}  // namespace dini::cli
