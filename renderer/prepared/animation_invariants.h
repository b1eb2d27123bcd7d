#pragma once

#include "renderer/scene/scene.h"
#include "renderer/shading/mip_chain.h"

#include <glm/glm.hpp>

#include <memory>
#include <optional>
#include <vector>

namespace asos {

class Sky;

/// The properties of a moving scene that do not change with time, so that neither light nor camera
/// jumps. They follow from the scene at rest.
struct AnimationInvariants {
  glm::dvec3 origin{0.0};             ///< World::origin
  std::optional<double> floor;        ///< height of the lowest point; none: no surfaces
  bool has_default_lighting = false;  ///< the scene itself has almost no light
  std::vector<Light> rig;             ///< its default lights in that case; relative to the origin
  /// Walls block a studio's lights, so the default lights are inside.
  bool default_lighting_inside = false;
  MipChains mips;                  ///< of its images
  std::shared_ptr<const Sky> sky;  ///< the file's own surroundings; null: it has none
};

}  // namespace asos
