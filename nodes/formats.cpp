#include "nodes/formats.h"

#include "gltf/gltf_formats.h"

namespace dini {

std::vector<FileFormat> all_formats() {
  return {
      glb_format(),
      gltf_format(),
  };
}

}  // namespace dini
