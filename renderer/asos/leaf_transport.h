#pragma once

#include "renderer/asos/eye_context.h"
#include "renderer/asos/selected_lights.h"
#include "renderer/shading/light_transport.h"
#include "renderer/shadows/shadow_context.h"

namespace asos {

/// Computes the lights and reflections of one leaf while the shader shades the leaf's point.
class LeafTransport final : public LightTransport {
 public:
  LeafTransport(const EyeContext& eye, const ShadowContext& shadows, const Leaf& leaf,
                const SelectedLights& selected)
      : eye_(&eye), shadows_(&shadows), leaf_(&leaf), selected_(&selected) {}

  HandledLights gather(const LightingQuery& point) override;
  void add(const Illumination& lit, glm::vec3& radiance, RenderStatistics& counts) override;
  bool add_sky(const SkyQuery& point, glm::vec3& radiance, RenderStatistics& counts) override;
  bool reflect(const Reflection& reflection, glm::vec3& radiance,
               RenderStatistics& counts) override;
  void note(LightPart part, glm::vec3 radiance) override { light_.add(part, glm::dvec3(radiance)); }

  /// Divides the leaf's radiance so far into its parts.
  [[nodiscard]] LightSum light(glm::vec3 radiance) const;
  /// Returns whether selected lights may illuminate the leaf. They have to be sampled.
  [[nodiscard]] bool lit_by_selected() const { return lit_by_selected_; }
  /// Returns whether the edge of a hard shadow cuts the leaf: a point light took more than one ray
  /// and was partially occluded.
  [[nodiscard]] bool shadow_cut() const { return shadow_cut_; }
  /// Returns whether a boundary divided the leaf's reflection.
  [[nodiscard]] bool mirror_cut() const { return mirror_cut_; }

  /// Returns the estimate of the leaf by its centre, with this radiance. Its error is that of its
  /// lights and reflections. It is infinite if a bright light may be misplaced, or if an edge cuts
  /// a defocused leaf, whose parts the lens kernel weights unequally.
  [[nodiscard]] Estimate centre(glm::vec3 radiance) const;

  /// Returns the largest reflectance of the lobes whose reflection has to be sampled, and of all
  /// surfaces if the sky may be occluded; 0 if there are none.
  [[nodiscard]] glm::vec3 lobes() const { return lobes_; }
  /// Returns whether lobes show the scene. Without, they show the sky and its occlusion.
  [[nodiscard]] bool lobes_show_scene() const { return lobes_show_scene_; }

  /// Returns the bound on the error of highlights, in radiance. The highlight of a partially
  /// occluded light is scaled by the visible fraction of the irradiance, whichever part of the
  /// light is visible.
  [[nodiscard]] float unsure_highlights() const { return unsure_highlights_; }

 private:
  [[nodiscard]] float unsure_share(const Illumination& lit, glm::vec3 seen) const;

  const EyeContext* eye_;
  const ShadowContext* shadows_;
  const Leaf* leaf_;
  const SelectedLights* selected_;
  glm::vec3 lobes_{0.0f};
  LightSum light_;  // parts other than direct light
  float unsure_highlights_ = 0.0f;
  double reflection_error_ = 0.0;
  bool lit_by_selected_ = false;
  bool lobes_show_scene_ = false;
  bool shadow_cut_ = false;
  bool mirror_cut_ = false;
};

}  // namespace asos
