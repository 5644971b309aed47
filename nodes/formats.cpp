#include "nodes/formats.h"

#include <array>

#include "gltf/gltf_formats.h"

namespace dini {

std::span<const FileFormat> all_formats() {
  static const std::array formats = {
      glb_format(),
      gltf_format(),
  };
  return formats;
}

}  // namespace dini
