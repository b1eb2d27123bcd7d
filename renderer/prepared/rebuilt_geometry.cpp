#include "renderer/prepared/rebuilt_geometry.h"

#include <utility>

namespace asos {

Result<std::shared_ptr<Geometry>> rebuilt_geometry(const RenderScene& scene, World world,
                                                   std::span<const Light> lights) {
  const Geometry& before = *scene.geometry;
  auto geometry =
      build_geometry(std::move(world), lights, scene.forced, &before.mips,
                     before.time ? BvhPurpose::moment : BvhPurpose::lasting, &before.rays);
  if (!geometry) return unexpected(Error{before.source, geometry.error().message()});
  Geometry& built = **geometry;
  copy_description(before, built);
  built.stage = before.stage;
  built.build_seconds = before.build_seconds;
  return geometry;
}

}  // namespace asos
