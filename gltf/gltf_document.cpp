#include "gltf/gltf_document.h"

#include <algorithm>

#include "gltf/glb_container.h"
#include "gltf/gltf_extensions.h"

namespace dini {

GltfDocument::GltfDocument(std::string_view glb, const Cancel& cancel) : steps_(cancel) {
  const auto chunks = split_glb(glb);
  if (!chunks) refuse_gltf("it is no complete GLB of version 2");
  root_ = parse_gltf(chunks->json);
  binary_ = chunks->binary;
  bytes_behind_ = chunks->behind;
}

std::size_t GltfDocument::count(const char* name) const {
  const auto found = root_.find(name);
  if (found == root_.end()) return 0;
  if (!found->is_array()) refuse_gltf("\"" + std::string(name) + "\" must be a list");
  return found->size();
}

const GltfJson& GltfDocument::entry(const char* name, std::size_t index) const {
  if (index >= count(name)) {
    refuse_gltf("entry " + std::to_string(index) + " of \"" + name + "\" is used, there are " +
                std::to_string(count(name)));
  }
  const GltfJson& found = root_.at(name)[index];
  if (!found.is_object()) refuse_gltf("the entries of \"" + std::string(name) + "\" must be objects");
  return found;
}

void GltfDocument::spend(std::size_t steps) {
  step();
  if (steps > steps_left_) {
    throw GltfRefused{{ImportError::Code::too_large, "the file asks for the same values again and again"}};
  }
  steps_left_ -= steps;
}

const GltfAccessor& GltfDocument::accessor(std::size_t index) {
  const auto known = accessors_.find(index);
  if (known != accessors_.end()) return known->second;
  try {
    return accessors_.emplace(index, checked_accessor(index)).first->second;
  } catch (GltfRefused& refused) {
    refused.error.detail = "accessor " + std::to_string(index) + ": " + refused.error.detail;
    throw;
  }
}

GltfAccessor GltfDocument::checked_accessor(std::size_t index) {
  const GltfJson& description = entry("accessors", index);
  const std::size_t count = needed_number(description, "count");
  const std::size_t type = needed_number(description, "componentType");
  const std::size_t width = width_of(text_member(description, "type", ""));
  if (component_size(type) == 0) refuse_gltf("its component type is unknown");
  if (width == 0) refuse_gltf("its type is unknown");
  if (count == 0) refuse_gltf("it is empty");
  GltfAccessor accessor(count, width, type, is_true(description, "normalized"));
  if (description.contains("bufferView")) accessor.set_rows(rows(description, width, type, count));
  if (const GltfJson* sparse = object_member(description, "sparse")) add_sparse(*sparse, width, type, accessor);
  return accessor;
}

/// Rows that start at the offset of `place` in its buffer view.
GltfRows GltfDocument::rows(const GltfJson& place, std::size_t width, std::size_t type, std::size_t count) const {
  const GltfJson& view = entry("bufferViews", needed_number(place, "bufferView"));
  const std::size_t number = needed_number(view, "buffer");
  const GltfJson& buffer = entry("buffers", number);
  if (number != 0 || buffer.contains("uri")) {
    refuse_packed_view(view);
    refuse_gltf(buffer.contains("uri") ? "its buffer has a URI; only the binary chunk of the file itself is read"
                                       : "its buffer has no data");
  }
  const std::size_t begin = whole_number(view, "byteOffset").value_or(0);
  const std::size_t length = needed_number(view, "byteLength");
  if (begin > binary_.size() || length > binary_.size() - begin) refuse_gltf("its buffer view leads out of its buffer");
  const std::size_t offset = whole_number(place, "byteOffset").value_or(0);
  const std::size_t each = width * component_size(type);
  const std::size_t stride = whole_number(view, "byteStride").value_or(each);
  if (stride < each || stride > 252) refuse_gltf("its buffer view has an impossible stride");
  // All factors are small or compared by division, so nothing wraps around.
  const bool fits = offset <= length && length - offset >= each && count - 1 <= (length - offset - each) / stride;
  if (!fits) refuse_gltf("it leads out of its buffer view");
  return {binary_.substr(begin + offset, length - offset), stride, type};
}

void GltfDocument::add_sparse(const GltfJson& sparse, std::size_t width, std::size_t type, GltfAccessor& accessor) {
  const std::size_t count = needed_number(sparse, "count");
  const GltfJson* const places = object_member(sparse, "indices");
  const GltfJson* const values = object_member(sparse, "values");
  if (places == nullptr || values == nullptr) refuse_gltf("its sparse part has no indices or no values");
  if (count == 0 || count > accessor.count()) refuse_gltf("its sparse part has an impossible count");
  GltfAccessor place(count, 1, needed_number(*places, "componentType"), false);
  if (!place.is_index()) refuse_gltf("its sparse part has indices of an unknown component type");
  const GltfRows place_rows = rows(*places, 1, place.type(), count);
  place.set_rows(place_rows);
  spend(count);
  for (std::size_t i = 0; i < count; ++i) {
    const bool ascends = i == 0 || place.whole(i - 1) < place.whole(i);
    if (!ascends || place.whole(i) >= accessor.count()) refuse_gltf("the indices of its sparse part do not ascend");
  }
  accessor.set_sparse(count, place_rows, rows(*values, width, type, count));
}

}  // namespace dini
