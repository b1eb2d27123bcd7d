#pragma once

#include "renderer/prepared/render_scene.h"
#include "renderer/result.h"

#include <memory>
#include <span>

namespace asos {

/// Copies all that describes a scene except its surfaces, from a Scene or another Geometry.
template <typename Described>
void copy_description(const Described& from, Geometry& to) {
  to.name = from.name;
  to.source = from.source;
  to.notes = from.notes;
  to.contents = from.contents;
  to.time = from.time;
  to.rig = from.rig;
}

/// Returns the geometry of `scene` with other surfaces and the same description. Surfaces
/// that stay (Part::surfaces) keep their hierarchies and marks. `lights`: the scene's own ones,
/// whose own parts are those of `world`. Errors have the scene's file name.
[[nodiscard]] Result<std::shared_ptr<Geometry>> rebuilt_geometry(const RenderScene& scene,
                                                                 World world,
                                                                 std::span<const Light> lights);

}  // namespace asos
