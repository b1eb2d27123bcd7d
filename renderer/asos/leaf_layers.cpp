#include "renderer/asos/leaf_layers.h"

#include "renderer/asos/footprint_shape.h"

namespace asos {

bool LeafLayers::sampled(const PyrayLeaf& leaf) const {
  const SampleId sample = leaf.sample;
  return leaf.defocused || leaf.region.marginal || leaf.decision.cause == LeafVariation::layers ||
         !samples_->hit(sample).valid() || !samples_->opaque(sample) || samples_->cut_out(sample);
}

void LeafLayers::add(const PyrayLeaf& leaf) {
  const ViewedRay seen = eye_->viewer.viewed(
      samples_->ray(leaf.sample), samples_->hit(leaf.sample), eye_->side_of(leaf.weight),
      footprint_shape(leaf.region, samples_->at(leaf.sample)));
  sums_[leaf.root].add(probe_.at(seen, *eye_->counts), leaf.weight);
}

}  // namespace asos
