#include "renderer/session/coarse_passes.h"

#include "renderer/samples/pixel_layers.h"
#include "renderer/samples/sample_sums.h"

#include <array>
#include <span>
#include <utility>
#include <vector>

namespace asos {
namespace {

// Side of a quarter of a block, in pixels.
constexpr int quarter_size = block_size / 2;
constexpr std::size_t most_squares_in_group =
    (group_size / quarter_size) * (group_size / quarter_size);

/// Traces rays through the centres of a group's squares, all in one packet. Keeps memory and
/// prepared lights from one group to the next.
class Middles {
 public:
  explicit Middles(const PlannedRender& render)
      : places_(1, false),
        sums_(*render.snapshot.scene, render.view, render.snapshot.settings, places_),
        layers_(render.snapshot.settings, most_squares_in_group),
        world_(render.snapshot.scene->world()) {}

  /// Divides blocks into squares of this side; squares at the right and lower edge are clipped.
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

  void see(std::span<const PixelRect> squares, int side) {
    sums_.resize(0);
    sums_.resize(squares.size());
    layers_.clear();
    layers_.note_each(sums_);
    for (std::size_t i = 0; i < squares.size(); ++i) {
      const PixelRect& r = squares[i];
      (void)sums_.add(
          {{r.x + 0.5 * r.width, r.y + 0.5 * r.height}, static_cast<float>(side), r.x, r.y, 0, i});
    }
    sums_.trace();
  }

  /// Radiance of square i; 0 where it is not finite.
  [[nodiscard]] glm::vec3 radiance(std::size_t i) const { return glm::vec3(sums_.sum(i).mean()); }
  /// Returns the layers of all squares.
  [[nodiscard]] std::vector<LayerPlane> layers() const { return layers_.planes(); }
  /// Returns whether the ray through the centre of square i hit a surface.
  [[nodiscard]] bool met(std::size_t i) const { return sums_.hit(i).valid(); }
  /// Returns whether the ray of square i hit an unlit surface.
  [[nodiscard]] bool met_unlit(std::size_t i) const {
    return met(i) && world_.material_of(sums_.hit(i).triangle).unlit;
  }

 private:
  GridSampler places_;
  SampleSums sums_;
  PixelLayers layers_;
  const World& world_;
  std::array<PixelRect, most_squares_in_group> squares_;
};

/// Makes a tile of a single colour, completely covered or not, and completely unlit or lit.
FinishedTile flat_tile(const PixelRect& rect, glm::vec3 radiance, bool covered, bool unlit) {
  FinishedTile tile;
  tile.rect = rect;
  const auto pixels = static_cast<std::size_t>(rect.width * rect.height);
  tile.radiance.assign(pixels, radiance);
  tile.split_level.assign(pixels, 0);
  tile.cause.assign(pixels, SplitCause::none);
  if (!covered) tile.coverage.assign(pixels, 0.0f);
  if (unlit) tile.unlit.assign(pixels, glm::vec4(radiance, 1.0f));
  return tile;
}

/// Gives the pixels of a square the layers of its centre, number `square` of `centres`.
void fill_layers(std::span<const LayerPlane> centres, std::size_t square, const PixelRect& rect,
                 FinishedTile& tile) {
  const PixelRect part = intersection(rect, tile.rect);
  for (LayerPlane& plane : tile.layers) {
    const LayerPlane& from = *find_plane(centres, plane.layer);
    const std::size_t channels = row_of(plane.layer).channel_count();
    for (int y = part.y; y < part.y + part.height; ++y) {
      for (int x = part.x; x < part.x + part.width; ++x) {
        const auto pixel = static_cast<std::size_t>((y - tile.rect.y) * tile.rect.width) +
                           static_cast<std::size_t>(x - tile.rect.x);
        if (!plane.ids.empty()) plane.ids[pixel] = from.ids[square];
        for (std::size_t c = 0; c < channels; ++c)
          plane.values[pixel * channels + c] = from.values[square * channels + c];
      }
    }
  }
}

std::span<const WorkPlan::Block> blocks_of(const WorkPlan& plan, const BlockGroup& group) {
  return std::span(plan.blocks).subspan(group.first_block, group.block_count);
}

}  // namespace

void CoarsePasses::work(const PlannedRender& render, TileCollector& tiles,
                        const std::stop_token& stop) {
  work_middles(render, Pass::blocks, tiles, stop);
  work_middles(render, Pass::quarters, tiles, stop);
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
    middles.see(squares, side);
    FinishedTile tile = tiles.blank_tile(group);
    if (clear) tile.coverage.assign(tile.radiance.size(), 0.0f);
    if (render.unlit) tile.unlit.assign(tile.radiance.size(), glm::vec4(0.0f));
    const std::vector<LayerPlane> layers = middles.layers();
    if (!layers.empty())
      tile.layers = blank_planes(render.snapshot.settings.layers, tile.radiance.size());
    for (std::size_t i = 0; i < squares.size(); ++i) {
      copy_pixels(flat_tile(squares[i], middles.radiance(i), !clear || middles.met(i),
                            render.unlit && middles.met_unlit(i)),
                  tile);
      fill_layers(layers, i, squares[i], tile);
    }
    tiles.publish_coarse(index, pass, std::move(tile));
  }
}

}  // namespace asos
