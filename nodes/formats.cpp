#include "nodes/formats.h"

#include <array>

#include "formats/formats.h"
#include "gltf/gltf_formats.h"

namespace dini {

std::span<const FileFormat> all_formats() {
  static const std::array formats = {
      glb_format(), gltf_format(), obj_format(), stl_format(), ply_format(), three_mf_format(), svg_format(),
  };
  return formats;
}

}  // namespace dini
