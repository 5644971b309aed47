#include "graph/node_type.h"

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

std::size_t Overload::consumed_axes() const {
  const std::optional<std::size_t> block = first_block();
  return block ? static_cast<std::size_t>(inputs[*block].consumed_axes) : 0;
}

std::optional<std::size_t> Overload::first_block() const {
  for (std::size_t port = 0; port < inputs.size(); ++port) {
    if (inputs[port].is_block()) return port;
  }
  return std::nullopt;
}

namespace {

template <class Ports>
std::size_t index_of(const Ports& ports, std::string_view name) {
  std::size_t index = 0;
  while (index < ports.size() && ports[index].name != name) ++index;
  return index;
}

}  // namespace

const InputPort* NodeType::find_input(std::string_view name) const {
  const std::size_t index = index_of(inputs, name);
  return index == inputs.size() ? nullptr : &inputs[index];
}

const OutputPort* NodeType::find_output(std::string_view name) const {
  const std::size_t index = index_of(outputs, name);
  return index == outputs.size() ? nullptr : &outputs[index];
}

std::size_t NodeType::input_index(std::string_view name) const { return index_of(inputs, name); }

std::size_t NodeType::output_index(std::string_view name) const { return index_of(outputs, name); }

}  // namespace dini
