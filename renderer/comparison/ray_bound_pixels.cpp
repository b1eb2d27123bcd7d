#include "renderer/comparison/ray_bound_pixels.h"

#include "renderer/asos/plane_cuts.h"
#include "renderer/pyray/fat_search.h"
#include "renderer/world/surface_kind.h"

#include <cstddef>

namespace asos {

std::vector<std::uint8_t> pixels_with_boundaries(const RenderScene& scene, const View& view,
                                                 PixelRect block, std::span<const Hit> centres) {
  const FatPyray fat{view.frame(block.x, block.y, block_size, block_size), block_size};
  const auto index = [&](int x, int y) { return static_cast<std::size_t>(y * block.width + x); };
  // The plane of the surface at a pixel's centre, if it is opaque there.
  const auto cover = [&](int x, int y) {
    if (x >= block.width || y >= block.height) return OccluderPlane::none();
    const Hit& hit = centres[index(x, y)];
    const World& world = scene.world();
    if (!hit.valid() || surface_kind(world.material_of(hit.triangle)) != SurfaceKind::opaque)
      return OccluderPlane::none();
    return occluder_of(fat.frame, world, scene.features(), hit);
  };
  // Many boundaries in one pixel need not be resolved.
  BoundarySearch search;
  const PlaneCuts cuts(*scene.geometry, view, fat.frame);
  SearchBounds between;
  between.within = cuts.between;
  search.start(scene.features(), fat.frame, nullptr, fat.square_of(0, 0, 1).side, between);
  for (const BorderEdge& edge : cuts.lines) search.lists().add_boundary(edge.from, edge.to);
  FatSearch bounds;
  bounds.run(search, fat, cover);
  std::vector<std::uint8_t> bounded(centres.size(), 0);
  for (int y = 0; y < block.height; ++y)
    for (int x = 0; x < block.width; ++x) bounded[index(x, y)] = bounds.bounded(fat.index(x, y));
  return bounded;
}

}  // namespace asos
