#include "renderer/comparison/published_motion.h"

#include "renderer/asos/asos.h"
#include "renderer/prepared/screen_motion.h"
#include "renderer/sampling/random.h"
#include "renderer/shading/background_radiance.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace asos {
namespace {

// Shorter ways, in pixels, change a pixel by less than a display step.
constexpr double shortest_way = 1.0 / 256.0;

/// The view of the rectangle around a pixel's centre that is longer than the pixel by a way across
/// the picture.
View elongated(const View& view, glm::dvec2 centre, glm::dvec2 way) {
  const double length = glm::length(way);
  const glm::dvec2 along = way / length, across(-along.y, along.x);
  return view.parallelogram(centre - 0.5 * (1.0 + length) * along - 0.5 * across,
                            (1.0 + length) * along, across);
}

class ElongatedPixels {
 public:
  explicit ElongatedPixels(const BlockJob& job)
      : job_(job),
        motion_(*job.motion),
        background_radiance_(job.settings.background, job.view),
        settings_(job.settings) {
    settings_.asos.fat = 2;
    // Cones are for square pixels.
    settings_.asos.detect = Detection::square;
  }

  void replace(BlockResult& result) {
    const PixelRect& block = job_.block;
    std::vector<Ray> rays;
    for (int y = block.y; y < block.y + block.height; ++y)
      for (int x = block.x; x < block.x + block.width; ++x)
        rays.push_back(job_.view.ray(x + 0.5, y + 0.5));
    std::vector<Hit> hits(rays.size());
    job_.scene.rays().closest(rays, hits, culling_of(job_.settings));
    result.statistics.eye_rays += rays.size();
    for (std::size_t i = 0; i < hits.size() && !job_.stop.stop_requested(); ++i) {
      const glm::dvec2 way = way_of(rays[i], hits[i]);
      if (glm::length(way) < shortest_way) continue;
      const auto pixel = static_cast<int>(i);
      render({block.x + pixel % block.width, block.y + pixel / block.width}, way, rays[i], i,
             result);
    }
  }

 private:
  /// The motion of the surface that a ray meets, in pixels, over the whole exposure.
  [[nodiscard]] glm::dvec2 way_of(const Ray& ray, const Hit& hit) const {
    const World& first_world = motion_.scene(0).world();
    const World& last_world = motion_.scene(motion_.steps()).world();
    const World& now = job_.scene.world();
    const auto alike = [&](const World& world) {
      return world.triangles.size() == now.triangles.size() &&
             world.positions.size() == now.positions.size() &&
             world.faces.size() == now.faces.size();
    };
    if (!hit.valid() || !alike(first_world) || !alike(last_world)) return glm::dvec2(0.0);
    const auto seen_at = [&](int moment) {
      const glm::dvec3 p = point_at(job_.scene.world(), motion_.scene(moment).world(),
                                    glm::dvec3(ray.at(hit.t)), hit);
      return ScreenProjection(motion_.view(moment)).at(p);
    };
    const auto first = seen_at(0), last = seen_at(motion_.steps());
    return first && last ? *last - *first : glm::dvec2(0.0);
  }

  void render(glm::ivec2 pixel, glm::dvec2 way, const Ray& ray, std::size_t i,
              BlockResult& result) {
    const View view = elongated(job_.view, glm::dvec2(pixel) + 0.5, way);
    // A gradient is laid out by the whole picture.
    Background& background = settings_.background;
    if (background.kind == BackgroundKind::colours)
      background.top = background.bottom =
          background_radiance_.radiance(job_.scene.sky_of(job_.settings), ray, nullptr, 1.0f);
    const auto seed = static_cast<std::uint32_t>(job_.settings.seed);
    settings_.seed = static_cast<int>(pixel_random(pixel.x, pixel.y, seed) >> 33);
    const BlockResult found =
        render_fat_pyray({job_.scene, view, settings_, {0, 0, 1, 1}, job_.stop});
    FinishedTile& tile = result.tile;
    tile.radiance[i] = found.tile.radiance[0];
    copy_planes(found.tile.layers, {pixel.x, pixel.y, 1, 1}, tile.layers, job_.block);
    tile.split_level[i] = std::max(tile.split_level[i], found.tile.split_level[0]);
    if (!tile.cause.empty()) note_motion(tile.cause[i], result.statistics);
    if (!tile.rays.empty() && !found.tile.rays.empty()) tile.rays[i] += found.tile.rays[0];
    result.statistics.eye_rays += found.statistics.eye_rays;
    result.statistics.shadow_rays += found.statistics.shadow_rays;
    result.statistics.reflection_rays += found.statistics.reflection_rays;
    result.statistics.sky_rays += found.statistics.sky_rays;
  }

  static void note_motion(SplitCause& cause, RenderStatistics& statistics) {
    if (cause == SplitCause::none)
      ++statistics.split_pixels;
    else
      --statistics.pixels_by_cause[static_cast<std::size_t>(cause)];
    cause = SplitCause::motion;
    ++statistics.pixels_by_cause[static_cast<std::size_t>(cause)];
  }

  const BlockJob& job_;
  const MovingPicture& motion_;
  BackgroundRadiance background_radiance_;
  RenderSettings settings_;
};

}  // namespace

BlockResult render_published_motion(const BlockJob& job) {
  BlockResult result = render_block_asos({job.scene, job.view, job.settings, job.block, job.stop});
  ElongatedPixels(job).replace(result);
  return result;
}

}  // namespace asos
