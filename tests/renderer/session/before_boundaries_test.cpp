// Renders of scenes whose edges are still being searched.

#include "renderer/features/stoppable_loop.h"
#include "renderer/session/film_render.h"
#include "renderer/session/render_session.h"
#include "tests/support/expect_same.h"
#include "tests/support/gate.h"
#include "tests/support/tiny_scene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <memory>
#include <new>
#include <optional>
#include <thread>
#include <utility>

namespace asos {
namespace {

using test::Gate;

/// A geometry that finds its edges once `gate` is open.
std::shared_ptr<Geometry> held_geometry(Gate& gate) {
  auto geometry = test::make_geometry(test::still_life().world);
  geometry->boundaries.find([&gate, &world = geometry->world](const std::stop_token& stop) {
    if (!gate.wait(stop)) throw SearchStopped();
    return FeatureSet(world, nullptr, stop);
  });
  return geometry;
}

Snapshot snapshot_of(std::shared_ptr<Geometry> geometry, Method method = Method::asos) {
  Snapshot snapshot;
  Lighting lighting = prepare_lighting(geometry->world, test::still_life().lights);
  snapshot.scene = unedited_scene(std::move(geometry), std::move(lighting));
  snapshot.camera = test::look_at({2, 2, 5}, {0, 0.7, 0}, 0.7);
  snapshot.settings.method = method;
  snapshot.settings.width = 96;
  snapshot.settings.height = 64;
  snapshot.settings.threads = 2;
  snapshot.settings.asos.max_level = 2;
  return snapshot;
}

bool reaches(const RenderSession& session, Reached::Pass pass) {
  for (int i = 0; i < 20'000 && session.reached().pass < pass; ++i)
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  return session.reached().pass >= pass;
}

// Sampling continues where pixels may be wrong.
TEST(BeforeBoundaries, SamplesComeAndNothingElse) {
  Gate gate;
  RenderSession session;
  const Snapshot snapshot = snapshot_of(held_geometry(gate));
  session.restart(snapshot);
  ASSERT_TRUE(reaches(session, Reached::Pass::samples));
  // Pixels with an expected error take more samples than the four of all pixels.
  std::size_t single = 0;
  for (int i = 0; i < 20'000 && single < 100; ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
    for (const FinishedTile& tile : session.take_finished()) {
      EXPECT_TRUE(tile.coarse);
      single += tile.rect.width <= block_size ? 1 : 0;
    }
  }
  EXPECT_GE(single, 100u);
  EXPECT_EQ(session.reached().pass, Reached::Pass::samples);
  EXPECT_EQ(session.reached().samples, 4);
  EXPECT_EQ(session.reached().final_share, 0.0);
  EXPECT_EQ(session.reached().round, 0) << "all rounds are complete";
  EXPECT_EQ(session.reached().rounds, 3);
  EXPECT_FALSE(session.progress().finished);
  EXPECT_TRUE(session.progress().running);
  // A time is only forecast after a quarter of a second.
  for (int i = 0; i < 20'000 && session.progress().seconds < 0.3; ++i)
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  EXPECT_LT(session.progress().seconds_left, 0.0) << "final blocks may take any time";

  gate.open();
  session.wait();
  EXPECT_TRUE(session.progress().finished);
  EXPECT_EQ(session.reached().pass, Reached::Pass::final_pixels);
  EXPECT_EQ(session.reached().round, 0);
}

TEST(BeforeBoundaries, ThePictureIsTheSameInTheEnd) {
  const Snapshot known = snapshot_of(test::make_geometry(test::still_life().world));
  const RenderResult expected = render_to_end(known);
  ASSERT_GT(expected.statistics.split_pixels, 0u) << "or boundaries would not matter";
  for (const bool progressive : {false, true}) {
    Gate gate;
    RenderSession session;
    Snapshot snapshot = snapshot_of(held_geometry(gate));
    snapshot.progressive = progressive;
    session.restart(snapshot);
    if (progressive) {
      ASSERT_TRUE(reaches(session, Reached::Pass::samples));
    }
    gate.open();
    session.wait();
    Film film(96, 64);
    for (const FinishedTile& tile : session.take_finished()) film.put(tile);
    test::expect_same(film, expected.film);
    test::expect_same(session.statistics(), expected.statistics);
  }
}

TEST(BeforeBoundaries, MethodsThatNeedNoneStartNoSearch) {
  Gate closed;
  const auto geometry = held_geometry(closed);
  for (const Method method : {Method::uniform, Method::sobol, Method::whitted}) {
    Snapshot snapshot = snapshot_of(geometry, method);
    snapshot.settings.sampling.spp = 4;
    EXPECT_EQ(render_to_end(snapshot).film.width, 96);
    RenderSession session;
    snapshot.progressive = true;
    session.restart(snapshot);
    session.wait();
    EXPECT_TRUE(session.progress().finished);
  }
  EXPECT_FALSE(geometry->boundaries.running());
  EXPECT_FALSE(geometry->boundaries.known());
}

TEST(BeforeBoundaries, ARenderCanBeCancelledAndReplaced) {
  Gate closed;
  RenderSession session;
  std::weak_ptr<Geometry> first;
  {
    auto geometry = held_geometry(closed);
    first = geometry;
    session.restart(snapshot_of(std::move(geometry)));
  }
  ASSERT_TRUE(reaches(session, Reached::Pass::samples));
  session.restart(snapshot_of(test::make_geometry(test::still_life().world)));
  EXPECT_TRUE(first.expired()) << "the search for edges still uses it";
  session.wait();
  EXPECT_TRUE(session.progress().finished);

  session.restart(snapshot_of(held_geometry(closed)));
  session.cancel();
  EXPECT_FALSE(session.progress().finished);
  EXPECT_FALSE(session.progress().running);
  session.restart(snapshot_of(held_geometry(closed)));
  // The session is destroyed here, whatever its workers are doing.
}

// The render cannot finish: its boundaries are not known before the gate opens.
TEST(BeforeBoundaries, TimeLimitEndsRenderWithSamples) {
  Gate closed;
  bool told = false;
  const std::optional<RenderResult> result =
      FilmRender().render(snapshot_of(held_geometry(closed)), {}, {}, 0.0);
  ASSERT_TRUE(result.has_value());
  ASSERT_TRUE(result->stopped_at.has_value());
  EXPECT_NE(result->stopped_at->pass, Reached::Pass::nothing);
  EXPECT_NE(result->stopped_at->pass, Reached::Pass::final_pixels);
  EXPECT_EQ(result->film.width, 96);
  EXPECT_TRUE(std::any_of(result->film.radiance.begin(), result->film.radiance.end(),
                          [](glm::vec3 pixel) { return pixel.g > 0.0f; }));

  // Without a time limit, the render continues until `go_on` returns false.
  const auto go_on = [&] { return !std::exchange(told, true); };
  EXPECT_FALSE(FilmRender().render(snapshot_of(held_geometry(closed)), go_on, {}).has_value());
}

TEST(BeforeBoundaries, WithoutThemTheRenderFails) {
  const auto geometry = test::make_geometry(test::still_life().world);
  geometry->boundaries.find([](const std::stop_token&) -> FeatureSet { throw std::bad_alloc(); });
  const Snapshot snapshot = snapshot_of(geometry);
  RenderSession session;
  session.restart(snapshot);
  session.wait();
  EXPECT_TRUE(session.progress().failed);
  EXPECT_FALSE(session.progress().finished);
  EXPECT_EQ(session.reached().pass, Reached::Pass::samples) << "the sampled picture is shown";
  EXPECT_FALSE(FilmRender().render(snapshot, {}, {}).has_value());
  EXPECT_FALSE(with_boundaries(snapshot.scene).has_value());
  EXPECT_EQ(notes_of(*snapshot.scene).warnings.size(), 1u);
}

}  // namespace
}  // namespace asos
