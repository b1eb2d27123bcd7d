#pragma once

#include "renderer/prepared/render_scene.h"
#include "ui/edited_light.h"

#include <glm/glm.hpp>

#include <cstddef>
#include <string>
#include <vector>

namespace asos::ui {

/// Reports the edits of a scene that was loaded again.
struct CarriedEdits {
  std::size_t lights = 0;  ///< edited, added or removed lights that were kept
  std::size_t dfrs = 0;    ///< edited DFRs that were kept
  /// The edits that were lost, because their light or material is gone: "light 'lamp'".
  std::vector<std::string> lost;
};
/// "Kept 2 light edits, 1 DFR edit. Lost, no longer in the scene: light 'lamp'"; empty: there was
/// no edit.
[[nodiscard]] std::string carried_words(const CarriedEdits& carried);

/// Applies edits of lights to the lights of the scene as it was loaded again.
/// - `before`: the edited lights, whose sources are indices into `first`.
/// - `first`: the lights that the scene had when it was opened.
/// - `opened`: those that it has now.
/// - `moved`: change of coordinates from `before` to `opened`.
/// A light is found again if it did not change in the file, or by its name. An edited light keeps
/// its edits; another one is as in the file. Added lights stay, removed ones stay away.
[[nodiscard]] std::vector<EditedLight> carried_lights(const std::vector<EditedLight>& before,
                                                      const std::vector<EditedLight>& first,
                                                      const std::vector<EditedLight>& opened,
                                                      glm::dvec3 moved, CarriedEdits& carried);

/// The DFRs of a scene's materials.
struct NamedDfrs {
  std::vector<std::string> names;  ///< of the materials
  MaterialDfrs dfrs;
};
/// Applies those of `before` that differ from `first` to materials of the same name.
[[nodiscard]] MaterialDfrs carried_dfrs(const NamedDfrs& before, const MaterialDfrs& first,
                                        NamedDfrs opened, CarriedEdits& carried);

}  // namespace asos::ui
