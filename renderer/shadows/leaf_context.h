#pragma once

#include "renderer/pyray/observer.h"
#include "renderer/pyray/square.h"
#include "renderer/shading/surface.h"
#include "renderer/shadows/light_view.h"

#include <glm/glm.hpp>

#include <cmath>
#include <cstdint>
#include <vector>

namespace asos {

/// The share of a light that arrives, 0 to 1 by colour.
using Visibility = glm::dvec3;

/// A part of a smooth surface over which no shadow of a light of some size varies by more than the
/// tolerance: the visibility of each light from its middle, found when first asked for, holds for
/// all of it. That of a light without size does where it is all or nothing.
struct EvenPatch {
  SurfacePoint middle;
  Square square;                         ///< in the viewer's frame
  std::vector<Visibility> visibilities;  ///< of each light; negative: not known yet
  LightViews views{};                    ///< of its middle
};

/// A leaf of an eye pyray, or of a mirrored one, as shadows and reflections see it while it is
/// shaded.
struct LeafContext {
  LeafRegion region;                  ///< in the viewer's frame
  float root_side = 1.0f;             ///< side of the leaf's root in that frame
  double weight = 1.0;                ///< the leaf's share of the root's area
  glm::vec2 at{0.5f};                 ///< its sample, in that frame
  std::uint64_t seed = 0;             ///< its own
  EvenPatch* even = nullptr;          ///< that it is a part of, if any
  const LightViews* views = nullptr;  ///< of its sample, as far as they were found
  ObservedLeaf observed;

  [[nodiscard]] LightView view_of(std::uint32_t light) const {
    return views ? views->of(light) : LightView{light};
  }
  /// How many times its root was split to get it.
  [[nodiscard]] int level() const {
    return static_cast<int>(std::lround(std::log2(root_side / region.square.side)));
  }
};

}  // namespace asos
