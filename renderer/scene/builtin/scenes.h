#pragma once

#include "renderer/scene/scene.h"

// The built-in scenes, a source file each; scene/builtin.h lists them by name.

namespace asos::builtin {

[[nodiscard]] Scene make_office();
[[nodiscard]] Scene make_office_metal();
[[nodiscard]] Scene make_primitives();
[[nodiscard]] Scene make_primitives_ball();
[[nodiscard]] Scene make_primitives_linear();
[[nodiscard]] Scene make_primitives_rectangle();
[[nodiscard]] Scene make_solids();
[[nodiscard]] Scene make_house();
[[nodiscard]] Scene make_house_textured();
[[nodiscard]] Scene make_house_mirror();
[[nodiscard]] Scene make_fence();
[[nodiscard]] Scene make_boxes();
[[nodiscard]] Scene make_mixed();
[[nodiscard]] Scene make_dense();
[[nodiscard]] Scene make_wheel();
[[nodiscard]] Scene make_park();
[[nodiscard]] Scene make_neon();
[[nodiscard]] Scene make_workshop();
[[nodiscard]] Scene make_railing();
[[nodiscard]] Scene make_foliage();
[[nodiscard]] Scene make_glass();
[[nodiscard]] Scene make_turning_fence();
[[nodiscard]] Scene make_walking_pole();
[[nodiscard]] Scene make_cards();

}  // namespace asos::builtin
