#pragma once

// The document of a GLB from outside: its entries, and the bytes and numbers in its binary chunk.

#include <cstddef>
#include <map>
#include <string_view>

#include "gltf/gltf_accessor.h"
#include "gltf/gltf_json.h"

namespace dini {

/// Members that are missing, of a wrong type or out of range throw GltfRefused. Nothing but the file's own binary chunk
/// is ever read.
class GltfDocument {
 public:
  GltfDocument(std::string_view glb, const Cancel& cancel);

  const GltfJson& root() const { return root_; }
  std::size_t bytes_behind() const { return bytes_behind_; }  ///< that follow the end of the file

  /// Entry `index` of the array `name` at the top: an object.
  const GltfJson& entry(const char* name, std::size_t index) const;
  std::size_t count(const char* name) const;

  /// Checked when it is asked for the first time.
  const GltfAccessor& accessor(std::size_t index);

  /// To be called with the number of steps before a loop whose length the file sets, since a small file can ask for the
  /// same values again and again. Refuses what is more than any good file needs, and stops when it is told to.
  void spend(std::size_t steps);
  /// One step of such a loop: looks at the cancel flag now and then.
  void step() {
    if (steps_.stopped()) throw GltfRefused{stopped_reading()};
  }

 private:
  GltfAccessor checked_accessor(std::size_t index);
  GltfRows rows(const GltfJson& place, std::size_t width, std::size_t type, std::size_t count) const;
  void add_sparse(const GltfJson& sparse, std::size_t width, std::size_t type, GltfAccessor& accessor);

  GltfJson root_;
  std::string_view binary_;
  std::size_t bytes_behind_ = 0;
  CancelEvery steps_;
  std::size_t steps_left_ = 24'000'000;  ///< four times the corners of two million triangles
  std::map<std::size_t, GltfAccessor> accessors_;
};

}  // namespace dini
