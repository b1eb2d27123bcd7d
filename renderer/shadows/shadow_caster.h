#pragma once

#include "renderer/film/statistics.h"
#include "renderer/pyray/caster.h"
#include "renderer/shadows/leaf.h"
#include "renderer/shadows/shadow_scene.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace asos {

/// Fraction of the way to a light that a shadow ray covers, so that the light's own surface does
/// not shade it.
inline constexpr float most_of_the_way = 1.0f - 1e-5f;

/// The engine's Caster for shadow pyrays: computes the visibility of a light over a square, with
/// the measure of a derived class. One object serves one pyray after another and reuses its memory.
class ShadowCaster : public Caster {
 public:
  [[nodiscard]] SampleId probe(std::span<const glm::vec2> points) override;
  [[nodiscard]] OccluderPlane cover(SampleId sample) const override;
  [[nodiscard]] std::uint32_t surface(SampleId sample) const override;
  /// Splits leaves on transparent surfaces, and on some cut-outs, since their outlines are not
  /// boundaries.
  [[nodiscard]] LeafDecision decide(const PyrayLeaf& leaf, bool may_split) override;
  void take(std::span<const PyrayLeaf> leaves) override;
  /// Returns the visibility of the light from a sample.
  [[nodiscard]] glm::vec3 result(SampleId sample) const override {
    return samples_[sample].counts ? samples_[sample].blocker.transmittance : glm::vec3(0.0f);
  }

  /// Returns the light's visibility after all leaves were taken. Returns nothing if no sample
  /// counts.
  [[nodiscard]] std::optional<Visibility> visibility() const;
  [[nodiscard]] std::uint64_t rays_cast() const { return cast_; }
  /// Returns whether a sample hit a surface with varying transmittance.
  [[nodiscard]] bool met_see_through() const;

 protected:
  /// All arguments have to outlive the pyray. `see_through`: see ShadowRules.
  void start(const ShadowScene& scene, bool see_through, const Frame& frame,
             std::int32_t ignored_part);

  /// Returns the ray whose blockers shade a point of the square; nothing for points that do not
  /// count.
  [[nodiscard]] virtual std::optional<Ray> ray_at(glm::vec2 p) const = 0;
  /// Returns the weight of a leaf that counts.
  [[nodiscard]] virtual double measure(double weight, const LeafRegion& region) const = 0;

 private:
  struct Sample {
    Blocker blocker;
    Ray ray;
    bool counts = false;
  };

  const ShadowScene* scene_ = nullptr;
  const Frame* frame_ = nullptr;
  bool see_through_ = true;
  std::int32_t ignored_part_ = -1;
  std::vector<Sample> samples_;
  std::vector<Ray> rays_;
  std::vector<std::uint32_t> asked_;
  std::vector<Blocker> blockers_;
  std::uint64_t cast_ = 0;
  Visibility seen_{0.0};
  double all_ = 0.0;
};

}  // namespace asos
