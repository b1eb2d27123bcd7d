#pragma once

#include "renderer/geometry/view.h"
#include "renderer/pyray/hit_list.h"
#include "renderer/pyray/pyray_log.h"
#include "renderer/pyray/subdivide.h"
#include "renderer/sampling/sobol_points.h"
#include "renderer/shading/light_transport.h"
#include "renderer/shadows/extended_pyray.h"
#include "renderer/shadows/patch_caster.h"
#include "renderer/shadows/patch_view.h"
#include "renderer/shadows/shadow_groups.h"
#include "renderer/shadows/shadow_rules.h"
#include "renderer/shadows/window_caster.h"

#include <cstdint>
#include <optional>
#include <span>

namespace asos {

/// A part of a smooth surface over which no shadow of a light of some size varies by more than is
/// let pass: what is seen of each from its middle, found when first asked for, holds for all of it.
/// That of a light without size does where it is all or nothing.
struct EvenPatch {
  SurfacePoint middle;
  Square square;               ///< of the eye frame
  std::vector<double> shares;  ///< of each light, 0 to 1; negative: not known yet
};

/// The leaf of an eye pyray that is being shaded.
struct ShadedLeaf {
  LeafRegion region;          ///< of the eye frame's square
  float root_side = 1.0f;     ///< of the leaf's root: a pixel
  std::uint64_t seed = 0;     ///< of the leaf
  double weight = 1.0;        ///< the leaf's share of the root's area
  EvenPatch* even = nullptr;  ///< that it is a part of, if any
};

/// Where shadow pyrays to lights of some size start: clear of the surface.
[[nodiscard]] Receiver receiver_above(const SurfacePoint& point);
/// A thin strip around a linear light, which is the middle line of its square along u. Nothing for
/// a receiver on the light's own line.
[[nodiscard]] std::optional<Frame> strip_around(const PreparedLight& light,
                                                const Receiver& receiver);
/// How small boundaries are told apart in a shadow pyray.
[[nodiscard]] float finest_side(const SubdivisionRules& rules);
/// Two numbers in [0, 1).
[[nodiscard]] glm::dvec2 unit_pair_of(std::uint64_t bits);

/// Memory of shadow pyrays that is worth keeping. Holds no result.
struct ShadowWorkspace {
  HitLists lists;
  HitLists::List list;
  Subdivider subdivider;
  std::vector<Side> sides;
  std::vector<double> ends;
  std::vector<Ray> rays;
  std::vector<glm::vec2> places;
  std::vector<std::uint32_t> place_of;
  std::vector<SurfacePoint> seen;
  std::vector<std::optional<Receiver>> receivers;
  std::vector<double> weights;
  std::vector<float> shares;
  PyrayLog* log = nullptr;  ///< where pyrays are written down, if anywhere
};

/// How ASOS finds what reaches a point of a light: by pyrays between the light and the patch that a
/// leaf shows (CGF'98 section 4). Serves one block of pixels. Where nothing lies between a group of
/// coplanar points and a light, one ray tells for all of them.
class ShadowPyrays final : public LightTransport {
 public:
  /// `frame` is that of the block, whose viewer `view` is; all have to outlive this.
  ShadowPyrays(const ShadowScene& scene, const ShadowRules& settings, const Frame& frame,
               const PatchView& view, ShadowGroups& groups, ShadowWorkspace& work);

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
  [[nodiscard]] double even_share(const Illumination& lit, RenderStatistics& counts);
  [[nodiscard]] double ray_share(const Illumination& lit, RenderStatistics& counts);
  [[nodiscard]] double soft_share(const Illumination& lit, const SearchBounds& found,
                                  RenderStatistics& counts);
  // From one point (4.2).
  [[nodiscard]] double window_share(const Illumination& lit, const Receiver& receiver,
                                    const SearchBounds& found, RenderStatistics& counts);
  // Over the patch (shadow_qualities.cpp).
  [[nodiscard]] double divided_share(const Illumination& lit, const SearchBounds& found,
                                     RenderStatistics& counts);
  [[nodiscard]] double extended_share(const Illumination& lit, const Square& part,
                                      const SearchBounds& found, RenderStatistics& counts);
  [[nodiscard]] double adaptive_share(const Illumination& lit, const Square& part, int levels,
                                      const SearchBounds& found, RenderStatistics& counts);
  [[nodiscard]] std::optional<double> trace_extended(const Illumination& lit, const Square& part,
                                                     bool around, const SearchBounds& found,
                                                     RenderStatistics& counts);
  [[nodiscard]] double segment_share(const Illumination& lit, const SearchBounds& found,
                                     RenderStatistics& counts);
  [[nodiscard]] double patch_share(const Illumination& lit, ShadowPatch patch,
                                   const SearchBounds& found, RenderStatistics& counts);
  [[nodiscard]] std::optional<ShadowPatch> patch_of(const SurfacePoint& point, const Square& s);
  [[nodiscard]] SubdivisionRules rules(const Illumination& lit) const;
  SubdivisionOutcome subdivide(const Illumination& lit, const Root& root,
                               const SubdivisionRules& subdivision, ShadowCaster& caster);
  [[nodiscard]] int levels_used() const;
  [[nodiscard]] int levels_left() const;
  [[nodiscard]] bool uneven_at_last(const Illumination& lit, RenderStatistics& counts);
  [[nodiscard]] double thicket_share(const Illumination& lit, const LightWindow& window,
                                     const Receiver& receiver, RenderStatistics& counts);
  // By samples (thicket.cpp).
  void look_at_patch(const Illumination& lit, const SobolPixel& points, std::uint32_t first,
                     std::uint32_t end, RenderStatistics& counts);
  template <typename Aim>
  [[nodiscard]] double sampled_share(const Illumination& lit, RenderStatistics& counts, Aim aim);
  [[nodiscard]] SobolPixel points_of_leaf(const Illumination& lit) const;
  [[nodiscard]] double bent_patch_share(const Illumination& lit, RenderStatistics& counts);
  [[nodiscard]] double departure(const SurfacePoint& point, const ShadowPatch& patch) const;
  [[nodiscard]] bool bent(const Illumination& lit, const ShadowPatch& patch) const;
  [[nodiscard]] double sampling_error_let_pass(const Illumination& lit) const;
  [[nodiscard]] std::size_t most_entries_for_samples() const;
  [[nodiscard]] Root look_at_middle(ShadowCaster& caster);

  /// Whether the plane of a point's triangle is its surface for as far as a leaf goes.
  [[nodiscard]] bool flat(const SurfacePoint& point) const {
    return scene_.features.departure(point.triangle) <= 0.0f;
  }
  [[nodiscard]] bool found_thicket(const Illumination& lit) const;

  struct Thicket {
    glm::vec3 at{0.0f};
    std::uint32_t light = 0;
  };

  const ShadowScene& scene_;
  ShadowRules settings_;
  const Frame& frame_;
  const PatchView& view_;
  ShadowGroups& groups_;
  ShadowWorkspace& work_;
  WindowCaster window_caster_;
  PatchCaster patch_caster_;
  ExtendedCaster extended_caster_;
  ShadedLeaf leaf_;
  std::vector<Thicket> thickets_;  // patches around points of this block, found by midpoint_error
};

}  // namespace asos
