#pragma once

#include "renderer/geometry/half_space.h"
#include "renderer/pyray/square.h"
#include "renderer/shadows/shadow_caster.h"

#include <array>
#include <optional>
#include <span>

namespace asos {

/// The patch of a surface that a leaf of a parent pyray covers. It has the four corners of the
/// leaf's square on the surface's plane, in the order (0,0), (1,0), (0,1), (1,1), and the leaf's
/// part of the square.
struct ShadowPatch {
  std::array<glm::dvec3, 4> corners;
  HalfSpace plane;                     ///< above: the visible side
  std::span<const BorderEdge> border;  ///< in units of the square; empty: the whole square
  double lift = 0.0;                   ///< height above the plane at which rays start
};

/// Casts from a point light, or a distant light, over a patch (CGF'98 section 4.1). A leaf's weight
/// is its fraction of the patch in the viewer's frame. The square that the light sees through the
/// patch's corners has the parent's own coordinates, since both see the same plane.
class PatchCaster final : public ShadowCaster {
 public:
  /// Returns the frame from a point light. Returns nothing if the light lies in the patch's plane,
  /// or if the corners do not surround a solid angle.
  [[nodiscard]] static std::optional<Frame> frame_from(glm::dvec3 light, const ShadowPatch& patch);
  /// Returns the frame of parallel light from the unit direction `towards`, over a parallelogram
  /// around the patch. The frame starts `reach` away from the patch.
  [[nodiscard]] static std::optional<Frame> frame_along(glm::dvec3 towards, double reach,
                                                        const ShadowPatch& patch);

  /// All arguments have to outlive the pyray. `viewer`: the frame in which leaves are weighted, if
  /// its coordinates differ from those of `frame`; else null.
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
