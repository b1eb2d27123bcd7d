#include "ui/previewer.h"

#include "renderer/picture/picture_description.h"
#include "renderer/shading/sky.h"
#include "renderer/world/ground.h"
#include "tests/ui/previewer_fixture.h"

#include <cmath>
#include <memory>

namespace asos::test::previewer_test {
using namespace ui;
namespace {

TEST_F(PreviewerTest, RendersTheSceneThatItOpens) {
  ASSERT_TRUE(opens("red", {48, 32}));
  ASSERT_TRUE(finished());
  previewer.update(now);
  ASSERT_EQ(previewer.render().film().width, 48);
  ASSERT_EQ(previewer.render().film().height, 32);
  EXPECT_EQ(previewer.render().film().radiance[previewer.render().film().index(24, 16)],
            glm::vec3(1, 0, 0));
  EXPECT_EQ(previewer.render().restarts(), 1u);
  EXPECT_GT(wakes, 0);
}

// Other threads continue during the call, so the progress before and after it are its bounds.
TEST_F(PreviewerTest, WhatMovesByItselfIsShownForAMomentOrASampleAPixel) {
  const PreviewRender& render = previewer.render();
  previewer.viewpoint().set_picture_size(1200, 900, now);
  previewer.edits().settings().method = Method::uniform;
  ASSERT_TRUE(opens("red"));
  bool waited = false;
  for (const double start = now; !waited || !render.shown_for(1.0, start);) {
    previewer.update(start);
    const Reached::Pass before = render.reached().pass;
    const bool long_enough = render.shown_for(1.0, start);
    const Reached::Pass after = render.reached().pass;
    const bool covered = !render.first_picture_pending();
    ASSERT_TRUE(long_enough || before < Reached::Pass::samples || !covered);
    ASSERT_TRUE(!long_enough || after >= Reached::Pass::samples);
    ASSERT_TRUE(!covered || render.shown_for(1.0, start + 1.0));
    waited |= covered && !long_enough;
    if (render.progress().finished) break;
  }
  EXPECT_TRUE(waited) << "otherwise nothing was tested";
}

TEST_F(PreviewerTest, LinesFollowTheCameraOnceItRests) {
  ASSERT_TRUE(opens("lines", {48, 32}));
  const auto positions = [&] { return previewer.scene()->world().positions; };
  ASSERT_TRUE(update_until([&] { return previewer.scene()->world().lines_and_points.drawn(); }));
  ASSERT_TRUE(finished());
  previewer.update(now);
  const auto pixel = previewer.render().film().index(24, 15);
  EXPECT_EQ(previewer.render().film().radiance.size(), 48u * 32u);
  EXPECT_GT(previewer.render().film().radiance[pixel].g, 0.5f) << "the line is white";

  // Lines stay as they are during the movement.
  const auto before = positions();
  for (int i = 0; i < 20; ++i) {
    previewer.viewpoint().camera().orbit(0.01, 0.0);
    previewer.update(now += 0.05);
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
    EXPECT_EQ(positions(), before);
  }
  const std::optional<double> due = previewer.seconds_to_update(now);
  ASSERT_TRUE(due);
  EXPECT_LE(*due, 0.15);
  now += 0.2;
  EXPECT_TRUE(update_until([&] { return positions() != before; }));
  EXPECT_TRUE(finished());

  // Lines of another width, and no lines.
  const auto thin = positions();
  previewer.edits().settings().line_width = 3.0;
  previewer.update(now);
  now += 0.2;
  EXPECT_TRUE(update_until([&] { return positions() != thin; }));
  previewer.edits().settings().line_width = 0.0;
  previewer.update(now);
  now += 0.2;
  EXPECT_TRUE(update_until([&] { return !previewer.scene()->world().lines_and_points.drawn(); }));
  EXPECT_TRUE(finished());
}

// If lights and lines change at once, both changes arrive.
TEST_F(PreviewerTest, LinesAndLightsChangeTogether) {
  ASSERT_TRUE(opens("lines", {48, 32}));
  for (int i = 0; i < 20; ++i) {
    std::optional<Dfr>& dfr = previewer.edits().edit_dfrs()[0];
    dfr = Dfr{};
    dfr->perturbation = 0.01 * i;
    previewer.edits().settings().line_width = 1.0 + 0.1 * i;
    for (int k = 0; k < 3; ++k) {
      previewer.update(now += 0.1);
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
  }
  now += 0.2;
  ASSERT_TRUE(finished());
  ASSERT_TRUE(previewer.scene()->dfrs()[0]);
  EXPECT_EQ(previewer.scene()->dfrs()[0]->perturbation, 0.01 * 19);
  EXPECT_TRUE(previewer.scene()->world().lines_and_points.drawn());
}

TEST_F(PreviewerTest, ScenesWithoutLightsOpenOnTheGroundInAStudio) {
  previewer.edits().keep_first({});
  previewer.viewpoint().set_picture_size(48, 32, now);
  const auto sky = [&] { return previewer.edits().settings().sky.get(); };
  ASSERT_TRUE(opens("red"));
  ASSERT_TRUE(sky());
  EXPECT_EQ(sky()->choice().environment, Environment::softboxes);
  const auto settings = [&]() -> RenderSettings& { return previewer.edits().settings(); };
  EXPECT_EQ(settings().ground, Ground::on);
  EXPECT_EQ(settings().background.kind, BackgroundKind::colours);
  ASSERT_TRUE(opens("many"));
  EXPECT_EQ(sky(), nullptr) << "it has lights";
  EXPECT_EQ(settings().ground, Ground::off);
  EXPECT_EQ(settings().background, Background{});
  // A sky that was chosen stays until everything is reset.
  previewer.edits().set_sky(std::make_shared<const Sky>(Environment::dusk));
  ASSERT_TRUE(opens("red"));
  EXPECT_EQ(sky()->choice().environment, Environment::dusk);
  EXPECT_EQ(settings().background, Background{}) << "that of the sky";
  previewer.edits().reset();
  ASSERT_TRUE(opens("green"));
  EXPECT_EQ(sky()->choice().environment, Environment::softboxes);
  EXPECT_EQ(settings().background.kind, BackgroundKind::colours);
  // A part that was chosen separately stays, too.
  settings().ground = Ground::off;
  settings().background.kind = BackgroundKind::blurred;
  ASSERT_TRUE(opens("red"));
  EXPECT_EQ(settings().ground, Ground::off);
  EXPECT_EQ(settings().background.kind, BackgroundKind::blurred);
  previewer.edits().set_sky(nullptr);
  ASSERT_TRUE(opens("red"));
  EXPECT_EQ(sky(), nullptr) << "neutral grey was chosen";
}

// The ground stays for any other edit, and is not part of the reported scene.
TEST_F(PreviewerTest, PutsTheSceneOnTheGroundThatIsAskedFor) {
  ASSERT_TRUE(opens("lines", {48, 32}));
  ASSERT_TRUE(finished());
  previewer.viewpoint().frame_all();
  const Camera before = previewer.viewpoint().camera().camera();
  const auto stands_on = [&](Ground ground) {
    previewer.edits().settings().ground = ground;
    const bool stands =
        update_until([&] { return ground_of(previewer.scene()->world()) == ground; });
    now += 0.2;
    return stands && finished();
  };
  ASSERT_TRUE(stands_on(Ground::on));
  EXPECT_TRUE(previewer.scene()->world().lines_and_points.drawn());
  previewer.viewpoint().frame_all();
  EXPECT_EQ(previewer.viewpoint().camera().camera().world_from_camera, before.world_from_camera);
  ASSERT_TRUE(stands_on(Ground::mirror));
  previewer.edits().edit_dfrs()[0].emplace();
  previewer.edits().edit_lights().clear();
  ASSERT_TRUE(finished());
  EXPECT_TRUE(previewer.scene()->dfrs()[0]);
  EXPECT_TRUE(previewer.scene()->lights().empty());
  EXPECT_EQ(ground_of(previewer.scene()->world()), Ground::mirror);
  const PictureDescription told = describe(*previewer.scene(), before, {}, {});
  EXPECT_EQ(told.dfrs->size(), materials_without_ground(previewer.scene()->world()));
  EXPECT_EQ(told.dfrs->size() + 1, previewer.scene()->world().materials.size());
  ASSERT_TRUE(stands_on(Ground::off));
  EXPECT_TRUE(previewer.scene()->dfrs()[0]);
  EXPECT_EQ(previewer.edits().dfrs().size(), previewer.scene()->world().materials.size());
}

TEST_F(PreviewerTest, UsesTheFilesCameraAndOrbitsWhatItLooksAt) {
  ASSERT_TRUE(opens("red", {48, 32}));
  EXPECT_EQ(previewer.viewpoint().chosen_camera(), 0);
  EXPECT_NEAR(previewer.viewpoint().camera().distance(), 3.0, 1e-6);
  EXPECT_NEAR(
      glm::length(previewer.viewpoint().camera().pivot() + previewer.scene()->world().origin), 0.0,
      1e-6);
}

TEST_F(PreviewerTest, OnlyWhatTheRenderDependsOnRestartsIt) {
  ASSERT_TRUE(opens("red", {48, 32}));
  ASSERT_TRUE(finished());
  for (int i = 0; i < 10; ++i) previewer.update(now += 1.0);
  EXPECT_EQ(previewer.render().restarts(), 1u);

  std::uint64_t expected = 1;
  const auto restarts_after = [&](const std::function<void()>& change) {
    ASSERT_TRUE(finished());
    change();
    previewer.update(now);
    EXPECT_EQ(previewer.render().restarts(), ++expected);
  };
  restarts_after([&] { previewer.edits().settings().asos.eps = 0.1; });
  restarts_after([&] { previewer.edits().settings().asos.max_level = 4; });
  restarts_after([&] { previewer.edits().settings().asos.leaf = LeafKind::point; });
  restarts_after([&] { previewer.edits().settings().asos.jitter = true; });
  restarts_after([&] { previewer.edits().settings().method = Method::stochastic; });
  restarts_after([&] { previewer.viewpoint().camera().orbit(0.1, 0.0); });
  restarts_after([&] { previewer.viewpoint().frame_all(); });
  restarts_after([&] { previewer.viewpoint().choose_camera(-1); });
}

// A framed scene stays in view while it is orbited, although its nearest surface is far in front of
// its centre. It fills pictures of other aspect ratios until the camera is moved.
TEST_F(PreviewerTest, TheViewThatFramesEverythingOrbitsItsMiddle) {
  ASSERT_TRUE(opens("red", {48, 32}));
  previewer.viewpoint().choose_camera(-1);
  OrbitCamera& camera = previewer.viewpoint().camera();
  const Box& bounds = previewer.scene()->world().bounds;
  const glm::dvec3 middle(0.5f * (bounds.lo + bounds.hi));
  const double radius = 0.5 * static_cast<double>(glm::distance(bounds.lo, bounds.hi));
  EXPECT_LT(glm::distance(camera.pivot(), middle), 0.3 * radius);

  const glm::dvec3 eye = camera.eye();
  previewer.viewpoint().set_picture_size(32, 48, now += 1.0);
  previewer.update(now += 1.0);
  EXPECT_GT(glm::distance(camera.eye(), eye), 0.1 * radius) << "framed in the other shape";
  const glm::dvec3 framed = camera.eye();
  camera.orbit(0.2, 0.0);
  const glm::dvec3 orbited = camera.eye();
  previewer.viewpoint().set_picture_size(48, 32, now += 1.0);
  previewer.update(now += 1.0);
  EXPECT_EQ(camera.eye(), orbited) << "the user has moved the camera";
  EXPECT_NE(framed, orbited);
}

// The whole view of the file's camera is shown, for any aspect ratio of the picture.
TEST_F(PreviewerTest, AWideCameraFitsThePictureUntilItIsLeft) {
  Viewpoint& viewpoint = previewer.viewpoint();
  const auto half_height = [&] { return std::tan(0.5 * viewpoint.camera().camera().fov_y_rad); };
  const double half_width = 3.0 * std::tan(0.25);
  viewpoint.set_picture_size(48, 32, now);
  ASSERT_TRUE(opens("wide"));
  EXPECT_NEAR(half_height() * 48 / 32, half_width, 1e-9);
  const Viewpoint::State before = viewpoint.state();
  viewpoint.set_picture_size(32, 48, now += 1.0);
  previewer.update(now += 1.0);
  EXPECT_NEAR(half_height() * 32 / 48, half_width, 1e-9);
  EXPECT_TRUE(viewpoint.same_as(before)) << "no step to undo";
  viewpoint.set_picture_size(320, 80, now += 1.0);
  previewer.update(now += 1.0);
  EXPECT_NEAR(half_height(), std::tan(0.25), 1e-9) << "the camera's own height";
  viewpoint.camera().orbit(0.2, 0.0);
  viewpoint.set_picture_size(48, 32, now += 1.0);
  previewer.update(now += 1.0);
  EXPECT_NEAR(half_height(), std::tan(0.25), 1e-9) << "the user has moved the camera";
}

TEST_F(PreviewerTest, AFramedViewInAnotherShapeIsNoStepToUndo) {
  ASSERT_TRUE(opens("red", {48, 32}));
  previewer.viewpoint().choose_camera(-1);
  const Viewpoint::State before = previewer.viewpoint().state();
  previewer.viewpoint().set_picture_size(32, 48, now += 1.0);
  previewer.update(now += 1.0);
  EXPECT_TRUE(previewer.viewpoint().same_as(before));
  const glm::dvec3 framed = previewer.viewpoint().camera().eye();
  previewer.viewpoint().camera().orbit(1.0, 0.0);
  EXPECT_FALSE(previewer.viewpoint().same_as(before));
  EXPECT_TRUE(previewer.viewpoint().left_chosen());
  previewer.viewpoint().restore(before);
  EXPECT_FALSE(previewer.viewpoint().left_chosen());
  EXPECT_LT(glm::distance(previewer.viewpoint().camera().eye(), framed), 1e-9)
      << "in the picture's present shape";
}

// A drag changes the camera faster than a coarse picture takes. Without waiting, only the picture's
// centre would ever be updated.
TEST_F(PreviewerTest, AFloodOfChangesStillShowsWholePictures) {
  ASSERT_TRUE(opens("red", {800, 600}));
  ASSERT_TRUE(finished());
  constexpr int changes = 300;
  int whole = 0;
  for (int i = 0; i < changes; ++i) {
    const std::uint64_t before = previewer.render().restarts();
    previewer.viewpoint().camera().orbit(0.01, 0.0);
    previewer.update(now);
    // The test's clock stands still, so only a complete picture lets the next render start.
    if (previewer.render().restarts() > before) ++whole;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  EXPECT_GT(whole, 1);
  EXPECT_LT(whole, changes);
  ASSERT_TRUE(finished());
  EXPECT_FALSE(previewer.render().first_picture_pending());
}

TEST_F(PreviewerTest, ASlowFirstPictureHoldsChangesUpForAMomentOnly) {
  ASSERT_TRUE(opens("red", {2000, 1500}));
  const std::uint64_t before = previewer.render().restarts();
  previewer.viewpoint().camera().orbit(0.01, 0.0);
  previewer.update(now += 1.1);
  EXPECT_EQ(previewer.render().restarts(), before + 1);
}

TEST_F(PreviewerTest, ResizingWaitsUntilTheSizeRests) {
  ASSERT_TRUE(opens("red", {48, 32}));
  for (int width = 49; width < 60; ++width) {
    now += 0.02;
    previewer.viewpoint().set_picture_size(width, 32, now);
    previewer.update(now);
  }
  EXPECT_EQ(previewer.render().restarts(), 1u);
  ASSERT_TRUE(previewer.seconds_to_update(now).has_value());
  now += *previewer.seconds_to_update(now) + 1e-9;
  previewer.viewpoint().set_picture_size(59, 32, now);
  previewer.update(now);
  EXPECT_EQ(previewer.render().restarts(), 2u);
  EXPECT_EQ(previewer.render().film().width, 59);
  EXPECT_FALSE(previewer.seconds_to_update(now).has_value());
}

TEST_F(PreviewerTest, ASizeWithoutAreaChangesNothing) {
  ASSERT_TRUE(opens("red", {0, 0}));
  EXPECT_EQ(previewer.render().restarts(), 0u);
  previewer.viewpoint().set_picture_size(48, 32, now);
  previewer.update(now);
  EXPECT_EQ(previewer.render().restarts(), 1u);
  previewer.viewpoint().set_picture_size(0, 32, now += 1.0);
  previewer.update(now += 1.0);
  previewer.viewpoint().set_picture_size(48, 32, now += 1.0);
  previewer.update(now += 1.0);
  EXPECT_EQ(previewer.render().restarts(), 1u);
  EXPECT_EQ(previewer.render().film().width, 48);
}

TEST_F(PreviewerTest, ThePivotMovesToThePointThatThePictureShows) {
  ASSERT_TRUE(opens("red", {90, 60}));
  const View view(previewer.viewpoint().camera().camera(), 90, 60);
  const Ray ray = view.ray(50.0, 35.0);
  previewer.viewpoint().set_pivot_at(50.0, 35.0);
  const glm::dvec3 pivot =
      previewer.viewpoint().camera().pivot() + previewer.scene()->world().origin;
  EXPECT_NEAR(pivot.z, 0.0, 1e-5);
  EXPECT_NEAR(
      glm::length(glm::cross(glm::dvec3(ray.direction),
                             previewer.viewpoint().camera().pivot() - glm::dvec3(ray.origin))),
      0.0, 1e-5);
  // There is no surface: the pivot stays.
  const std::uint64_t before = previewer.viewpoint().camera().revision();
  previewer.viewpoint().set_pivot_at(0.5, 59.5);
  EXPECT_EQ(previewer.viewpoint().camera().revision(), before);
}

}  // namespace
}  // namespace asos::test::previewer_test
