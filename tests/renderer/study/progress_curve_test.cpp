#include "renderer/study/progress_curve.h"

#include "renderer/comparison/method.h"
#include "renderer/gltf/load.h"
#include "renderer/session/film_render.h"
#include "tests/support/processor_seconds.h"
#include "tests/support/render_picture.h"

#include <gtest/gtest.h>

namespace asos {
namespace {

class WatchedBoxes : public testing::Test {
 protected:
  void SetUp() override {
    const auto scene = load_scene("builtin:boxes");
    ASSERT_TRUE(scene);
    const auto ready = prepare(*scene);
    ASSERT_TRUE(ready);
    (void)(*ready)->features();
    snapshot.scene = *ready;
    snapshot.camera = test::first_camera((*ready)->world(), 64.0 / 36.0);
    snapshot.settings.width = 64;
    snapshot.settings.height = 36;
    snapshot.settings.threads = 2;
    snapshot.settings.asos.max_level = 2;
    snapshot.settings.sampling.spp = 64;
  }

  Snapshot snapshot;
};

TEST_F(WatchedBoxes, EndWithTheFinishedPicture) {
  for (const Method method : {Method::asos, Method::sobol, Method::mitchell}) {
    snapshot.settings.method = method;
    snapshot.progressive = true;
    const RecordedRender watched = watch_render(snapshot, study_factor);
    ASSERT_GE(watched.pictures.size(), 2u) << row_of(method).name;
    EXPECT_TRUE(watched.finished);
    const TimedPicture& last = watched.pictures.back();
    EXPECT_EQ(last.film.radiance, render_to_end(snapshot).film.radiance) << row_of(method).name;
    EXPECT_EQ(last.reached.pass, Reached::Pass::final_pixels);
    EXPECT_TRUE(last.progress.finished);
  }
}

TEST_F(WatchedBoxes, BeginWithAWholePictureAndKeepTheirDistance) {
  const RecordedRender watched = watch_render(snapshot, study_factor);
  ASSERT_GE(watched.pictures.size(), 2u);
  EXPECT_GE(watched.pictures[0].seconds, 1e-4) << "an earlier time is wrong";
  for (const TimedPicture& picture : watched.pictures) {
    EXPECT_EQ(picture.film.radiance.size(), 64u * 36u);
    EXPECT_NE(picture.reached.pass, Reached::Pass::nothing);
  }
  for (std::size_t i = 1; i < watched.pictures.size(); ++i) {
    const double before = watched.pictures[i - 1].seconds, now = watched.pictures[i].seconds;
    EXPECT_GE(now, (i + 1 < watched.pictures.size() ? study_factor : 1.0) * before);
  }
}

TEST_F(WatchedBoxes, OfARenderWithoutPassesAreTheFinishedOne) {
  snapshot.progressive = false;
  const RecordedRender watched = watch_render(snapshot, study_factor);
  ASSERT_EQ(watched.pictures.size(), 1u);
  EXPECT_TRUE(watched.finished);
  EXPECT_EQ(watched.pictures[0].film.radiance, render_to_end(snapshot).film.radiance);
  EXPECT_GT(watched.pictures[0].seconds, 0.0);
}

// The picture takes so long that the test has to stop it.
TEST_F(WatchedBoxes, AStopKeepsThePicturesUntilThen) {
  snapshot.settings.method = Method::sobol;
  snapshot.settings.sampling.spp = 65536;
  EXPECT_TRUE(watch_render(snapshot, study_factor, [] { return true; }).pictures.empty());
  // The first picture takes some thousandths of this time.
  const double start = test::processor_seconds();
  const RecordedRender watched =
      watch_render(snapshot, study_factor, [&] { return test::processor_seconds() > start + 0.2; });
  EXPECT_FALSE(watched.finished);
  EXPECT_FALSE(watched.pictures.empty());
}

}  // namespace
}  // namespace asos
