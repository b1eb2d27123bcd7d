#include "renderer/scene/builtin.h"
#include "renderer/session/level_choice.h"
#include "renderer/session/render_session.h"
#include "renderer/session/work_plan.h"
#include "tests/support/expect_same.h"
#include "tests/support/render_picture.h"
#include "tests/support/sanitized.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <map>
#include <thread>
#include <tuple>

namespace asos::test {
namespace {

Snapshot fence(int width, int height, int threads) {
  static const auto scene = *prepare(*builtin_scene("fence"));
  Snapshot snapshot;
  snapshot.scene = scene;
  snapshot.camera = first_camera(scene->world(), static_cast<double>(width) / height);
  snapshot.settings.width = width;
  snapshot.settings.height = height;
  snapshot.settings.threads = threads;
  snapshot.settings.shadow.cast = false;  // a third of the time
  return snapshot;
}

// Smaller ones have no pass at MAX 1.
constexpr int width = 160;
constexpr int height = 90;

std::vector<FinishedTile> all_tiles(const Snapshot& snapshot) {
  RenderSession session;
  session.restart(snapshot);
  session.wait();
  return session.take_finished();
}

TEST(ChooseLevels, TakesThemFromTheLowestOnAsFarAsThereIsRoom) {
  const std::vector<int> possible{0, 1, 2, 3};
  EXPECT_EQ(choose_levels(possible, {5, 9, 16, 40}, 2, 100), (std::vector{1, 2}));
  EXPECT_EQ(choose_levels(possible, {5, 9, 26, 40}, 2, 100), (std::vector{1}));
  EXPECT_EQ(choose_levels(possible, {12, 29, 60, 80}, 2, 100), (std::vector{0}));
  EXPECT_EQ(choose_levels(possible, {29, 40, 60, 80}, 2, 100), (std::vector<int>{}));
  EXPECT_EQ(choose_levels(possible, {0, 0, 0, 0}, 0, 0), (std::vector<int>{})) << "nothing to do";
  EXPECT_EQ(choose_levels({}, {}, 1, 100), (std::vector<int>{}));
}

TEST(ChooseLevels, DeepLevelsAreTakenToGoOnGrowing) {
  WorkByLevel work{5, 10, 20, 40};
  EXPECT_DOUBLE_EQ(extrapolate_work(work, 5), 90.0) << "by a half a level where it doubled";
  EXPECT_DOUBLE_EQ(work[4], 60.0);
  EXPECT_DOUBLE_EQ(extrapolate_work(work, 2), 20.0) << "nothing to extrapolate";
  WorkByLevel even{5, 5, 5, 5};
  EXPECT_DOUBLE_EQ(extrapolate_work(even, 8), 5.0);
  WorkByLevel nothing{};
  EXPECT_DOUBLE_EQ(extrapolate_work(nothing, 8), 0.0);
}

TEST(ChooseLevels, OnlyMethodsThatSplitHaveThem) {
  RenderSettings settings;
  EXPECT_EQ(possible_levels(settings), (std::vector{0, 1, 2, 3}));
  settings.asos.max_level = 0;
  EXPECT_TRUE(possible_levels(settings).empty());
  settings.asos.max_level = 3;
  settings.method = Method::sobol;
  EXPECT_TRUE(possible_levels(settings).empty());
}

TEST(LevelPasses, EndAsADirectRenderDoes) {
  for (const int threads : {1, 3}) {
    if (sanitized && threads == 1) continue;  // minutes, and nothing to watch
    const Snapshot snapshot = fence(width, height, threads);
    RenderSession session;
    session.restart(snapshot);
    session.wait();
    Film film(width, height);
    for (const FinishedTile& tile : session.take_finished()) film.put(tile);
    const RenderResult direct = render_to_end(snapshot);
    EXPECT_EQ(film.radiance, direct.film.radiance);
    EXPECT_EQ(film.split_level, direct.film.split_level);
    EXPECT_EQ(film.rays, direct.film.rays);
    expect_same(session.statistics(), direct.statistics);
    EXPECT_EQ(session.reached().pass, Reached::Pass::final_pixels);
    EXPECT_EQ(session.reached().final_share, 1.0);
  }
}

// The tiles of a pass at MAX 1 are those of a render at MAX 1, held to a quarter of its finest
// cells. At MAX 4, as at less that pass takes too much of the time, and at more MAX 2 has room.
TEST(LevelPasses, ShowTheWholePictureAtALowMax) {
  Snapshot snapshot = fence(width, height, 1);
  snapshot.settings.asos.max_level = 4;
  snapshot.settings.shadow.cast = true;
  Snapshot low = snapshot;
  low.settings.asos.max_level = 1;
  const Film at_max_1 = render_to_end(low).film;
  const Film at_max_4 = render_to_end(snapshot).film;
  Film shown(width, height);
  std::size_t coarse_pixels = 0;
  for (const FinishedTile& tile : all_tiles(snapshot)) {
    if (!tile.coarse) break;  // from here on it is the final pass
    shown.put(tile);
    coarse_pixels += tile.radiance.size();
  }
  EXPECT_EQ(coarse_pixels, 4u * width * height) << "blocks, their quarters, centres and MAX 1";
  EXPECT_EQ(shown.radiance, at_max_1.radiance);
  EXPECT_NE(at_max_1.radiance, at_max_4.radiance);
}

TEST(LevelPasses, ShowTheSameWhateverTheThreads) {
  // By place and pass: a group's n-th coarse tile. One that a better one overtook is dropped.
  using Key = std::tuple<int, int, int>;
  const auto shown = [](int threads) {
    std::map<Key, std::vector<glm::vec3>> tiles;
    std::map<std::pair<int, int>, int> seen;
    for (FinishedTile& tile : all_tiles(fence(width, height, threads))) {
      const int n = seen[{tile.rect.x, tile.rect.y}]++;
      tiles[{tile.rect.x, tile.rect.y, n}] = std::move(tile.radiance);
    }
    return tiles;
  };
  const auto one = shown(1);
  const auto many = shown(4);
  int different = 0;
  for (const auto& [key, radiance] : one) {
    const auto found = many.find(key);
    different += found == many.end() || found->second != radiance;
  }
  EXPECT_LE(different, 4 * 4) << "tiles that were overtaken, at the ends of passes";
  constexpr int groups = ((width - 1) / group_size + 1) * ((height - 1) / group_size + 1);
  EXPECT_EQ(one.size(), 5u * groups)
      << "blocks, their quarters, centres, MAX 1 and the final pixels";
}

TEST(LevelPasses, AStoppedRenderKeepsWhatIsFinal) {
  // Large enough that it is not done before the first final pixels were noticed.
  const int scale = sanitized ? 1 : 2;
  RenderSession session;
  session.restart(fence(scale * width, scale * height, 2));
  while (session.reached().final_share == 0.0 && session.progress().running)
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  session.cancel();
  const Reached reached = session.reached();
  EXPECT_GE(reached.pass, Reached::Pass::blocks) << "nobody waits between the passes";
  EXPECT_GT(reached.final_share, 0.0);
  EXPECT_LT(reached.final_share, 1.0);
  std::size_t final_pixels = 0;
  for (const FinishedTile& tile : session.take_finished())
    final_pixels += tile.coarse ? 0 : tile.radiance.size();
  EXPECT_EQ(static_cast<double>(final_pixels) / (scale * width * scale * height),
            reached.final_share);
}

}  // namespace
}  // namespace asos::test
