#pragma once

#include <cstddef>

namespace dini {

/// Every limit of an evaluation, by name. `GET /version` prints them.
struct Limits {
  std::size_t body_bytes = std::size_t{1} << 20;
  std::size_t json_depth = 32;
  std::size_t json_values = 200'000;
  std::size_t string_bytes = 64 * 1024;
  std::size_t nodes = 2'000;
  std::size_t links = 8'000;
  std::size_t samples = 20'000'000;                  ///< values on one wire
  std::size_t vertices = 5'000'000;                  ///< of one result
  std::size_t triangles = 10'000'000;                ///< of one result
  std::size_t request_bytes = std::size_t{4} << 30;  ///< predicted memory of one evaluation
  std::size_t work = 40'000'000'000;  ///< predicted nanoseconds of one processor: the longest deadline on four of them
  std::size_t sweep_variants = 10'000;
  std::size_t sweep_work = 3'600'000'000'000;  ///< predicted nanoseconds of one processor for all variants
  std::size_t cache_bytes = std::size_t{1} << 30;
  std::size_t interactive_milliseconds = 10'000;
  std::size_t sweep_milliseconds = 3'600'000;
  std::size_t previews = 64;                               ///< entries of `preview` in one request
  std::size_t preview_elements = 400;                      ///< drawn of one previewed output
  std::size_t preview_points = 10'000;                     ///< loose points drawn of one previewed output
  std::size_t measures = 256;                              ///< entries of `measures` in one request
  std::size_t measured_values = 10'000;                    ///< of one measure
  std::size_t asset_bytes = std::size_t{16} << 20;         ///< of one uploaded file
  std::size_t asset_vertices = 1'000'000;                  ///< in one file, after seams are split
  std::size_t asset_triangles = 2'000'000;                 ///< in one file
  std::size_t asset_store_bytes = std::size_t{256} << 20;  ///< memory of all uploaded meshes; the least used go first
};

}  // namespace dini
