#pragma once

#include "renderer/scene/scene.h"

#include <vector>

namespace asos::ui {

/// Removes objects from a loaded scene. `hidden` are ascending indices among the objects with
/// surfaces, in the order of World::parts; indices past the last are ignored. The remaining objects
/// still move.
void leave_out(Scene& scene, const std::vector<int>& hidden);

/// Returns the index among all objects of the one with index `shown` among those not in `hidden`
/// (ascending).
[[nodiscard]] int place_among_all(int shown, const std::vector<int>& hidden);

}  // namespace asos::ui
