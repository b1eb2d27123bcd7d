#include "renderer/prepared/default_look.h"

#include "renderer/gltf/load.h"
#include "renderer/prepared/with_ground.h"
#include "renderer/shading/environments.h"
#include "renderer/world/framing.h"
#include "renderer/world/ground.h"
#include "tests/support/quad_mesh.h"
#include "tests/support/render_picture.h"
#include "tests/support/tiny_world.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <utility>

namespace asos {
namespace {

std::shared_ptr<const RenderScene> without_lights(const std::string& source) {
  Scene scene = load_scene(source).value();
  scene.lights.clear();
  return prepare(scene).value();
}

TEST(DefaultLook, PutsAModelWithoutLightsOnTheGroundInAStudio) {
  const DefaultLook look = default_look(*without_lights("builtin:boxes"));
  ASSERT_TRUE(look.sky);
  EXPECT_EQ(look.sky->choice().environment, Environment::softboxes);
  EXPECT_EQ(look.ground, Ground::on);
}

TEST(DefaultLook, LeavesSceneWithLightsAsItIs) {
  for (const char* source : {"builtin:boxes", "builtin:office", "builtin:fence"}) {
    const DefaultLook look = default_look(*prepare(load_scene(source).value()).value());
    EXPECT_EQ(look.sky, nullptr) << source;
    EXPECT_EQ(look.ground, Ground::off) << source;
  }
}

TEST(DefaultLook, HasNoGroundBetweenViewerAndModel) {
  const auto scene = without_lights("builtin:boxes");
  Camera camera = default_camera(scene->world(), 1.5);
  EXPECT_EQ(default_look(*scene, camera).ground, Ground::on);
  camera.world_from_camera[3].y = static_cast<double>(scene->world().bounds.lo.y) - 1.0;
  EXPECT_EQ(default_look(*scene, camera).ground, Ground::off);
}

TEST(DefaultLook, HasNoGroundBelowARoom) {
  const auto room = without_lights("builtin:office");
  ASSERT_TRUE(room->geometry->stage.has_default_lighting);
  EXPECT_TRUE(room->geometry->stage.default_lighting_inside);
  EXPECT_EQ(default_look(*room).ground, Ground::off);
  EXPECT_FALSE(without_lights("builtin:boxes")->geometry->stage.default_lighting_inside);
}

TEST(DefaultLook, HidesPanelsBehindAColour) {
  for (const EnvironmentRow& row : environments) {
    const bool panels = row.value == Environment::softboxes || row.value == Environment::windows;
    const Sky sky(row.value);
    EXPECT_EQ(default_background(&sky).kind,
              panels ? BackgroundKind::colours : BackgroundKind::environment)
        << row.name;
  }
  EXPECT_EQ(default_background(nullptr), Background{});
  const Sky sky(Environment::softboxes), bright = sky.brightened(4.0),
                                         most = sky.brightened(1000.0);
  EXPECT_EQ(default_background(&bright).bottom, 4.0f * default_background(&sky).bottom);
  RenderSettings settings{.background = default_background(&most)};
  EXPECT_TRUE(validated(settings));
}

/// A matte board that stands upright.
Scene board() {
  Scene scene{.source = "board"};
  test::add_object(scene, test::quad_mesh({-1, 0, 0}, {2, 0, 0}, {0, 2, 0}),
                   Material{.double_sided = true}, "board");
  return scene;
}

// The ground fades to the background's radiance: a view from its middle to the horizon shows no
// rim.
TEST(DefaultLook, TheGroundHasNoVisibleRim) {
  const auto scene = with_ground(prepare(board()).value(), Ground::on).value();
  RenderSettings settings{
      .width = 4, .height = 128, .method = Method::sobol, .sky = default_look(*scene).sky};
  settings.background = default_background(settings.sky.get());
  const Box bounds = bounds_without_ground(scene->world());
  const glm::dvec3 top(0.5f * (bounds.lo + bounds.hi).x, bounds.hi.y + 0.1f, bounds.lo.z - 0.1f);
  for (const double turn : {0.0, 2.0, 4.0}) {
    const glm::dvec3 outward(std::sin(turn), 0.0, std::cos(turn));
    const Film film =
        test::render_picture(*scene, test::look_at(top, top + outward, 0.9), settings).film;
    const auto row = [&](int y) { return film.radiance[film.index(1, y)].g; };
    EXPECT_EQ(row(0), settings.background.top.g);
    EXPECT_GT(row(settings.height - 1), 1.2f * row(0)) << "the lit ground";
    int rim = 1;
    while (rim + 1 < settings.height && row(rim) == row(0)) ++rim;
    EXPECT_NEAR(row(rim), row(0), 0.02f * row(0)) << "row " << rim << ", turn " << turn;
  }
}

}  // namespace
}  // namespace asos
