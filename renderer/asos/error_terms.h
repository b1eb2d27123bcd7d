#pragma once

#include "renderer/asos/eye_context.h"
#include "renderer/asos/eye_samples.h"
#include "renderer/asos/normal_variation.h"
#include "renderer/asos/selected_lights.h"
#include "renderer/shading/highlight_unevenness.h"
#include "renderer/shadows/shadow_context.h"

#include <glm/glm.hpp>

#include <vector>

namespace asos {

/// Bounds on the difference between a leaf's centre and its mean, one per cause, in display
/// intensity (design section 14; CGF'98 sections 3.2, 4.3 and 5.2). Terms are independent of each
/// other and of their order. A term that cannot bound its error returns an unbounded one; then only
/// samples determine the leaf.
class ErrorTerms {
 public:
  /// All arguments have to outlive this.
  ErrorTerms(const EyeContext& eye, const EyeSamples& samples,
             const SelectedLights& selected_lights, const ShadowContext& shadows);

  /// Computes the variation of normals between pixels from the first samples: the centres of side x
  /// side roots, row by row.
  void learn_normals(int side);

  /// Alpha-blended surfaces in front of each other, and cut-outs without known outlines.
  [[nodiscard]] ErrorBound layers(const Leaf& leaf) const;
  /// Textures and vertex colours that the footprint of one hit does not average.
  [[nodiscard]] ErrorBound textures(const Leaf& leaf) const;
  /// Normal maps, and triangles as small as the leaf, that scatter light.
  [[nodiscard]] ErrorBound bumps(const Leaf& leaf) const;
  /// Curvature of the shading normal, the inverse square law, and highlights of point lights.
  [[nodiscard]] ErrorBound bend(const Leaf& leaf) const;
  /// Irradiance near lights with an extent, and at the rims of spotlights.
  [[nodiscard]] ErrorBound falloff(const Leaf& leaf) const;
  /// Fresnel reflectance at grazing angles, and highlights of lights with an extent.
  [[nodiscard]] ErrorBound gloss(const Leaf& leaf) const;
  /// The widening of a pyray by a curved mirror or refractor (CGF'98 sections 5.2.1 to 5.2.4).
  [[nodiscard]] ErrorBound mirror(const Leaf& leaf) const;
  /// Edges of soft shadows (CGF'98 section 4.3). Adds to leaf.behind_detail.
  [[nodiscard]] ErrorBound penumbra(Leaf& leaf) const;

  /// Returns the sum of all terms but layers and penumbrae. Ends early once a term is unbounded.
  [[nodiscard]] ErrorBound shading(const Leaf& leaf) const;

  /// Returns whether a light with an extent casts shadows.
  [[nodiscard]] bool soft_shadows() const { return soft_shadows_; }
  /// Returns the cost of one leaf's soft shadows, in samples.
  [[nodiscard]] double cost_of_shadows() const;

  /// Returns whether a sampled mirror leaf may show a light without geometry that is brighter than
  /// white. Its own reflected pyray places such a light less exactly than samples do.
  [[nodiscard]] bool may_misplace_light(const Leaf& leaf) const;

 private:
  [[nodiscard]] ErrorBound bumps_with(const Leaf& leaf, const auto& gloss_of) const;
  [[nodiscard]] bool sparkles(const Leaf& leaf) const;
  [[nodiscard]] bool varies_behind(const Leaf& leaf, const ViewedRay& seen, const Hit& hit) const;
  [[nodiscard]] HighlightError highlights_error(const GlossyPatch& glossy) const;
  [[nodiscard]] double mirrored_width(const Leaf& leaf) const;
  [[nodiscard]] double strayed_width(const Leaf& leaf, const MirrorSurface& mirror,
                                     float side) const;
  [[nodiscard]] glm::ivec2 pixel_of(const LeafRegion& region) const;
  [[nodiscard]] bool casts_soft_shadow(std::uint32_t light) const;

  const EyeContext* eye_;
  const EyeSamples* samples_;
  const SelectedLights* selected_lights_;
  const ShadowContext* shadows_;
  bool soft_shadows_;
  bool spots_;
  NormalVariation normals_;
  int border_ = 0;  // pixels of the frame around the roots
};

}  // namespace asos
