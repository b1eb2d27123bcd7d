#include "renderer/session/coarse_passes.h"

#include "renderer/render_block.h"
#include "renderer/samples/sample_block.h"
#include "renderer/shading/shade.h"

#include <array>
#include <cmath>
#include <span>
#include <utility>
#include <vector>

namespace asos {
namespace {

// Side of a quarter of a block, in pixels.
constexpr int quarter_size = block_size / 2;
constexpr std::size_t most_squares_in_group =
    (group_size / quarter_size) * (group_size / quarter_size);

/// Looks through the middles of a group's squares. Keeps memory and prepared lights from one group
/// to the next.
class Middles {
 public:
  explicit Middles(const PlannedRender& render)
      : render_(render),
        shader_(shader_of(*render.snapshot.scene, render.snapshot.settings, render.view)),
        places_(1, false),
        lights_(render.snapshot.scene->rays(), places_) {}

  /// Cuts blocks into squares of this side, those at the right and lower edge into what is left.
  std::span<const PixelRect> cut(std::span<const WorkPlan::Block> blocks, int side) {
    std::size_t count = 0;
    for (const WorkPlan::Block& block : blocks) {
      const PixelRect& r = block.rect;
      for (int y = r.y; y < r.y + r.height; y += side)
        for (int x = r.x; x < r.x + r.width; x += side)
          squares_[count++] = intersection(r, {x, y, side, side});
    }
    return std::span(squares_).first(count);
  }

  /// Radiance, square by square: 0 where it is not finite. Empty once `stop` is requested.
  std::span<const glm::vec3> see(std::span<const PixelRect> squares, int side,
                                 const std::stop_token& stop) {
    // One packet of rays for all.
    for (std::size_t i = 0; i < squares.size(); ++i) {
      const PixelRect& r = squares[i];
      rays_[i] = render_.view.ray(r.x + 0.5 * r.width, r.y + 0.5 * r.height);
    }
    render_.snapshot.scene->rays().closest(std::span(rays_).first(squares.size()),
                                           std::span(hits_).first(squares.size()),
                                           culling_of(render_.snapshot.settings));
    sums_.assign(squares.size(), glm::dvec3(0.0));
    RenderStatistics uncounted;
    for (std::size_t i = 0; i < squares.size(); ++i) {
      if (stop.stop_requested()) return {};
      places_.start_pixel(squares[i].x, squares[i].y);
      SampleLights transport(lights_, {i});
      sums_[i] =
          shader_.radiance(rays_[i], hits_[i], static_cast<float>(side), transport, uncounted);
    }
    lights_.trace(sums_);
    for (std::size_t i = 0; i < squares.size(); ++i) {
      const glm::vec3 radiance(sums_[i]);
      const bool finite = std::isfinite(radiance.x + radiance.y + radiance.z);
      radiance_[i] = finite ? radiance : glm::vec3(0.0f);
    }
    return std::span(radiance_).first(squares.size());
  }

  /// Whether the ray through the middle of square i met a surface.
  [[nodiscard]] bool met(std::size_t i) const { return hits_[i].valid(); }

 private:
  const PlannedRender& render_;
  Shader shader_;
  GridPlaces places_;
  SampledLights lights_;
  std::array<PixelRect, most_squares_in_group> squares_;
  std::array<Ray, most_squares_in_group> rays_;
  std::array<Hit, most_squares_in_group> hits_;
  std::vector<glm::dvec3> sums_;
  std::array<glm::vec3, most_squares_in_group> radiance_{};
};

/// One colour, all of it covered, or nothing.
FinishedTile flat_tile(const PixelRect& rect, glm::vec3 radiance, bool covered) {
  FinishedTile tile;
  tile.rect = rect;
  const auto pixels = static_cast<std::size_t>(rect.width * rect.height);
  tile.radiance.assign(pixels, radiance);
  tile.split_level.assign(pixels, 0);
  tile.cause.assign(pixels, SplitCause::none);
  if (!covered) tile.coverage.assign(pixels, 0.0f);
  return tile;
}

std::span<const WorkPlan::Block> blocks_of(const WorkPlan& plan, const BlockGroup& group) {
  return std::span(plan.blocks).subspan(group.first_block, group.block_count);
}

}  // namespace

void CoarsePasses::work(const PlannedRender& render, TileCollector& tiles,
                        const std::stop_token& stop) {
  work_middles(render, Pass::blocks, tiles, stop);
  work_middles(render, Pass::quarters, tiles, stop);
  work_centres(render, tiles, stop);
}

void CoarsePasses::work_middles(const PlannedRender& render, Pass pass, TileCollector& tiles,
                                const std::stop_token& stop) {
  const int side = pass == Pass::blocks ? block_size : quarter_size;
  std::atomic<std::size_t>& next = pass == Pass::blocks ? next_blocks_ : next_quarters_;
  Middles middles(render);
  const bool clear = render.snapshot.settings.background.kind == BackgroundKind::transparent;
  while (!stop.stop_requested()) {
    const std::size_t index = next++;
    if (index >= render.plan.groups.size()) return;
    const BlockGroup& group = render.plan.groups[index];
    const std::span<const PixelRect> squares = middles.cut(blocks_of(render.plan, group), side);
    const auto radiance = middles.see(squares, side, stop);
    if (radiance.empty()) return;
    FinishedTile tile = tiles.blank_tile(group);
    if (clear) tile.coverage.assign(tile.radiance.size(), 0.0f);
    for (std::size_t i = 0; i < squares.size(); ++i)
      copy_pixels(flat_tile(squares[i], radiance[i], !clear || middles.met(i)), tile);
    tiles.publish_coarse(index, pass, std::move(tile));
  }
}

void CoarsePasses::work_centres(const PlannedRender& render, TileCollector& tiles,
                                const std::stop_token& stop) {
  // A pixel's centre is what the regular grid of one sample takes.
  RenderSettings settings = render.snapshot.settings;
  settings.method = Method::uniform;
  settings.sampling.spp = 1;
  settings.shadow.sky = false;  // one ray to it is noise
  settings.shadow.bounces = 0;
  while (!stop.stop_requested()) {
    const std::size_t index = next_centres_++;
    if (index >= render.plan.groups.size()) return;
    const BlockGroup& group = render.plan.groups[index];
    FinishedTile tile = tiles.blank_tile(group);
    if (settings.background.kind == BackgroundKind::transparent)
      tile.coverage.assign(tile.radiance.size(), 0.0f);
    for (const WorkPlan::Block& block : blocks_of(render.plan, group)) {
      if (stop.stop_requested()) return;
      copy_pixels(render_block(*render.snapshot.scene, render.view, settings, block.rect).tile,
                  tile);
    }
    tiles.publish_coarse(index, Pass::centres, std::move(tile));
  }
}

}  // namespace asos
