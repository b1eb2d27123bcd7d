#include "renderer/asos/fat_pyray.h"
#include "renderer/comparison/method.h"

#include <algorithm>

// Adaptive supersampling in object space (CGF'98): a block of pixels as one fat pyray or several.

namespace asos {
namespace {

// Copies a part's pixels to where they are in the block.
void copy_part(const FinishedTile& part, FinishedTile& block) {
  for (int y = 0; y < part.rect.height; ++y) {
    const auto from = static_cast<std::ptrdiff_t>(y * part.rect.width);
    const auto to = static_cast<std::ptrdiff_t>(
        (part.rect.y - block.rect.y + y) * block.rect.width + part.rect.x - block.rect.x);
    std::copy_n(part.radiance.begin() + from, part.rect.width, block.radiance.begin() + to);
    std::copy_n(part.split_level.begin() + from, part.rect.width, block.split_level.begin() + to);
    std::copy_n(part.cause.begin() + from, part.rect.width, block.cause.begin() + to);
    std::copy_n(part.rays.begin() + from, part.rect.width, block.rays.begin() + to);
  }
}

}  // namespace

BlockResult render_block_asos(const RenderScene& scene, const View& view,
                              const RenderSettings& settings, PixelRect block,
                              const std::stop_token& stop) {
  thread_local FatPyrayWorkspace work;
  const int fat = settings.asos.fat;
  if (block.width <= fat && block.height <= fat)
    return FatPyray(scene, view, settings, block, stop, work).run();
  BlockResult result;
  result.tile.rect = block;
  const auto pixels = static_cast<std::size_t>(block.width * block.height);
  result.tile.radiance.resize(pixels);
  result.tile.split_level.resize(pixels);
  result.tile.cause.resize(pixels);
  result.tile.rays.resize(pixels);
  for (int y = 0; y < block.height; y += fat) {
    for (int x = 0; x < block.width; x += fat) {
      const PixelRect part{block.x + x, block.y + y, std::min(fat, block.width - x),
                           std::min(fat, block.height - y)};
      const BlockResult done = FatPyray(scene, view, settings, part, stop, work).run();
      copy_part(done.tile, result.tile);
      result.statistics += done.statistics;
    }
  }
  return result;
}

}  // namespace asos
