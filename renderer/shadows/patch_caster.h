#pragma once

#include "renderer/geometry/half_space.h"
#include "renderer/pyray/square.h"
#include "renderer/shadows/shadow_caster.h"

#include <array>
#include <optional>
#include <span>

namespace asos {

/// The patch of a surface that a leaf of a parent pyray shows: the four corners on the surface's
/// plane of the leaf's square, in the order (0,0), (1,0), (0,1), (1,1), and the part of the square
/// that the leaf covers.
struct ShadowPatch {
  std::array<glm::dvec3, 4> corners;
  HalfSpace plane;                     ///< above: the side that is seen
  std::span<const BorderEdge> border;  ///< in units of the square; empty: all of it
  double lift = 0.0;                   ///< how far above the plane rays have to end
};

/// From a light that is a point, or infinitely far, over a patch (CGF'98 section 4.1). A leaf is
/// worth its share of the patch as the viewer sees it: the square that the light sees through the
/// patch's corners has the parent's own coordinates, for both see one plane.
class PatchCaster final : public ShadowCaster {
 public:
  /// The frame from a point light; nothing where the light lies in the patch's plane or the corners
  /// do not go around it.
  [[nodiscard]] static std::optional<Frame> frame_from(glm::dvec3 light, const ShadowPatch& patch);
  /// The frame of parallel light that comes from `towards`, unit, and starts `reach` away: over a
  /// parallelogram around the patch.
  [[nodiscard]] static std::optional<Frame> frame_along(glm::dvec3 towards, double reach,
                                                        const ShadowPatch& patch);

  /// All have to outlive the pyray. `viewer`: the frame by whose areas leaves are weighed, if its
  /// coordinates are not this frame's own.
  void start(const ShadowScene& scene, bool see_through, const Frame& frame,
             const ShadowPatch& patch, const Frame* viewer, std::int32_t ignored_part);

 protected:
  [[nodiscard]] std::optional<Ray> ray_at(glm::vec2 p) const override;
  [[nodiscard]] double measure(double weight, const LeafRegion& region) const override;

 private:
  const Frame* frame_ = nullptr;
  const ShadowPatch* patch_ = nullptr;
  const Frame* viewer_ = nullptr;
};

}  // namespace asos
