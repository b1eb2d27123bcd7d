#pragma once

#include "ui/dfr_curve.h"
#include "ui/mirror_materials.h"
#include "ui/panels/controls.h"
#include "ui/previewer.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <optional>
#include <vector>

namespace asos::ui {

/// The state of the reflections panel.
struct ReflectionChoice {
  int material = 0;  ///< index into `mirrors`
  DfrChannel channel = DfrChannel::all;

  // The mirrors of the open scene, searched once.
  std::uint64_t scene = 0;  ///< OpenScene::times_opened
  std::vector<MirrorMaterial> mirrors;
  std::optional<glm::ivec2> followed;  ///< the picked pixel whose material was selected last
};

/// Controls for the depth and the blur of reflections; nothing if the scene has no mirror.
/// `picked`: the pixel that was clicked in the picture.
void reflections_panel(Controls& controls, Previewer& previewer, ReflectionChoice& choice,
                       std::optional<glm::ivec2> picked);

}  // namespace asos::ui
