#pragma once

#include "renderer/asos/eye_context.h"
#include "renderer/asos/sky_shares.h"
#include "renderer/asos/weak_lights.h"
#include "renderer/shading/light_transport.h"
#include "renderer/shadows/shadow_context.h"

namespace asos {

/// The lights and reflections of one leaf: what the shader asks while it shades the leaf's point.
class LeafTransport final : public LightTransport {
 public:
  /// `weak_share` and `sky_share`: the leaf's.
  LeafTransport(const EyeContext& eye, const ShadowContext& shadows, const LeafContext& leaf,
                WeakLights& weak, std::uint32_t weak_share, SkyShares& sky, std::uint32_t sky_share)
      : eye_(&eye),
        shadows_(&shadows),
        leaf_(&leaf),
        weak_(&weak),
        weak_share_(weak_share),
        sky_(&sky),
        sky_share_(sky_share) {}

  TakenLights gather(const LitPoint& point) override;
  void add(const Illumination& lit, glm::vec3& radiance, RenderStatistics& counts) override;
  bool add_sky(const SkyLitPoint& point, glm::vec3& radiance, RenderStatistics& counts) override;
  bool reflect(const Reflection& reflection, glm::vec3& radiance,
               RenderStatistics& counts) override;

  /// Of mirrored leaves: what the weak lights add to the radiance.
  [[nodiscard]] glm::vec3 at_once() const { return at_once_; }
  /// Whether a light without a size took more than one ray and was seen in part.
  [[nodiscard]] bool met_shadow_edge() const { return met_shadow_edge_; }
  /// Whether a boundary divided what the leaf mirrors.
  [[nodiscard]] bool met_mirror_edge() const { return met_mirror_edge_; }
  /// Whether bent mirrors, one in the other, may show a bright light elsewhere.
  [[nodiscard]] bool misplaces_light() const { return misplaces_light_; }

  /// The most that a lobe returns of what it mirrors, which is for samples to find out; 0: none
  /// mirrors.
  [[nodiscard]] glm::vec3 lobes() const { return lobes_; }

  /// By how much highlights may be off, in radiance: of a light that is seen in part they show as
  /// much as the irradiance does, whichever part it is.
  [[nodiscard]] float unsure_highlights() const { return unsure_highlights_; }

 private:
  [[nodiscard]] float unsure_share(const Illumination& lit, glm::vec3 seen) const;

  const EyeContext* eye_;
  const ShadowContext* shadows_;
  const LeafContext* leaf_;
  WeakLights* weak_;
  std::uint32_t weak_share_;
  SkyShares* sky_;
  std::uint32_t sky_share_;
  glm::vec3 at_once_{0.0f};
  glm::vec3 lobes_{0.0f};
  float unsure_highlights_ = 0.0f;
  bool met_shadow_edge_ = false;
  bool met_mirror_edge_ = false;
  bool misplaces_light_ = false;
};

}  // namespace asos
