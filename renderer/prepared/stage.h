#pragma once

#include "renderer/scene/scene.h"
#include "renderer/shading/mip_chain.h"

#include <glm/glm.hpp>

#include <memory>
#include <optional>
#include <vector>

namespace asos {

class Sky;

/// What stands still while a scene moves, so that neither light nor camera jumps from one moment to
/// the next: it follows from where the file's nodes place things, whatever the time.
struct Stage {
  glm::dvec3 origin{0.0};          ///< World::origin
  std::optional<double> floor;     ///< height of the lowest point; none: no surfaces
  bool lit_by_rig = false;         ///< next to no light comes from the scene itself
  std::vector<Light> rig;          ///< then these are there, too; relative to the origin
  bool rig_inside = false;         ///< walls shut out a studio's lights: the rig hangs inside
  MipChains mips;                  ///< of its images
  std::shared_ptr<const Sky> sky;  ///< the file's own surroundings; null: it has none
};

}  // namespace asos
