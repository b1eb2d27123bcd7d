#pragma once

#include "renderer/asos/eye_context.h"
#include "renderer/asos/eye_samples.h"
#include "renderer/film/layer_sums.h"
#include "renderer/pyray/caster.h"
#include "renderer/samples/layer_probe.h"

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace asos {

/// The surface layers of a block's roots, summed over their leaves. A leaf shows one surface and
/// has a known area, so that coverage is exact; parts that show several are sampled.
class LeafLayers {
 public:
  /// Both references have to outlive it.
  LeafLayers(const EyeContext& eye, const EyeSamples& samples, std::size_t roots)
      : eye_(&eye),
        samples_(&samples),
        probe_(*eye.scene, eye.viewer, *eye.settings),
        sums_(roots) {}

  /// Returns whether the leaf may show several surfaces, so that its samples are counted.
  [[nodiscard]] bool sampled(const PyrayLeaf& leaf) const;
  /// Adds a leaf by its one sample.
  void add(const PyrayLeaf& leaf);
  /// Adds a part by its samples; without any, only their radiance's parts.
  void add(std::uint32_t root, const LayerSum& part, double weight) {
    sums_[root].add(part, weight);
  }
  /// Adds the radiance of a leaf of this weight, by part.
  void add_light(std::uint32_t root, const LightSum& leaf, double weight) {
    sums_[root].light.add(leaf, weight);
  }
  /// Adds a part of the radiance of a leaf whose weight is added elsewhere.
  void add_radiance(std::uint32_t root, const LightSum& part, double weight) {
    sums_[root].light.add_radiance(part, weight);
  }
  [[nodiscard]] std::vector<LayerSum> take() { return std::exchange(sums_, {}); }

 private:
  const EyeContext* eye_;
  const EyeSamples* samples_;
  LayerProbe probe_;
  std::vector<LayerSum> sums_;
};

}  // namespace asos
