#pragma once

#include "geometry/bounding_box.h"
#include "golden/samples.h"

namespace dini {

/// The place on a model that is nearest to a sample. Of all pieces that are as near within `tie`, it has the color and
/// the normal that are most like those of the sample: at an edge the sample may be on either side.
struct NearestPlace {
  double distance = 0;
  double turned = -1;    ///< cosine between the normals
  double recolored = 1;  ///< the largest difference of a channel
  std::array<float, 4> color = {};
};

/// Compares samples with a model, which must outlive it. Pieces that lie together in the model are looked at together,
/// and most of them not at all.
class NearestPlaces {
 public:
  explicit NearestPlaces(const Shape& shape);

  /// The distance is infinite when the model has no piece.
  NearestPlace to(const Sample& sample, double tie) const;

 private:
  const Shape& shape_;
  std::vector<BoundingBox> boxes_;  ///< around so many pieces each, in their order
};

}  // namespace dini
