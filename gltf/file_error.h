#pragma once

#include "geometry/file_format.h"
#include "gltf/encode_error.h"

namespace dini {

/// An error of encoding as formats tell it: the same code for the same fault in all of them, the part named first.
FileError file_error(const EncodeError& error);

}  // namespace dini
