#pragma once

#include "renderer/geometry/largest.h"
#include "renderer/geometry/ray.h"
#include "renderer/pyray/caster.h"
#include "renderer/pyray/observer.h"
#include "renderer/scene/scene.h"
#include "renderer/shading/footprint.h"
#include "renderer/shading/gloss.h"
#include "renderer/shading/surface.h"

#include <glm/glm.hpp>

#include <cmath>
#include <cstdint>
#include <vector>

namespace asos {

/// The visible fraction of a light, 0 to 1 by colour.
using Visibility = glm::dvec3;

struct UniformShadowPatch;

/// A leaf of an eye pyray or a reflected one, with the surface at its sample. It is made once
/// (EyeSamples::show), lives in its block, and holds its own border.
struct Leaf : PyrayLeaf {
  glm::vec2 at{0.5f};      ///< place of its sample, in the viewer's frame
  std::uint64_t seed = 0;  ///< of its random numbers
  float root_side = 1.0f;  ///< side of its root, in the viewer's frame
  std::vector<BorderEdge> border;
  Ray ray;
  Hit hit;
  FootprintShape shape;                ///< of its region around its sample
  const Material* material = nullptr;  ///< null: the background
  SurfacePoint point;                  ///< without a footprint
  Patch square;                        ///< patch of the surface that a square with its area covers
  /// Patch of the square around the sample that contains the whole leaf.
  Patch around;
  float distance = 0.0f;  ///< from the viewer, in world units
  /// Extended lights, in ascending order, before which there are so many boundaries that only rays
  /// are useful; ErrorTerms::penumbra finds them.
  std::vector<std::uint32_t> behind_detail;
  UniformShadowPatch* even = nullptr;  ///< the evenly lit patch around it, if any
  ObservedLeaf observed;

  [[nodiscard]] bool shows_surface() const { return material != nullptr; }
  [[nodiscard]] bool is_lit() const { return material && !material->unlit; }
  [[nodiscard]] glm::vec3 to_viewer() const { return -ray.direction; }
  /// Returns the largest radiance of the surface for an irradiance of pi, from base colour and
  /// sheen.
  [[nodiscard]] float albedo() const {
    const glm::vec3 diffuse = diffuse_share(*material) * glm::vec3(material->base_color);
    return largest(glm::clamp(diffuse + material->sheen.color, 0.0f, 1.0f));
  }
  /// Returns how many times the root was split to get this leaf.
  [[nodiscard]] int level() const {
    return static_cast<int>(std::lround(std::log2(root_side / region.square.side)));
  }
};

/// A part of a smooth surface over which no soft shadow varies by more than the tolerance. The
/// visibility of each light from its centre, computed at first use, holds for all of it. For point
/// lights that is true if the visibility is 0 or 1.
struct UniformShadowPatch {
  Leaf whole;
  std::vector<Visibility> visibilities;  ///< of each light; negative: not computed yet
};

}  // namespace asos
