#pragma once

#include "renderer/geometry/half_space.h"
#include "renderer/shadows/light_pyramid.h"
#include "renderer/shadows/patch_caster.h"
#include "renderer/shadows/shadow_caster.h"

#include <array>
#include <optional>

namespace asos {

/// A shadow pyray whose source lies behind the surface, so that it covers a patch of the surface
/// and averages over it (CGF'98 sections 4.3.2 to 4.3.4).
struct ExtendedPyray {
  enum class Fit {
    inside,  ///< the largest shadow patch inside the leaf's patch (4.3.2)
    around,  ///< the smallest around the leaf's patch; only rays of that patch count (4.3.4)
  };

  Frame frame;
  HalfSpace surface;                  ///< the pyray is traced above it
  std::array<HalfSpace, 2> between;   ///< the surface and the light
  std::array<BorderEdge, 4> outline;  ///< around: the leaf's patch in the frame's square
  Fit fit = Fit::inside;

  /// Makes the pyray; `pyramid` is the light's pyramid from the patch's centre. Returns nothing if
  /// the light sees the patch edge-on. For `around`, also returns nothing if the patch is not
  /// inside the light's projection onto the surface. A light whose projection is smaller than the
  /// patch would need a source behind the light ("we may have to move the source"). Then the pyray
  /// is nearly as narrow as the light and samples only its part of the patch.
  [[nodiscard]] static std::optional<ExtendedPyray> of(const LightPyramid& pyramid,
                                                       const ShadowPatch& patch, Fit fit);
};

/// Computes the visibility of the light from an extended pyray's patch.
class ExtendedCaster final : public ShadowCaster {
 public:
  /// All arguments have to outlive the pyray.
  void start(const ShadowScene& scene, bool see_through, const ExtendedPyray& pyray,
             const LightPyramid& pyramid, std::int32_t ignored_part);

 protected:
  [[nodiscard]] std::optional<Ray> ray_at(glm::vec2 p) const override;
  [[nodiscard]] double measure(double weight, const LeafRegion& region) const override;

 private:
  const ExtendedPyray* pyray_ = nullptr;
  const LightPyramid* pyramid_ = nullptr;
};

}  // namespace asos
