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

/// The visible fraction of a light, 0 to 1 by colour.
using Visibility = glm::dvec3;

/// A part of a smooth surface over which no soft shadow varies by more than the tolerance. The
/// visibility of each light from its centre, computed at first use, holds for all of it. For point
/// lights that is true if the visibility is 0 or 1.
struct UniformShadowPatch {
  SurfacePoint middle;
  Square square;                         ///< in the viewer's frame
  std::vector<Visibility> visibilities;  ///< of each light; negative: not computed yet
  LightViews views{};                    ///< from its centre
};

/// A leaf of an eye pyray or a reflected one, with the data that shadows and reflections need while
/// it is shaded.
struct LeafContext {
  LeafRegion region;                   ///< in the viewer's frame
  float root_side = 1.0f;              ///< side of the leaf's root in that frame
  double weight = 1.0;                 ///< the leaf's fraction of the root's area
  glm::vec2 at{0.5f};                  ///< place of its sample, in that frame
  std::uint64_t seed = 0;              ///< of the leaf's random numbers
  UniformShadowPatch* even = nullptr;  ///< the evenly lit patch around it, if any
  const LightViews* views = nullptr;   ///< computed views from its sample
  ObservedLeaf observed;

  [[nodiscard]] LightView view_of(std::uint32_t light) const {
    return views ? views->of(light) : LightView{light};
  }
  /// Returns how many times the root was split to get this leaf.
  [[nodiscard]] int level() const {
    return static_cast<int>(std::lround(std::log2(root_side / region.square.side)));
  }
};

}  // namespace asos
