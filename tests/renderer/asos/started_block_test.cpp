// Rendering a block in two stages gives the same result as in one.

#include "renderer/asos/asos.h"
#include "renderer/scene/builtin.h"
#include "tests/support/expect_same.h"
#include "tests/support/render_picture.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

namespace asos::test::started_block_test {
namespace {

constexpr int width = 96, height = 56;

/// All blocks of a picture in two stages.
struct Staged {
  explicit Staged(const char* name, int fat = 8)
      : scene(*prepare(*builtin_scene(name))),
        camera(first_camera(scene->world(), double{width} / height)),
        view(camera, width, height, radius_around_origin(scene->world().bounds)) {
    settings.width = width;
    settings.height = height;
    settings.asos.fat = fat;
    for (int y = 0; y < height; y += 8) {
      for (int x = 0; x < width; x += 8) {
        const BlockJob job{*scene, view, settings, {x, y, 8, 8}};
        StartedBlock started = start_block_asos(job);
        first.push_back(started.result);
        gains.push_back(started.rest ? started.rest->squared_error() : 0.0);
        bytes.push_back(started.rest ? started.rest->bytes() : 0);
        finished.push_back(started.rest ? started.rest->finish(job) : std::move(started.result));
        direct.push_back(render_block_asos(job));
      }
    }
  }

  std::shared_ptr<const RenderScene> scene;
  Camera camera;
  View view;
  RenderSettings settings;
  std::vector<BlockResult> first, finished, direct;
  std::vector<double> gains;
  std::vector<std::size_t> bytes;
};

double squared_difference(const BlockResult& a, const BlockResult& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.tile.radiance.size(); ++i) {
    const glm::vec3 off =
        glm::clamp(a.tile.radiance[i], 0.0f, 1.0f) - glm::clamp(b.tile.radiance[i], 0.0f, 1.0f);
    sum += static_cast<double>(glm::dot(off, off));
  }
  return sum;
}

TEST(StartedBlock, FinishesWithTheBitsOfADirectRender) {
  for (const int fat : {4, 8}) {
    const Staged staged("dense", fat);
    EXPECT_GT(std::count_if(staged.gains.begin(), staged.gains.end(),
                            [](double gain) { return gain > 0.0; }),
              20)
        << "otherwise nothing is left for the second stage";
    for (std::size_t i = 0; i < staged.direct.size(); ++i) {
      EXPECT_EQ(staged.finished[i].tile.radiance, staged.direct[i].tile.radiance);
      EXPECT_EQ(staged.finished[i].tile.split_level, staged.direct[i].tile.split_level);
      EXPECT_EQ(staged.finished[i].tile.cause, staged.direct[i].tile.cause);
      EXPECT_EQ(staged.finished[i].tile.rays, staged.direct[i].tile.rays);
      expect_same(staged.finished[i].statistics, staged.direct[i].statistics);
    }
  }
}

TEST(StartedBlock, TheFirstStageIsCloseAndTakesAPartOfTheRays) {
  const Staged staged("dense");
  double off = 0.0;
  std::uint64_t first_rays = 0, rays = 0;
  for (std::size_t i = 0; i < staged.direct.size(); ++i) {
    off += squared_difference(staged.first[i], staged.direct[i]);
    first_rays += staged.first[i].statistics.rays();
    rays += staged.direct[i].statistics.rays();
  }
  EXPECT_LT(std::sqrt(off / (3.0 * width * height)), 4.0 / 256.0) << "four times EPS";
  EXPECT_GT(off, 0.0);
  EXPECT_LT(static_cast<double>(first_rays), 0.7 * static_cast<double>(rays));
}

// The half of the blocks with the largest gains has most of the remaining squared error.
TEST(StartedBlock, GainsTellWhereMostIsMissing) {
  const Staged staged("dense");
  std::vector<std::pair<double, double>> blocks;  // gain, squared error
  for (std::size_t i = 0; i < staged.direct.size(); ++i)
    if (staged.gains[i] > 0.0)
      blocks.emplace_back(staged.gains[i], squared_difference(staged.first[i], staged.direct[i]));
  std::sort(blocks.rbegin(), blocks.rend());
  double first = 0.0, all = 0.0;
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    all += blocks[i].second;
    if (i < blocks.size() / 2) first += blocks[i].second;
  }
  EXPECT_GT(first, 0.6 * all);
}

TEST(StartedBlock, KeepsLittleMemory) {
  const Staged boxes("boxes");
  double bytes = 0.0;
  for (const std::size_t of_block : boxes.bytes) bytes += static_cast<double>(of_block);
  EXPECT_LT(bytes / (width * height), 400.0);
  EXPECT_GT(bytes, 0.0);
}

}  // namespace
}  // namespace asos::test::started_block_test
