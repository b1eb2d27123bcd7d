#pragma once

#include "renderer/asos/error_bound.h"
#include "renderer/asos/eye_context.h"
#include "renderer/asos/eye_samples.h"
#include "renderer/asos/leaf.h"
#include "renderer/asos/normal_variation.h"
#include "renderer/asos/weak_lights.h"
#include "renderer/shading/highlight_unevenness.h"
#include "renderer/shadows/light_view.h"
#include "renderer/shadows/shadow_context.h"

#include <glm/glm.hpp>

#include <vector>

namespace asos {

/// Bounds on the difference between a leaf's centre and its mean, one for each cause, in display
/// intensity (design section 14; CGF'98 sections 3.2, 4.3 and 5.2). No term uses another one, and
/// their order does not matter. A term that cannot bound its error says so: then only samples
/// determine the leaf.
class ErrorTerms {
 public:
  /// All have to outlive this.
  ErrorTerms(const EyeContext& eye, const EyeSamples& samples, const WeakLights& weak_lights,
             const ShadowContext& shadows);

  /// Takes the normals' variation between pixels from the first samples, the centres of side x side
  /// roots in rows.
  void learn_normals(int side);

  /// Surfaces that blend, one behind the other, and cut-outs without outlines.
  [[nodiscard]] ErrorBound layers(const Leaf& leaf) const;
  /// Textures and vertex colours that the footprint of one hit does not average.
  [[nodiscard]] ErrorBound textures(const Leaf& leaf) const;
  /// Normal maps, and triangles as small as the leaf, that scatter light.
  [[nodiscard]] ErrorBound bumps(const Leaf& leaf) const;
  /// The turn of the shading normal, the inverse square law, and highlights of lights without size.
  [[nodiscard]] ErrorBound bend(const Leaf& leaf) const;
  /// Normals that turn unevenly from one pixel to the next.
  [[nodiscard]] ErrorBound normals(const Leaf& leaf) const;
  /// Irradiance near lights of some size, and at the rims of spots.
  [[nodiscard]] ErrorBound falloff(const Leaf& leaf) const;
  /// Fresnel reflectance at grazing angles, and highlights of lights of some size.
  [[nodiscard]] ErrorBound gloss(const Leaf& leaf) const;
  /// The widening of a pyray by a curved mirror or refractor (CGF'98 sections 5.2.1 to 5.2.4).
  [[nodiscard]] ErrorBound mirror(const Leaf& leaf) const;
  /// Edges of soft shadows (CGF'98 section 4.3). Adds the lights' views that it finds to `views`.
  [[nodiscard]] ErrorBound penumbra(const Leaf& leaf, LightViews& views) const;

  /// The sum of all but layers and penumbrae; ends early where there is no bound.
  [[nodiscard]] ErrorBound shading(const Leaf& leaf) const;

  /// Whether some light of some size casts shadows.
  [[nodiscard]] bool soft_shadows() const { return soft_shadows_; }
  /// Of one leaf's soft shadows, in samples.
  [[nodiscard]] double price_of_shadows() const;

  /// Whether a leaf that is sampled in a mirror may show a light without geometry that is brighter
  /// than white: its own mirrored pyray places that worse than samples do.
  [[nodiscard]] bool may_misplace_light(const Leaf& leaf) const;

 private:
  [[nodiscard]] bool glints(const Leaf& leaf) const;
  [[nodiscard]] bool varies_behind(const Leaf& leaf, const ViewedRay& seen, const Hit& hit) const;
  [[nodiscard]] HighlightError highlights_error(const GlossyPatch& glossy) const;
  [[nodiscard]] double mirrored_width(const Leaf& leaf) const;
  [[nodiscard]] double strayed_width(const Leaf& leaf, const MirrorSurface& mirror,
                                     float side) const;
  [[nodiscard]] glm::ivec2 pixel_of(const LeafRegion& region) const;
  [[nodiscard]] bool casts_soft_shadow(std::uint32_t light) const;

  const EyeContext* eye_;
  const EyeSamples* samples_;
  const WeakLights* weak_lights_;
  const ShadowContext* shadows_;
  bool soft_shadows_;
  bool spots_;
  NormalVariation normals_;
  int border_ = 0;  // pixels of the frame around the roots
};

}  // namespace asos
