#pragma once

#include "renderer/scene/builtin.h"
#include "renderer/session/planned_render.h"
#include "renderer/session/run_clock.h"
#include "renderer/session/sample_rounds.h"
#include "renderer/session/tile_collector.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <vector>

// A picture of the built-in fence, for tests of rounds and steps.

namespace asos::test::fence_picture {

inline constexpr int width = 160;
inline constexpr int height = 90;

inline Snapshot fence(int threads, Method method = Method::asos) {
  static const auto scene = *prepare(*builtin_scene("fence"));
  Snapshot snapshot;
  snapshot.scene = scene;
  (void)scene->features();
  snapshot.camera = first_camera(scene->world(), double{width} / height);
  snapshot.settings.method = method;
  snapshot.settings.width = width;
  snapshot.settings.height = height;
  snapshot.settings.threads = threads;
  snapshot.settings.shadow.cast = false;  // shadows take a third of the time
  return snapshot;
}

/// A picture of the fence after its rounds of samples, without steps.
struct Sampled {
  PlannedRender render{fence(1)};
  TileCollector tiles{render.plan, {}};
  SampleRounds samples{render};
  RunClock clock;

  Sampled() {
    clock.begin_forecast();
    for (const std::size_t round : {0, 1, 2})
      EXPECT_FALSE(samples.work(render, round, tiles, clock, {}));
    EXPECT_TRUE(samples.wait_for_rounds(3, {}));
  }
};

}  // namespace asos::test::fence_picture
