#pragma once

#include "renderer/asos/eye_context.h"
#include "renderer/asos/eye_samples.h"
#include "renderer/asos/leaf_chooser.h"
#include "renderer/asos/leaf_layers.h"
#include "renderer/asos/leaf_shader.h"
#include "renderer/asos/lens_roots.h"
#include "renderer/asos/root_sums.h"
#include "renderer/asos/selected_lights.h"
#include "renderer/pyray/caster.h"
#include "renderer/pyray/tracer.h"
#include "renderer/pyray/tuning.h"
#include "renderer/shadows/shadow_context.h"

#include <glm/glm.hpp>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace asos {

/// Scratch memory for the shadow pyrays and the reflected pyrays of leaves, by number of bounces.
/// Holds no result.
struct EyeWorkspace {
  ShadowWorkspace shadows;

  [[nodiscard]] Tracer& mirror_tracer(int bounce) {
    while (mirrors_.size() <= static_cast<std::size_t>(bounce))
      mirrors_.push_back(std::make_unique<Tracer>());
    return *mirrors_[static_cast<std::size_t>(bounce)];
  }

 private:
  std::vector<std::unique_ptr<Tracer>> mirrors_;
};

/// The engine's Caster for eye pyrays and reflected pyrays. It joins the block's samples, the data
/// beyond single samples (covers, normals) and the shading of leaves. A root is a pixel.
class EyeCaster final : public Caster {
 public:
  EyeCaster(const EyeContext& eye, std::size_t roots);
  EyeCaster(const EyeCaster&) = delete;
  EyeCaster& operator=(const EyeCaster&) = delete;

  SampleId probe(std::span<const glm::vec2> points) override { return samples_.probe(points); }
  [[nodiscard]] LensCaster* lens() override { return lens_ ? &*lens_ : nullptr; }
  /// Finds the shadow pyrays' common occluders, the variation of normals, and the sampled lights,
  /// from the surfaces at the pixel centres.
  void middles_known(int side) override;
  /// Replaces `middles_known` for a caller that sends one ray only.
  void sends_one_ray() { selected_lights_.take_all(); }
  [[nodiscard]] OccluderPlane cover(SampleId sample) const override {
    return samples_.cover(sample);
  }
  [[nodiscard]] std::uint32_t surface(SampleId sample) const override {
    return samples_.surface(sample);
  }
  [[nodiscard]] bool opaque(SampleId sample) const override { return samples_.opaque(sample); }
  [[nodiscard]] bool samples_leaf(SampleId sample) const override {
    return samples_.cut_out(sample) && eye_.error_budget.refines();
  }
  [[nodiscard]] LeafDecision decide(const PyrayLeaf& leaf, bool may_split) override {
    return chooser_.decide(leaf, may_split);
  }
  [[nodiscard]] bool samples_suffice(double weight, std::size_t parts) const override {
    const double cost = chooser_.part_price() * static_cast<double>(parts);
    return shades_parts_ && choose(eye_.error_budget, weight, ErrorBound::none(),
                                   {cost, {}, LeafTuning::contrast_of_many}) == Estimator::samples;
  }
  [[nodiscard]] SampleId sample_saturated(std::uint32_t root, const Square& square,
                                          double weight) override;
  void finish() override { leaf_shader_.finish(); }
  [[nodiscard]] bool cancelled() const override { return eye_.stop.stop_requested(); }
  void take(std::span<const PyrayLeaf> leaves) override { leaf_shader_.shade(leaves); }
  [[nodiscard]] glm::vec3 result(SampleId sample) const override {
    return leaf_shader_.result(sample);
  }
  [[nodiscard]] std::uint32_t triangle(SampleId sample) const override {
    return samples_.hit(sample).triangle;
  }

  /// Returns the colour of a root: the mean of its leaves. Samples that are not finite are left out
  /// and counted.
  [[nodiscard]] glm::vec3 colour(std::uint32_t root) const;
  [[nodiscard]] const RootSum& sum(std::uint32_t root) const { return sums_[root]; }
  /// Takes the camera's parts that still need samples. No sum contains them yet.
  [[nodiscard]] OpenRegions take_open() { return leaf_shader_.take_open(); }
  /// Takes the surface layers of the roots, without the open parts. Empty if none is requested.
  [[nodiscard]] std::vector<LayerSum> take_layers() {
    return layers_ ? layers_->take() : std::vector<LayerSum>();
  }

 private:
  EyeContext eye_;
  bool casts_shadows_;  // some light casts shadows
  bool shades_parts_;   // parts may cost more than samples: some lit surface may be in shadow
  EyeSamples samples_;
  ShadowScene shadow_scene_;
  ShadowGroups groups_;
  ShadowContext shadows_;
  SelectedLights selected_lights_;
  LeafChooser chooser_;
  std::vector<RootSum> sums_;
  BlurredSum blurred_;
  std::optional<LeafLayers> layers_;  // none: no surface layers are asked for
  LeafShader leaf_shader_;
  std::optional<LensRoots> lens_;
};

}  // namespace asos
