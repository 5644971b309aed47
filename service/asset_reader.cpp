#include "service/asset_reader.h"

#include <algorithm>

#include "geometry/obj_reader.h"
#include "geometry/ply_header.h"
#include "geometry/ply_reader.h"
#include "geometry/stl_reader.h"
#include "geometry/text_reader.h"
#include "gltf/glb_import.h"
#include "graph/stopped.h"

namespace dini {

namespace {

constexpr std::string_view what_is_read = "OBJ, PLY, STL and GLB are read";

bool is_text(std::string_view bytes) {
  return std::none_of(bytes.begin(), bytes.end(), [](char c) {
    const auto byte = static_cast<unsigned char>(c);
    return byte < 0x20 && (byte < '\t' || byte > '\r');
  });
}

ImportResult read_any(std::string_view bytes, const ImportLimits& limits, const Cancel& cancel) {
  if (bytes.starts_with("glTF")) return read_glb_mesh(bytes, limits, cancel);
  if (begins_like_ply(bytes)) return read_ply(bytes, limits, cancel);
  if (begins_like_stl(bytes)) return read_stl(bytes, limits, cancel);
  const std::string_view text = without_byte_order_mark(bytes);
  if (text.substr(std::min(text.find_first_not_of(white_space), text.size())).starts_with('{')) {
    return invalid_file("it looks like JSON; a .gltf with files of its own cannot be read, but " +
                        std::string(what_is_read));
  }
  if (bytes.starts_with("\xFF\xFE") || bytes.starts_with("\xFE\xFF")) {
    return invalid_file("it is text in UTF-16; save it as ASCII or UTF-8");
  }
  if (bytes.empty() || !is_text(bytes)) {
    const std::string hint = stl_size_hint(bytes).value_or("");
    return invalid_file("its format is not known; " + std::string(what_is_read) +
                        (hint.empty() ? "" : " (" + hint + ")"));
  }
  return read_obj(bytes, limits, cancel);
}

std::string format_of(std::string_view bytes) {
  if (bytes.starts_with("glTF")) return "this GLB: ";
  if (begins_like_ply(bytes)) return "this PLY: ";
  return begins_like_stl(bytes) ? "this STL: " : "this file: ";
}

}  // namespace

Result<std::shared_ptr<AssetFile>> read_asset(std::string_view bytes, const Limits& limits, const Cancel& cancel) {
  if (bytes.size() > limits.asset_bytes) {
    return Problem{"limit-exceeded", "the file has " + std::to_string(bytes.size()) + " bytes, at most " +
                                         std::to_string(limits.asset_bytes) + " are accepted"};
  }
  ImportResult read = read_any(bytes, {limits.asset_vertices, limits.asset_triangles}, cancel);
  if (!read) {
    const ImportError& error = read.error();
    if (error.code == ImportError::Code::stopped) return stopped_problem(cancel.reason());
    const bool large = error.code == ImportError::Code::too_large;
    return Problem{large ? "limit-exceeded" : "invalid-asset", format_of(bytes) + error.detail};
  }
  return std::make_shared<AssetFile>(AssetFile{sha256(bytes), bytes.size(), *std::move(read), nullptr});
}

}  // namespace dini
