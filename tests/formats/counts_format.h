#pragma once

#include "geometry/file_format.h"

namespace dini::support {

/// A toy format: a text that counts what a scene holds, "1 meshes, 12 triangles".
FileFormat counts_format();

}  // namespace dini::support
