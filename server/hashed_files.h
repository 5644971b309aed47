#pragma once

// What routes share whose addresses end in the SHA-256 of a file: what is there never changes.

#include "server/application.h"
#include "server/operation.h"

namespace dini::server {

/// Adds to a description what all of them take and answer; `contents` are the types of the file.
Operation with_hashed_file(Operation operation, const std::vector<Content>& contents);

/// The answer with such a file, a part of it, or 304. `disposition` is what a browser does with it, and its extension.
Reply hashed_file_reply(const Context& context, const std::string& type, SharedBytes bytes,
                        const std::string& disposition, const std::string& extension = "");

}  // namespace dini::server
