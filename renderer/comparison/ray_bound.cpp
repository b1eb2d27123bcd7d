#include "renderer/asos/plane_cuts.h"
#include "renderer/prepared/render_scene.h"
#include "renderer/pyray/fat_search.h"
#include "renderer/samples/block_job.h"
#include "renderer/samples/pixel_layers.h"
#include "renderer/samples/sample_sums.h"
#include "renderer/world/surface_kind.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

// Ray bound tracing (CGF'98 section 2.9): where a boundary is near, "the pixel is supersampled at
// some predetermined value".

namespace asos {
namespace {

// Returns 1 for each pixel of a block, row by row, that a possibly visible boundary crosses, else
// 0 (CGF'98 section 2.9: "a ray bound surrounding several similar rays is used to detect the
// proximity of the rays to the boundary of an object"; Ohta and Maekawa 1990).
//
// The ray bounds are pyramids around 8 x 8, 4 x 4, 2 x 2 pixels and one pixel. The boundaries and
// their hierarchy are those of ASOS with square detection. Boundaries behind the surface at the
// centre of a bound are ignored, except within a few pixels' widths behind it (OccluderPlane).
// `centres` are the hits of the rays through the pixels' centres, row by row; `block` is no larger
// than block_size.
std::vector<std::uint8_t> pixels_with_boundaries(const RenderScene& scene, const View& view,
                                                 PixelRect block, std::span<const Hit> centres) {
  const FatPyray fat{view.frame(block.x, block.y, block_size, block_size), block_size};
  const auto index = [&](int x, int y) { return static_cast<std::size_t>(y * block.width + x); };
  // Returns the plane of the surface at a pixel's centre, if that surface is opaque.
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

class BoundedBlock {
 public:
  explicit BoundedBlock(const BlockJob& job)
      : job_(job),
        n_(grid_side(job.settings.sampling.spp)),
        pixels_(static_cast<std::size_t>(job.block.width) *
                static_cast<std::size_t>(job.block.height)),
        places_(n_, true),
        sums_(job, places_),
        layers_(job_.settings, pixels_) {}

  BlockResult run() {
    sums_.resize(pixels_);
    layers_.note_each(sums_);
    take_centres();
    std::vector<std::uint8_t> bounded(pixels_, 0);
    if (n_ > 1 && !job_.stop.stop_requested()) {
      std::vector<Hit> hits;
      for (std::size_t pixel = 0; pixel < pixels_; ++pixel) hits.push_back(sums_.hit(pixel));
      // Blurred edges reach into many pixels.
      if (job_.view.has_lens() || job_.motion)
        bounded.assign(pixels_, 1);
      else
        bounded = pixels_with_boundaries(job_.scene, job_.view, job_.block, hits);
      supersample(bounded);
    }
    BlockResult result = sums_.block(job_.block);
    result.tile.layers = layers_.planes();
    for (const std::uint8_t pixel : bounded) result.statistics.split_pixels += pixel;
    result.tile.split_level = std::move(bounded);
    return result;
  }

 private:
  // Returns the stratum whose sample is replaced by the centre's: a central one, which has the
  // pixel's centre as its own centre or as its corner.
  [[nodiscard]] int middle() const { return n_ / 2 * n_ + n_ / 2; }

  [[nodiscard]] int x_of(std::size_t pixel) const {
    return job_.block.x + static_cast<int>(pixel) % job_.block.width;
  }
  [[nodiscard]] int y_of(std::size_t pixel) const {
    return job_.block.y + static_cast<int>(pixel) / job_.block.width;
  }

  void take_centres() {
    for (std::size_t pixel = 0; pixel < pixels_; ++pixel) {
      const int x = x_of(pixel), y = y_of(pixel);
      sums_.add({{x + 0.5, y + 0.5}, 1.0f, x, y, middle(), pixel});
    }
    sums_.trace();
  }

  void supersample(const std::vector<std::uint8_t>& bounded) {
    const float side = 1.0f / static_cast<float>(n_);
    for (std::size_t pixel = 0; pixel < pixels_; ++pixel) {
      if (!bounded[pixel]) continue;
      const int x = x_of(pixel), y = y_of(pixel);
      for (int index = 0; index < n_ * n_; ++index) {
        if (index == middle()) continue;
        places_.start_pixel(x, y);
        places_.start_sample(index);
        const PixelPoint p = places_.in_pixel();
        if (sums_.add({{x + p.x, y + p.y}, side, x, y, index, pixel}) && job_.stop.stop_requested())
          return;
      }
    }
    sums_.trace();
  }

  BlockJob job_;
  int n_;
  std::size_t pixels_;
  GridSampler places_;
  SampleSums sums_;
  PixelLayers layers_;
};

}  // namespace

/// Ray bound tracing (Ohta and Maekawa 1990; CGF'98 section 2.9): n x n jittered samples, as many
/// as `uniform` would take, in pixels with an object's boundary (pixels_with_boundaries), and one
/// through the centre in the others. With a lens or motion blur all pixels are supersampled. The
/// centre's sample is one of the n x n: it stands in for that of a middle stratum. Eye rays only:
/// boundaries of shadows are not looked for.
BlockResult render_block_ray_bound(const BlockJob& job) {
  return BoundedBlock(job).run();
}

}  // namespace asos
