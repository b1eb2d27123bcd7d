#pragma once

#include "renderer/geometry/view.h"
#include "renderer/pyray/hit_list.h"
#include "renderer/pyray/subdivide.h"
#include "renderer/shading/light_transport.h"
#include "renderer/shadows/patch_caster.h"
#include "renderer/shadows/shadow_groups.h"
#include "renderer/shadows/shadow_settings.h"
#include "renderer/shadows/window_caster.h"

#include <cstdint>
#include <optional>
#include <span>

namespace asos {

/// The leaf of an eye pyray that is being shaded.
struct ShadedLeaf {
  LeafRegion region;       ///< of the eye frame's square
  float root_side = 1.0f;  ///< of the leaf's root: a pixel
  double share = 1.0;      ///< of the root's area
  std::uint64_t seed = 0;  ///< of the leaf
};

/// Memory of shadow pyrays that is worth keeping. Holds no result.
struct ShadowWorkspace {
  HitLists lists;
  HitLists::List list;
  Subdivider subdivider;
  std::vector<Side> sides;
  std::vector<double> ends;
};

/// How ASOS finds what reaches a point of a light: by pyrays between the light and the patch that a
/// leaf shows (CGF'98 section 4). Serves one block of pixels. Where nothing lies between a group of
/// coplanar points and a light, one ray tells for all of them.
class ShadowPyrays final : public LightTransport {
 public:
  /// `frame` is that of the block; all have to outlive this.
  ShadowPyrays(const ShadowScene& scene, const ShadowSettings& settings, const Frame& frame,
               ShadowGroups& groups, ShadowWorkspace& work);

  /// What is shaded from now on.
  void set_leaf(const ShadedLeaf& leaf) { leaf_ = leaf; }

  void add(const Illumination& lit, glm::vec3& radiance, RenderStatistics& counts) override;

  /// By how much the display intensity of a patch may differ from that at its middle because shadow
  /// edges of a light run through it, narrower than the patch or not much wider: 0 but for lights
  /// of some size (penumbra.cpp; design section 12, "Penumbrae narrower than the patch").
  /// `reflected`: what the patch makes of irradiance at most, radiance per irradiance.
  [[nodiscard]] float midpoint_error(const PreparedLight& light, std::uint32_t index,
                                     const SurfacePoint& point, const Patch& patch, float reflected,
                                     RenderStatistics& counts);

 private:
  [[nodiscard]] double lit_share(const Illumination& lit, RenderStatistics& counts);
  [[nodiscard]] double ray_share(const Illumination& lit, RenderStatistics& counts);
  [[nodiscard]] double window_share(const Illumination& lit, const SearchBounds& found,
                                    RenderStatistics& counts);
  [[nodiscard]] double segment_share(const Illumination& lit, const SearchBounds& found,
                                     RenderStatistics& counts);
  [[nodiscard]] double patch_share(const Illumination& lit, const ShadowPatch& patch,
                                   const SearchBounds& found, RenderStatistics& counts);
  [[nodiscard]] std::optional<ShadowPatch> patch_of(const SurfacePoint& point);
  [[nodiscard]] SubdivisionRules rules(const Illumination& lit) const;
  [[nodiscard]] int levels_left() const;
  void subdivide(const SubdivisionRules& rules, ShadowCaster& caster);

  const ShadowScene& scene_;
  ShadowSettings settings_;
  const Frame& frame_;
  ShadowGroups& groups_;
  ShadowWorkspace& work_;
  WindowCaster window_caster_;
  PatchCaster patch_caster_;
  ShadedLeaf leaf_;
};

}  // namespace asos
