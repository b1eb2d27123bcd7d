#pragma once

#include "renderer/asos/defocus.h"
#include "renderer/asos/eye_context.h"
#include "renderer/asos/eye_samples.h"
#include "renderer/asos/leaf_chooser.h"
#include "renderer/asos/leaf_shader.h"
#include "renderer/pyray/lens_caster.h"

#include <cstdint>
#include <span>
#include <vector>

namespace asos {

/// The engine's LensCaster for a camera with a lens. Each pixel is rendered as through a pinhole,
/// as one wide leaf, or by samples over pixel and lens.
class LensRoots final : public LensCaster {
 public:
  /// All arguments have to outlive this. `eye` has a Defocus.
  LensRoots(const EyeContext& eye, EyeSamples& samples, LeafChooser& chooser, LeafShader& shader,
            std::size_t roots);
  LensRoots(const LensRoots&) = delete;
  LensRoots& operator=(const LensRoots&) = delete;

  [[nodiscard]] LensEstimator way(std::uint32_t root, bool bounded, bool missed) override;
  [[nodiscard]] bool shade_smooth(std::uint32_t root) override;
  [[nodiscard]] Square widened_square(std::uint32_t root) const override;
  void sample_root(std::uint32_t root) override;
  [[nodiscard]] Caster& trial() override { return trial_; }
  [[nodiscard]] bool stayed_sharp(std::uint32_t root) const override { return !blurred_[root]; }

 private:
  /// Receives the leaves of sharp roots, and records roots with a blurred leaf.
  class Trial final : public Caster {
   public:
    explicit Trial(LensRoots& roots) : roots_(&roots) {}
    SampleId probe(std::span<const glm::vec2> points) override {
      return roots_->samples_->probe(points);
    }
    [[nodiscard]] OccluderPlane cover(SampleId sample) const override {
      return roots_->samples_->cover(sample);
    }
    [[nodiscard]] std::uint32_t surface(SampleId sample) const override {
      return roots_->samples_->surface(sample);
    }
    [[nodiscard]] bool opaque(SampleId sample) const override {
      return roots_->samples_->opaque(sample);
    }
    [[nodiscard]] bool cancelled() const override { return roots_->eye_->stop.stop_requested(); }
    void take(std::span<const PyrayLeaf> leaves) override;

   private:
    LensRoots* roots_;
  };

  [[nodiscard]] bool shows_other_depths(SampleId sample) const;
  [[nodiscard]] std::uint32_t samples_for_lights(std::uint32_t root) const;
  [[nodiscard]] bool sharp_leaf(SampleId sample) const;

  const EyeContext* eye_;
  EyeSamples* samples_;
  LeafChooser* chooser_;
  LeafShader* shader_;
  std::vector<bool> blurred_;
  Trial trial_{*this};
};

}  // namespace asos
