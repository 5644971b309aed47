#pragma once

#include <string>
#include <utility>
#include <vector>

#include "geometry/cancel.h"
#include "geometry/file_format.h"

namespace dini {

/// Packs files, given by name and content, in their order. Nothing of the archive depends on when or where it is made.
/// Errors are `encode-failed`; stopped early, there is one.
Expected<std::string, FileError> zip_archive(const std::vector<std::pair<std::string, std::string>>& files,
                                             const Cancel& cancel);

}  // namespace dini
