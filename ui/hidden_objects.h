#pragma once

#include "renderer/scene/scene.h"

#include <vector>

namespace asos::ui {

/// Takes objects out of a scene that was loaded: `hidden` are their places among those that show
/// something, ascending, in the order of World::parts. Others, and places beyond the last, do
/// nothing. What is left moves as before.
void leave_out(Scene& scene, const std::vector<int>& hidden);

/// The place, among all objects, of the one that is `shown`th where `hidden` (ascending) are left
/// out.
[[nodiscard]] int place_among_all(int shown, const std::vector<int>& hidden);

}  // namespace asos::ui
