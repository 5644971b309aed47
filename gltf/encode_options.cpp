#include "gltf/encode_options.h"

namespace dini {
namespace {

std::optional<EncodeError> check_range(const char* name, int value, int minimum, int maximum) {
  if (value >= minimum && value <= maximum) return std::nullopt;
  return EncodeError{EncodeError::Code::invalid_input,
                     std::string(name) + " is " + std::to_string(value) + "; it must be " + std::to_string(minimum) +
                         " to " + std::to_string(maximum) + ".",
                     ""};
}

}  // namespace

std::optional<EncodeError> check_options(const EncodeOptions& options) {
  if (auto error = check_range("position_bits", options.position_bits, 8, 20)) return error;
  if (auto error = check_range("normal_bits", options.normal_bits, 6, 16)) return error;
  if (auto error = check_range("uv_bits", options.uv_bits, 8, 20)) return error;
  return check_range("speed", options.speed, 0, 10);
}

}  // namespace dini
