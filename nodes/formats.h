#pragma once

#include <span>

#include "geometry/file_format.h"

namespace dini {

/// Every format that an export can be written in, the usual one first.
std::span<const FileFormat> all_formats();

}  // namespace dini
