#pragma once

#include "renderer/film/layer_sums.h"

#include <span>
#include <vector>

namespace asos {

/// The layers of a block as a weighted mean over several renderings of it, such as the moments of
/// an exposure. Nearest values come from the rendering with the smallest distance.
class LayerMean {
 public:
  /// Returns the layers that renderings need for the mean of these: nearest values need distances.
  [[nodiscard]] static LayerSet needed(LayerSet asked);

  /// Adds a rendering, which has all `needed` layers. Weights have to add up to 1.
  void add(std::span<const LayerPlane> planes, double weight);
  /// Returns the mean of the layers that were asked for.
  [[nodiscard]] std::vector<LayerPlane> planes(LayerSet asked) const;

 private:
  struct Sum {
    LayerPlane nearest;          // of nearest values; of others only its layer counts
    std::vector<double> values;  // weighted sums
    std::vector<IdWeights> ids;
  };
  [[nodiscard]] std::vector<bool> nearer(std::span<const LayerPlane> planes) const;

  std::vector<Sum> sums_;
};

}  // namespace asos
