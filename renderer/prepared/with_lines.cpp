#include "renderer/prepared/with_lines.h"

#include "renderer/prepared/rebuilt_geometry.h"

#include <fmt/format.h>

#include <new>
#include <utility>

namespace asos {
namespace {

Result<void> check_size(const RenderScene& scene, const LinePicture& picture) {
  const World& world = scene.world();
  const LineSize more = size_of_lines(world, picture);
  const std::uint64_t triangles = world.solid_triangles() + more.triangles;
  if (triangles > most_triangles)
    return unexpected(Error{scene.geometry->source,
                            fmt::format("has {} triangles with its lines and points; the limit is "
                                        "{}",
                                        triangles, most_triangles)});
  return {};
}

Result<std::shared_ptr<const RenderScene>> draw_in_memory(const RenderScene& scene,
                                                          const LinePicture& picture) {
  World world = scene.world();
  draw_lines(world, picture);
  auto geometry = rebuilt_geometry(scene, std::move(world), scene.own_lighting->lights);
  if (!geometry) return unexpected(geometry.error());
  RenderScene drawn = scene;
  drawn.exposure.reset();
  drawn.geometry = *std::move(geometry);
  return assembled(std::move(drawn));
}

}  // namespace

Result<std::shared_ptr<const RenderScene>> with_lines(std::shared_ptr<const RenderScene> scene,
                                                      const LinePicture& picture) {
  const LinesAndPoints& lines_and_points = scene->world().lines_and_points;
  if (lines_and_points.empty() || (!(picture.width > 0.0) && !lines_and_points.drawn()))
    return scene;
  if (const auto fits = check_size(*scene, picture); !fits) return unexpected(fits.error());
  try {
    return draw_in_memory(*scene, picture);
  } catch (const std::bad_alloc&) {
    return unexpected(Error{scene->geometry->source, "does not fit into this machine's memory"});
  }
}

}  // namespace asos
