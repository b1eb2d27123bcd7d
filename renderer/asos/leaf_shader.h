#pragma once

#include "renderer/asos/block_queue.h"
#include "renderer/asos/eye_context.h"
#include "renderer/asos/eye_samples.h"
#include "renderer/asos/leaf_chooser.h"
#include "renderer/asos/leaf_layers.h"
#include "renderer/asos/leaf_transport.h"
#include "renderer/asos/lobe_contributions.h"
#include "renderer/asos/root_sums.h"
#include "renderer/asos/selected_lights.h"
#include "renderer/asos/single_samples.h"
#include "renderer/asos/sky_contributions.h"
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
/// divided for their textures, or sampled. Shadows and reflections get the current leaf as an
/// argument (LeafContext).
class LeafShader {
 public:
  /// All arguments have to outlive this.
  LeafShader(const EyeContext& eye, EyeSamples& samples, LeafChooser& chooser,
             SelectedLights& selected_lights, const ShadowContext& shadows, std::span<RootSum> sums,
             BlurredSum& blurred, LeafLayers* layers);

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
  void shade_one(const PyrayLeaf& leaf);
  [[nodiscard]] RegionSampler& sampler();
  void defer(const PyrayLeaf& leaf, const RegionSampler::Goal& goal, bool planes);
  void start_regions();
  [[nodiscard]] bool worth_one_sample(const PyrayLeaf& leaf) const;
  void drop(std::uint32_t selected_share, std::uint32_t sky_share);
  void add(std::span<const Contribution> contributions, bool whole_leaves, const auto& light_of);
  [[nodiscard]] bool add_texture_samples(const PyrayLeaf& leaf);
  glm::vec3 add_leaf(const PyrayLeaf& leaf, UniformShadowPatch* even);
  bool add_estimate(const PyrayLeaf& leaf, const RegionSampler::Estimate& found);
  void note_result(std::uint32_t root, SampleId sample, glm::vec3 radiance);
  [[nodiscard]] const Material& material_of(const PyrayLeaf& leaf) const;
  [[nodiscard]] bool highlight_unsure(const PyrayLeaf& leaf, const LeafTransport& transport) const;
  [[nodiscard]] std::uint32_t enough_for(const PyrayLeaf& leaf, float highlights) const;
  [[nodiscard]] bool blurs_edge(const PyrayLeaf& leaf, const LeafTransport& transport) const;
  [[nodiscard]] bool light_misplaced(const PyrayLeaf& leaf, const LeafTransport& transport) const;
  [[nodiscard]] std::span<const WeightedShape> colour_parts(const PyrayLeaf& leaf, glm::vec2 at);
  [[nodiscard]] LeafContext context_of(const PyrayLeaf& leaf, UniformShadowPatch* even) const;

  const EyeContext* eye_;
  EyeSamples* samples_;
  LeafChooser* chooser_;
  SelectedLights* selected_lights_;
  SkyContributions sky_;
  LobeContributions lobes_;
  SingleSamples single_;
  const ShadowContext* shadows_;
  std::span<RootSum> sums_;
  BlurredSum* blurred_;
  std::unique_ptr<RegionSampler> sampler_;  // large, so made when first needed
  struct Deferred {
    PyrayLeaf leaf;       // without its border
    bool planes = false;  // its samples determine its surface layers
  };
  std::vector<Deferred> deferred_;  // in the sampler's order
  LeafLayers* layers_;              // null: no surface layer is asked for
  bool adds_light_;                 // parts of the radiance are among them
  bool adds_planes_ = false;        // the current leaf has no surface layers yet
  OpenRegions open_;
  std::vector<WeightedShape> parts_;  // of the leaf that is shaded
  std::map<SampleId, glm::vec3> results_;
};

}  // namespace asos
