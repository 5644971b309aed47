#pragma once

#include <string>
#include <utility>

#include "geometry/expected.h"

namespace dini {

/// Why a scene could not be encoded. `part` names the part at fault; empty when it is the scene or the options.
struct EncodeError {
  enum class Code {
    non_finite,      ///< a drawn vertex has a NaN or infinite coordinate
    too_large,       ///< a coordinate beyond 1e18, or a file beyond what GLB can address
    empty,           ///< nothing in the scene can be drawn
    invalid_input,   ///< a mesh or an option breaks its own contract
    encoder_failed,  ///< the compressor refused
    canceled,        ///< the caller's cancel flag was raised
  };

  Code code = Code::encoder_failed;
  std::string detail;  ///< one sentence
  std::string part;
};

/// That the caller's cancel flag was raised.
inline EncodeError canceled() { return {EncodeError::Code::canceled, "Encoding was stopped.", ""}; }

/// A value or the reason why there is none. Nothing in this layer throws but std::bad_alloc.
template <class T>
using EncodeResult = Expected<T, EncodeError>;

}  // namespace dini
