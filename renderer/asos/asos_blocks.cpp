#include "renderer/asos/asos.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace asos {
namespace {

/// The job of each fat pyray of a block.
std::vector<BlockJob> parts_of(const BlockJob& job) {
  const int fat = job.settings.asos.fat;
  const PixelRect& block = job.block;
  std::vector<BlockJob> parts;
  for (int y = 0; y < block.height; y += fat)
    for (int x = 0; x < block.width; x += fat)
      parts.push_back({job.scene,
                       job.view,
                       job.settings,
                       {block.x + x, block.y + y, std::min(fat, block.width - x),
                        std::min(fat, block.height - y)},
                       job.stop});
  return parts;
}

BlockResult together(const BlockJob& job, const std::vector<StartedPyray>& parts) {
  const int max_level = job.settings.asos.max_level;
  if (parts.size() == 1) return parts.front().result(max_level);
  BlockResult result;
  result.tile.rect = job.block;
  const auto pixels =
      static_cast<std::size_t>(job.block.width) * static_cast<std::size_t>(job.block.height);
  result.tile.radiance.resize(pixels);
  result.tile.split_level.resize(pixels);
  result.tile.cause.resize(pixels);
  result.tile.rays.resize(pixels);
  result.tile.outlook.resize(pixels);
  result.tile.layers = blank_planes(job.settings.layers, pixels);
  for (const StartedPyray& part : parts) {
    const BlockResult done = part.result(max_level);
    copy_pixels(done.tile, result.tile);
    result.statistics += done.statistics;
  }
  return result;
}

class UnfinishedPyrays final : public UnfinishedBlock {
 public:
  explicit UnfinishedPyrays(std::vector<StartedPyray>&& parts) : parts_(std::move(parts)) {}

  BlockResult finish(const BlockJob& job) override {
    const std::vector<BlockJob> jobs = parts_of(job);
    for (std::size_t i = 0; i < parts_.size(); ++i) finish_fat_pyray(jobs[i], parts_[i]);
    return together(job, parts_);
  }
  [[nodiscard]] double squared_error() const override {
    double sum = 0.0;
    for (const StartedPyray& part : parts_) sum += part.squared_error();
    return sum;
  }
  [[nodiscard]] std::size_t bytes() const override {
    std::size_t bytes = sizeof(*this);
    for (const StartedPyray& part : parts_) bytes += part.bytes();
    return bytes;
  }

 private:
  std::vector<StartedPyray> parts_;
};

}  // namespace

StartedBlock start_block_asos(const BlockJob& job) {
  std::vector<StartedPyray> parts;
  for (const BlockJob& part : parts_of(job)) parts.push_back(start_fat_pyray(part));
  StartedBlock started{together(job, parts), nullptr};
  const bool open = std::any_of(parts.begin(), parts.end(),
                                [](const StartedPyray& part) { return !part.open.parts.empty(); });
  if (open) started.rest = std::make_unique<UnfinishedPyrays>(std::move(parts));
  return started;
}

BlockResult render_block_asos(const BlockJob& job) {
  StartedBlock started = start_block_asos(job);
  if (!started.rest || job.stop.stop_requested()) return std::move(started.result);
  return started.rest->finish(job);
}

}  // namespace asos
