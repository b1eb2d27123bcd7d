#pragma once

#include "renderer/prepared/render_scene.h"

#include <memory>
#include <utility>

namespace asos::test {

/// A world without lights, with the mip chains of its textures, which make_render_scene does not
/// build.
inline std::shared_ptr<const RenderScene> make_textured_scene(World world) {
  auto geometry = build_geometry(std::move(world), {}, {}, nullptr).value();
  Lighting lighting = prepare_lighting(geometry->world, {});
  return unedited_scene(std::move(geometry), std::move(lighting));
}

}  // namespace asos::test
