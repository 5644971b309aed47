#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "golden/samples.h"
#include "graph/file.h"

namespace dini {

/// What is kept of a model to compare others with. Lengths in meters.
struct ModelFacts {
  std::string sha256;         ///< of the file, 64 hexadecimal digits
  double position_error = 0;  ///< of the file: no point in it is farther from its original
  std::size_t triangles = 0;
  std::size_t segments = 0;  ///< of curves
  std::size_t points = 0;    ///< that stand alone
  Vector low, high;          ///< bounds of everything
  double area = 0;
  double volume = 0;    ///< signed; enclosed only when `closed`
  long long euler = 0;  ///< of all triangles together
  bool closed = false;  ///< every edge has two triangles
  double edges = 0;     ///< half the sum of all triangles' edges: how much area a small shift of corners can change
  double spacing = 0;   ///< nothing of the model is farther than this from a sample
  std::vector<Sample> samples = {};
};

/// A model with what is told of it.
struct Model {
  ModelFacts facts;
  Shape shape;
};

/// What is told of a shape that was read from these bytes.
Model model_of_shape(Shape shape, std::string_view bytes, double position_error);

/// Reads a file that an export made as GLB with Draco; nothing for any other.
std::optional<Model> model_of(const File& file);

/// The same where only the bytes are known. They do not tell what positions are rounded by: it is taken to be what the
/// 14 bits of an export with its defaults are.
std::optional<Model> model_of_bytes(std::string_view bytes);

}  // namespace dini
