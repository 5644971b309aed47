#include "gltf/file_error.h"

namespace dini {

FileError file_error(const EncodeError& error) {
  const std::string detail = (error.part.empty() ? "" : error.part + ": ") + error.detail;
  switch (error.code) {
    case EncodeError::Code::non_finite:
      return {"non-finite", detail};
    case EncodeError::Code::too_large:
      return {"limit-exceeded", detail};
    case EncodeError::Code::empty:
      return {"nothing-to-export", ""};
    case EncodeError::Code::invalid_input:
    case EncodeError::Code::encoder_failed:
    case EncodeError::Code::canceled:
      break;
  }
  return {"encode-failed", detail};
}

}  // namespace dini
