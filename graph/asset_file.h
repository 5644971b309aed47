#pragma once

#include <functional>
#include <memory>
#include <string_view>

#include "geometry/imported_mesh.h"
#include "graph/digest.h"
#include "graph/file.h"

namespace dini {

/// A mesh file that graphs may name: read once, known by the hash of its bytes. A node function that takes one has an
/// input where the document writes a text; the check turns the text into the file, so the function stays a function of
/// its arguments and the fingerprint depends on the content alone, whatever name it was found by.
struct AssetFile {
  Digest sha256{};
  std::size_t bytes = 0;  ///< of the file
  ImportedMesh content;
  SharedBytes source;  ///< the file itself; null when an AssetKeeper has it
};

using SharedAssetFile = std::shared_ptr<const AssetFile>;

/// The file that a graph means by a text: the 64 hexadecimal digits of its hash, or a name that was given to it. Null
/// if there is none. Empty where no files are known.
using AssetFinder = std::function<SharedAssetFile(std::string_view text)>;

}  // namespace dini
