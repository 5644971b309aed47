#include "graph/node_type.h"

#include <algorithm>

namespace dini {

std::int64_t integer_at(const Literals& literals, std::string_view port) {
  return std::get<std::int64_t>(literals.find(port)->second);
}

bool boolean_at(const Literals& literals, std::string_view port) { return std::get<bool>(literals.find(port)->second); }

const std::string& text_at(const Literals& literals, std::string_view port) {
  return std::get<std::string>(literals.find(port)->second);
}

const AssetFile& file_at(const Literals& literals, std::string_view port) {
  return *std::get<SharedAssetFile>(literals.find(port)->second);
}

const InputPort* NodeType::find_input(std::string_view name) const {
  const auto found = std::find_if(inputs.begin(), inputs.end(), [&](const InputPort& p) { return p.name == name; });
  return found == inputs.end() ? nullptr : &*found;
}

const OutputPort* NodeType::find_output(std::string_view name) const {
  const auto found = std::find_if(outputs.begin(), outputs.end(), [&](const OutputPort& p) { return p.name == name; });
  return found == outputs.end() ? nullptr : &*found;
}

std::size_t NodeType::input_index(std::string_view name) const {
  return static_cast<std::size_t>(find_input(name) - inputs.data());
}

}  // namespace dini
