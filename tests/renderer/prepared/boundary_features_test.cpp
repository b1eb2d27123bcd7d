#include "renderer/prepared/boundary_features.h"

#include "renderer/features/stoppable_loop.h"
#include "renderer/gltf/load.h"
#include "renderer/prepared/render_scene.h"
#include "tests/support/gate.h"
#include "tests/support/tiny_world.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <new>
#include <optional>
#include <thread>

namespace asos {
namespace {

using test::Gate;

TEST(BoundaryFeatures, AreKnownToBeNoneWithoutASearch) {
  const BoundaryFeatures boundaries;
  EXPECT_TRUE(boundaries.known());
  EXPECT_TRUE(boundaries.wait());
  EXPECT_TRUE(boundaries.get().edges().empty());
}

TEST(BoundaryFeatures, BlocksUntilTheSearchEnds) {
  const World world = test::still_life().world;
  Gate gate;
  BoundaryFeatures boundaries;
  boundaries.find([&](const std::stop_token& stop) {
    (void)gate.wait(stop);
    return FeatureSet(world);
  });
  EXPECT_FALSE(boundaries.known());
  std::size_t edges[2] = {};
  {
    std::jthread first([&] { edges[0] = boundaries.get().edges().size(); });
    std::jthread second(
        [&] { edges[1] = boundaries.wait() ? boundaries.get().edges().size() : 0; });
    gate.open();
  }
  EXPECT_TRUE(boundaries.known());
  EXPECT_FALSE(boundaries.failed());
  EXPECT_EQ(edges[0], FeatureSet(world).edges().size());
  EXPECT_EQ(edges[1], edges[0]);
}

TEST(BoundaryFeatures, BeginsTheSearchOnDemandAndOnce) {
  Gate gate;
  std::atomic<int> searches = 0;
  BoundaryFeatures boundaries;
  boundaries.find([&](const std::stop_token& stop) {
    ++searches;
    if (!gate.wait(stop)) throw SearchStopped();
    return FeatureSet();
  });
  EXPECT_FALSE(boundaries.running());
  EXPECT_FALSE(boundaries.known_or_started());
  EXPECT_TRUE(boundaries.running());
  boundaries.start();
  gate.open();
  EXPECT_TRUE(boundaries.wait());
  EXPECT_FALSE(boundaries.running());
  boundaries.start();
  EXPECT_TRUE(boundaries.known_or_started());
  EXPECT_EQ(searches, 1);
}

TEST(BoundaryFeatures, AreNotSoughtWithoutDemand) {
  bool sought = false;
  {
    BoundaryFeatures boundaries;
    boundaries.find([&](const std::stop_token&) {
      sought = true;
      return FeatureSet();
    });
    EXPECT_FALSE(boundaries.known());
    EXPECT_FALSE(boundaries.failed());
    EXPECT_EQ(boundaries.seconds(), 0.0);
  }
  EXPECT_FALSE(sought);
}

TEST(BoundaryFeatures, WaitingEndsWithAStop) {
  Gate gate;
  BoundaryFeatures boundaries;
  boundaries.find([&](const std::stop_token& stop) {
    if (!gate.wait(stop)) throw SearchStopped();
    return FeatureSet();
  });
  std::jthread waits([&](const std::stop_token& stop) {
    EXPECT_FALSE(boundaries.wait(stop));
    EXPECT_FALSE(boundaries.known());
  });
}

TEST(BoundaryFeatures, DestructionStopsTheSearch) {
  Gate never;
  bool stopped = false;
  {
    BoundaryFeatures boundaries;
    boundaries.find([&](const std::stop_token& stop) -> FeatureSet {
      stopped = !never.wait(stop);
      throw SearchStopped();
    });
    boundaries.start();
  }
  EXPECT_TRUE(stopped);
}

TEST(BoundaryFeatures, ReportsAFailedSearch) {
  BoundaryFeatures boundaries;
  boundaries.find([](const std::stop_token&) -> FeatureSet { throw std::bad_alloc(); });
  EXPECT_FALSE(boundaries.wait());
  EXPECT_TRUE(boundaries.failed());
  EXPECT_THROW((void)boundaries.get(), std::bad_alloc);
}

TEST(FeatureSet, EndsSoonOnceAStopIsRequested) {
  const auto flat = flatten(load_scene("builtin:dense").value()).value();
  using Clock = std::chrono::steady_clock;
  // Times in milliseconds, one within each stage.
  for (const int moment : {0, 20, 100, 400, 1200}) {
    std::stop_source source;
    std::optional<Clock::time_point> asked;
    std::jthread asks([&] {
      std::this_thread::sleep_for(std::chrono::milliseconds(moment));
      asked = Clock::now();
      source.request_stop();
    });
    bool stopped = false;
    try {
      const FeatureSet found(flat.world, nullptr, source.get_token());
    } catch (const SearchStopped&) {
      stopped = true;
    }
    asks.join();
    const std::chrono::duration<double> taken = Clock::now() - *asked;
    // The whole search takes seconds; a search that ended before the request was not stopped.
    EXPECT_LT(taken.count(), 1.0) << moment;
    if (moment == 0) {
      EXPECT_TRUE(stopped);
    }
  }
}

TEST(Prepare, LeavesTheBoundariesToTheMethodsThatNeedThem) {
  const auto scene = prepare(load_scene("builtin:boxes").value()).value();
  const RenderFeatures before = scene->render_features;
  EXPECT_FALSE(scene->geometry->boundaries.running()) << "no method needs them yet";
  EXPECT_TRUE(before.intersections) << "they are unknown";
  const auto same = with_boundaries(scene).value();
  EXPECT_EQ(same, scene);
  EXPECT_TRUE(scene->geometry->boundaries.known());
  EXPECT_GT(scene->geometry->boundaries.seconds(), 0.0);
  EXPECT_GT(scene->features().edges().size(), 0u);
  EXPECT_GT(scene->geometry->memory_mb() * 1024.0 * 1024.0,
            static_cast<double>(scene->features().memory_bytes()));
}

}  // namespace
}  // namespace asos
