#pragma once

#include "renderer/prepared/render_scene.h"
#include "renderer/result.h"

#include <memory>
#include <optional>
#include <vector>

namespace asos {

/// How each material of a world blurs what it mirrors, by index in World::materials; none: by its
/// roughness.
using MaterialDfrs = std::vector<std::optional<Dfr>>;

[[nodiscard]] MaterialDfrs dfrs_of(const World& world);

/// The same scene with these defocusing ratios instead of its materials' own. Shares the
/// hierarchies with `scene` and keeps it alive; copies its world and builds nothing, as with_lights
/// does. Materials that look alike (same_look) should stay so: where they meet no boundary is
/// looked for. Errors: not one entry for each material, a ratio out of range.
[[nodiscard]] Result<std::shared_ptr<const RenderScene>> with_dfrs(
    const std::shared_ptr<const RenderScene>& scene, const MaterialDfrs& dfrs);

}  // namespace asos
