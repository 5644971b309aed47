#pragma once

#include "geometry/file_format.h"

namespace dini {

/// glTF 2.0 in one binary file.
FileFormat glb_format();

/// glTF 2.0 as JSON, with the binary data inside as a data URI.
FileFormat gltf_format();

}  // namespace dini
