#include "renderer/session/render_session.h"

#include "renderer/comparison/method.h"
#include "renderer/session/work_plan.h"
#include "tests/support/expect_same.h"
#include "tests/support/make_settings.h"
#include "tests/support/processor_seconds.h"
#include "tests/support/sanitized.h"
#include "tests/support/tiny_scene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <limits>
#include <sys/resource.h>
#include <thread>
#include <unistd.h>

namespace asos {
namespace {

using Clock = std::chrono::steady_clock;

Snapshot snapshot_of(Method method, int width, int height, int threads) {
  static const auto scene = test::make_render_scene(test::still_life());
  return {.scene = scene,
          .camera = test::look_at({2, 2, 5}, {0, 0.7, 0}, 0.7),
          .settings = {.width = width,
                       .height = height,
                       .method = method,
                       .sampling = {.spp = 4},
                       .threads = threads}};
}

/// A scene whose picture is one flat colour from any camera.
std::shared_ptr<const RenderScene> flat_scene(float grey) {
  World world;
  test::add_quad(world, {-100, -100, 0}, {200, 0, 0}, {0, 200, 0}, test::unlit(glm::vec3(grey)));
  return test::make_render_scene(std::move(world));
}

TEST(WorkerCount, UsesAllCoresAndLeavesOneToAWindowWhereThereAreMoreThanTwo) {
  for (const int cores : {1, 2, 3, 16}) EXPECT_EQ(worker_count_on(cores, 0, false), cores);
  EXPECT_EQ(worker_count_on(1, 0, true), 1);
  EXPECT_EQ(worker_count_on(2, 0, true), 2);
  EXPECT_EQ(worker_count_on(3, 0, true), 2);
  EXPECT_EQ(worker_count_on(16, 0, true), 15);
  EXPECT_EQ(worker_count_on(16, 5, true), 5);
  // Machines may not report their number of cores.
  EXPECT_EQ(worker_count_on(0, 0, false), 1);
}

// At the same priority, a window's frames would wait on a busy processor.
TEST(RenderSession, WorkersBesideAWindowHaveALowerPriority) {
  const int own = getpriority(PRIO_PROCESS, 0);
  constexpr int lowest = 19;
  for (const bool beside_window : {false, true}) {
    std::atomic<int> of_worker = -100;
    RenderSession session(
        [&] { of_worker = getpriority(PRIO_PROCESS, static_cast<id_t>(gettid())); });
    Snapshot snapshot = snapshot_of(Method::asos, 64, 48, 1);
    snapshot.beside_window = beside_window;
    session.restart(snapshot);
    session.wait();
    EXPECT_EQ(of_worker, beside_window ? std::min(lowest, own + 5) : own);
  }
  EXPECT_EQ(getpriority(PRIO_PROCESS, 0), own) << "the caller's priority stays";
}

RenderSettings plan_settings(int width, int height, PixelRect crop = {}) {
  RenderSettings settings = test::make_settings(width, height);
  settings.crop = crop;
  return settings;
}

TEST(WorkPlan, CoversThePictureOnce) {
  for (const auto& [width, height] : {std::pair(1, 1), {8, 8}, {100, 37}, {33, 70}}) {
    const WorkPlan plan(plan_settings(width, height));
    std::vector<int> covered(static_cast<std::size_t>(width * height), 0);
    for (const WorkPlan::Block& block : plan.blocks) {
      EXPECT_EQ(block.rect.x % block_size, 0);
      EXPECT_EQ(block.rect.y % block_size, 0);
      for (int y = block.rect.y; y < block.rect.y + block.rect.height; ++y) {
        for (int x = block.rect.x; x < block.rect.x + block.rect.width; ++x) {
          ++covered[static_cast<std::size_t>(y * width + x)];
        }
      }
    }
    EXPECT_EQ(std::count(covered.begin(), covered.end(), 1), width * height);
  }
}

TEST(WorkPlan, ACropTakesTheBlocksThatItTouchesFromTheMiddle) {
  const WorkPlan plan(plan_settings(100, 100, {7, 9, 2, 60}));
  ASSERT_EQ(plan.blocks.size(), 2u * 8u);
  const PixelRect first = plan.groups.front().rect;
  EXPECT_EQ(first.y, 32);  // contains the crop's centre, y = 39
  const WorkPlan clipped(plan_settings(12, 12, {9, 9, 1, 1}));
  ASSERT_EQ(clipped.blocks.size(), 1u);
  EXPECT_EQ(clipped.blocks[0].rect, (PixelRect{8, 8, 4, 4}));
}

TEST(RenderToEnd, ReportsProgressAndEndsWithAllOfIt) {
  Snapshot snapshot = snapshot_of(Method::stochastic, 200, 150, 2);
  snapshot.settings.sampling.spp = 64;
  std::vector<Progress> reports;
  const RenderResult result =
      render_to_end(snapshot, [&](const Progress& p) { reports.push_back(p); });
  ASSERT_FALSE(reports.empty());
  EXPECT_TRUE(reports.back().finished);
  EXPECT_FALSE(reports.back().running);
  EXPECT_EQ(reports.back().fraction, 1.0);
  EXPECT_EQ(reports.back().seconds_left, 0.0);
  for (std::size_t i = 1; i < reports.size(); ++i) {
    EXPECT_GE(reports[i].fraction, reports[i - 1].fraction);
  }
  EXPECT_GT(result.seconds, 0.0);
  EXPECT_EQ(result.statistics.eye_rays, 200u * 150u * 64u);
}

TEST(RenderSession, PassesFollowEachOtherAndEndAsHeadless) {
  Snapshot snapshot = snapshot_of(Method::asos, 100, 70, 3);
  std::atomic<int> calls{0};
  RenderSession session([&] { ++calls; });
  session.restart(snapshot);
  Film film(100, 70);
  session.wait();
  int middle = 0;
  bool last_is_coarse = true;
  const std::vector<FinishedTile> tiles = session.take_finished();
  for (const FinishedTile& tile : tiles) {
    film.put(tile);
    if (tile.rect.x <= 50 && 50 < tile.rect.x + tile.rect.width && tile.rect.y <= 35 &&
        35 < tile.rect.y + tile.rect.height) {
      // The coarse tile comes first and is constant within each of its blocks.
      if (middle++ == 0) {
        EXPECT_EQ(tile.radiance[0], tile.radiance[1]);
      }
      EXPECT_TRUE(last_is_coarse) << "nothing follows the final pixels";
      last_is_coarse = tile.coarse;
    }
  }
  EXPECT_GE(middle, 1);
  EXPECT_FALSE(last_is_coarse);
  EXPECT_GE(calls, 2);
  EXPECT_TRUE(session.progress().finished);
  EXPECT_TRUE(session.take_finished().empty());
  const RenderResult headless = render_to_end(snapshot);
  EXPECT_EQ(film.radiance, headless.film.radiance);
  test::expect_same(session.statistics(), headless.statistics);
}

TEST(RenderSession, APauseHoldsTheFinalPassAndTheClock) {
  Snapshot snapshot = snapshot_of(Method::stochastic, 100, 70, 2);
  snapshot.settings.sampling.spp = 16;
  RenderSession session;
  session.pause();
  session.restart(snapshot);
  Film film(100, 70);
  std::int64_t pixels = 0;
  while (pixels < 100 * 70) {
    for (const FinishedTile& tile : session.take_finished()) {
      EXPECT_TRUE(tile.coarse) << "only coarse passes continue";
      film.put(tile);
      pixels += static_cast<std::int64_t>(tile.rect.width) * tile.rect.height;
    }
  }
  const Progress before = session.progress();
  EXPECT_TRUE(before.paused);
  EXPECT_FALSE(before.running);
  EXPECT_FALSE(before.finished);
  std::this_thread::sleep_for(std::chrono::milliseconds(30));
  EXPECT_EQ(session.progress().seconds, before.seconds);
  EXPECT_EQ(session.progress().fraction, 0.0);
  session.resume();
  EXPECT_FALSE(session.progress().paused);
  session.wait();
  EXPECT_TRUE(session.progress().finished);
  for (const FinishedTile& tile : session.take_finished()) film.put(tile);
  EXPECT_EQ(film.radiance, render_to_end(snapshot).film.radiance);
}

TEST(RenderSession, ThePreferredPartIsFinalFirstAndThePictureTheSame) {
  const PixelRect part{60, 5, 20, 20};
  for (const Method method : {Method::asos, Method::sobol}) {
    Snapshot snapshot = snapshot_of(method, 100, 70, 1);
    snapshot.settings.sampling.spp = 64;
    RenderSession session;
    session.prefer(part);
    session.restart(snapshot);
    session.wait();
    Film film(100, 70);
    int preferred = 0, others = 0;
    for (const FinishedTile& tile : session.take_finished()) {
      film.put(tile);
      if (tile.coarse) continue;
      const bool inside = !intersection(tile.rect, part).empty();
      EXPECT_FALSE(inside && others > 0) << tile.rect.x << ", " << tile.rect.y << " came late";
      ++(inside ? preferred : others);
    }
    EXPECT_GT(preferred, 0);
    EXPECT_GT(others, 0);
    const RenderResult headless = render_to_end(snapshot);
    EXPECT_EQ(film.radiance, headless.film.radiance);
    test::expect_same(session.statistics(), headless.statistics);
  }
}

TEST(RenderSession, APausedRenderIsReplacedAndCancelled) {
  RenderSession session;
  session.pause();
  for (int i = 0; i < 20; ++i) session.restart(snapshot_of(Method::asos, 96, 64, 2));
  session.cancel();
  EXPECT_FALSE(session.progress().finished);
  EXPECT_FALSE(session.progress().paused) << "it has ended";
}

TEST(RenderToEnd, TellsWhatEachPixelTook) {
  for (const Method method : {Method::asos, Method::stochastic}) {
    const RenderResult result = render_to_end(snapshot_of(method, 64, 48, 2));
    const auto most = *std::max_element(result.film.rays.begin(), result.film.rays.end());
    const auto least = *std::min_element(result.film.rays.begin(), result.film.rays.end());
    double rays = 0.0, seconds = 0.0;
    for (std::size_t i = 0; i < result.film.rays.size(); ++i) {
      rays += static_cast<double>(result.film.rays[i]);
      seconds += static_cast<double>(result.film.seconds[i]);
    }
    EXPECT_GE(least, 1.0f);
    EXPECT_GT(most, least);
    EXPECT_NEAR(rays, static_cast<double>(result.statistics.rays()), 0.02 * rays);
    EXPECT_GT(seconds, 0.0);
  }
}

TEST(RenderSession, NeverGivesTilesOfAnOlderSnapshot) {
  const std::shared_ptr<const RenderScene> scenes[] = {flat_scene(0.25f), flat_scene(0.75f)};
  RenderSession session;
  for (int i = 0; i < 200; ++i) {
    Snapshot snapshot = snapshot_of(Method::uniform, 64 + i % 9, 64, 2);
    snapshot.scene = scenes[i % 2];
    snapshot.camera = test::orthographic(8.0);
    session.restart(snapshot);
    if (i % 3 == 0) std::this_thread::sleep_for(std::chrono::microseconds(200 * (i % 7)));
    for (const FinishedTile& tile : session.take_finished()) {
      for (const glm::vec3& c : tile.radiance) ASSERT_EQ(c.r, i % 2 ? 0.75f : 0.25f) << i;
    }
  }
}

TEST(RenderSession, RestartsAThousandTimes) {
  std::atomic<int> calls{0};
  RenderSession session([&] { ++calls; });
  std::size_t tiles = 0;
  for (int i = 0; i < 1000; ++i) {
    session.restart(snapshot_of(i % 2 ? Method::asos : Method::stochastic, 96, 64, 2));
    if (i % 10 == 0) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    tiles += session.take_finished().size();
    EXPECT_GE(session.progress().fraction, 0.0);
    if (i % 50 == 0) session.cancel();
  }
  session.wait();
  for (const FinishedTile& tile : session.take_finished()) tiles += !tile.radiance.empty();
  EXPECT_TRUE(session.progress().finished);
  EXPECT_GT(tiles, 6u);
  EXPECT_GT(calls, 0);
}

// Workers check between samples whether to stop. The CPU time until they do is a small part of a
// block's. (CPU time, because other load stretches wall-clock times.)
TEST(RenderSession, CancelKeepsWhatWasPublishedAndIsQuick) {
  Snapshot block = snapshot_of(Method::stochastic, 320, 184, 1);
  block.settings.crop = {160, 96, block_size, block_size};
  block.settings.sampling.spp = 1024;
  const double before = test::processor_seconds();
  ASSERT_FALSE(render_to_end(block).film.radiance.empty());
  constexpr int spp = 65536;
  const double block_seconds = (test::processor_seconds() - before) * spp / 1024;

  Snapshot snapshot = snapshot_of(Method::stochastic, 320, 184, 2);
  snapshot.settings.sampling.spp = spp;  // hours of work
  RenderSession session;
  std::vector<double> seconds;
  for (int i = 0; i < 9; ++i) {
    session.restart(snapshot);
    while (session.progress().running && session.reached().pass < Reached::Pass::samples)
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    const double start = test::processor_seconds();
    session.cancel();
    seconds.push_back(test::processor_seconds() - start);
    EXPECT_FALSE(session.progress().running);
    EXPECT_FALSE(session.progress().finished);
  }
  EXPECT_FALSE(session.take_finished().empty());
  std::sort(seconds.begin(), seconds.end());
  EXPECT_LT(seconds[4], block_seconds / 20.0) << "median of nine; a block: " << block_seconds;
}

TEST(RenderSession, RefusesWhatCannotBeRendered) {
  RenderSession session;
  EXPECT_FALSE(session.progress().running);
  EXPECT_FALSE(session.progress().finished);
  Snapshot nothing;
  session.restart(nothing);
  session.wait();
  EXPECT_TRUE(session.progress().finished);
  Snapshot wrong = snapshot_of(Method::uniform, 64, 64, 1);
  wrong.settings.crop = {60, 60, 10, 10};
  session.restart(wrong);
  EXPECT_TRUE(session.progress().finished);
  EXPECT_TRUE(session.take_finished().empty());
  EXPECT_TRUE(render_to_end(wrong).film.radiance.empty());
}

TEST(RenderSession, CamerasThatAreNotFiniteDoNotHang) {
  Snapshot snapshot = snapshot_of(Method::uniform, 64, 48, 2);
  snapshot.camera.world_from_camera[3].x = std::numeric_limits<double>::quiet_NaN();
  const RenderResult result = render_to_end(snapshot);
  for (const glm::vec3& c : result.film.radiance) EXPECT_TRUE(std::isfinite(c.r));
}

/// Renders, and returns the estimates of the total time relative to the extrapolated one.
std::vector<double> relative_estimates(const Snapshot& snapshot) {
  RenderSession session;
  session.restart(snapshot);
  std::vector<double> estimates;
  while (!session.progress().finished) {
    const double share_before = session.reached().final_share;
    const Progress p = session.progress();
    const double share_after = session.reached().final_share;
    if (p.seconds_left > 0.0 && p.fraction > 0.1 && p.fraction < 0.9) {
      estimates.push_back((p.seconds + p.seconds_left) * p.fraction / p.seconds);
      // Groups of blocks are published once all of them are finished.
      EXPECT_GT(p.fraction, share_before - 0.05);
      EXPECT_LT(p.fraction, share_after + 0.15);
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  return estimates;
}

// With uniform work the truth is known at every time, independently of other load: elapsed and
// remaining time are proportional to finished and remaining work. The first estimate needs some
// time, in which a fast machine finishes the picture: then it gets more samples.
TEST(RenderSession, EstimateOfTheTimeLeftIsHonest) {
  Snapshot snapshot = snapshot_of(Method::stochastic, 512, 512, 2);
  snapshot.scene = flat_scene(0.5f);
  snapshot.camera = test::orthographic(8.0);
  snapshot.settings.sampling.spp = test::sanitized ? 2 : 16;
  snapshot.progressive = false;
  std::vector<double> estimates = relative_estimates(snapshot);
  for (int tries = 0; estimates.size() <= 3 && tries < 6; ++tries) {
    snapshot.settings.sampling.spp *= 2;
    estimates = relative_estimates(snapshot);
  }
  ASSERT_GT(estimates.size(), 3u);
  std::sort(estimates.begin(), estimates.end());
  EXPECT_GT(estimates[estimates.size() / 2], 0.5);
  EXPECT_LT(estimates[estimates.size() / 2], 2.0);
}

}  // namespace
}  // namespace asos
