#pragma once

#include <vector>

#include "geometry/file_format.h"

namespace dini {

/// Every format that an export can be written in, the usual one first.
std::vector<FileFormat> all_formats();

}  // namespace dini
