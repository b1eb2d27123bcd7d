#pragma once

#include "renderer/scene/world.h"

#include <string>
#include <vector>

namespace asos {

/// What a scene needs (design section 8). What it does not need costs nothing.
struct SceneNeeds {
  bool textures = false;
  bool normal_maps = false;
  bool vertex_colors = false;
  bool alpha_mask = false;
  bool alpha_blend = false;
  bool punctual_lights = false;
  bool emission = false;
  bool metals = false;

  /// Names of the features that were left out, in words, such as "normal maps".
  [[nodiscard]] std::vector<std::string> left_out() const;
};

[[nodiscard]] SceneNeeds find_needs(const World& world);

}  // namespace asos
