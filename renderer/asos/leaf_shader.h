#pragma once

#include "renderer/asos/block_queue.h"
#include "renderer/asos/eye_context.h"
#include "renderer/asos/eye_samples.h"
#include "renderer/asos/leaf_chooser.h"
#include "renderer/asos/leaf_layers.h"
#include "renderer/asos/leaf_transport.h"
#include "renderer/asos/root_sums.h"
#include "renderer/asos/sampled_contributions.h"
#include "renderer/asos/selected_lights.h"
#include "renderer/asos/single_samples.h"
#include "renderer/samples/region_sampler.h"
#include "renderer/shadows/shadow_context.h"

#include <cstdint>
#include <map>
#include <memory>
#include <span>
#include <utility>
#include <vector>

namespace asos {

/// Computes the radiance of a block's leaves and adds it to their roots. Leaves are shaded whole,
/// divided for their textures, or sampled.
class LeafShader {
 public:
  /// All arguments have to outlive this.
  LeafShader(const EyeContext& eye, EyeSamples& samples, LeafChooser& chooser,
             const SelectedLights& selected_lights, const ShadowContext& shadows,
             std::span<RootSum> sums, BlurredSum& blurred, LeafLayers* layers);

  void shade(std::span<const PyrayLeaf> leaves);

  /// Samples a part of a root, with at least `fewest` samples spread evenly over the part and each
  /// light. The leaf's sample identifies the result. Returns false if no sample hit the region. A
  /// camera's parts are deferred until `finish`, to share packets of rays.
  bool add_samples(const PyrayLeaf& leaf, std::uint32_t fewest = 1);
  /// Samples a root over pixel and lens, with at least `fewest` samples, deferred until `finish`.
  /// `sample` is at the root's centre.
  void sample_defocused(std::uint32_t root, SampleId sample, std::uint32_t fewest = 1);
  /// Determines the deferred parts. Then all sums are complete except those with open regions.
  void finish();
  /// Takes the regions that `finish` left open.
  [[nodiscard]] OpenRegions take_open() { return std::exchange(open_, {}); }

  /// Returns the radiance of a leaf of the observed root.
  [[nodiscard]] glm::vec3 result(SampleId sample) const;

 private:
  void shade_one(const PyrayLeaf& part);
  [[nodiscard]] RegionSampler& sampler();
  void defer(const PyrayLeaf& leaf, const RegionSampler::Goal& goal);
  [[nodiscard]] bool adds_planes(const PyrayLeaf& leaf) const {
    return layers_ && layers_->sampled(leaf);
  }
  void start_regions();
  [[nodiscard]] bool worth_one_sample(const PyrayLeaf& leaf) const;
  void add(std::span<const Contribution> contributions, bool whole_leaves, const auto& light_of);
  [[nodiscard]] bool add_texture_samples(const Leaf& leaf);
  glm::vec3 add_leaf(const Leaf& leaf);
  bool add_estimate(const PyrayLeaf& leaf, const RegionSampler::Mean& found);
  void note_result(std::uint32_t root, SampleId sample, glm::vec3 radiance);
  [[nodiscard]] bool suffices(const Leaf& leaf, const Estimate& centre) const;
  [[nodiscard]] std::uint32_t enough_for(const Leaf& leaf, float highlights) const;
  [[nodiscard]] std::span<const WeightedShape> colour_parts(const Leaf& leaf);

  const EyeContext* eye_;
  EyeSamples* samples_;
  LeafChooser* chooser_;
  const SelectedLights* selected_lights_;
  SampledContributions direct_, lobes_;
  SingleSamples single_;
  const ShadowContext* shadows_;
  std::span<RootSum> sums_;
  BlurredSum* blurred_;
  std::unique_ptr<RegionSampler> sampler_;  // large, so made when first needed
  std::vector<PyrayLeaf> deferred_;         // in the sampler's order, without borders
  LeafLayers* layers_;                      // null: no surface layer is asked for
  bool adds_light_;                         // parts of the radiance are among them
  bool adds_planes_ = false;                // the current leaf has no surface layers yet
  OpenRegions open_;
  std::vector<WeightedShape> parts_;  // of the leaf that is shaded
  std::map<SampleId, glm::vec3> results_;
};

}  // namespace asos
