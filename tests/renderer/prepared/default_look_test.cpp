#include "renderer/prepared/default_look.h"

#include "renderer/gltf/load.h"
#include "renderer/shading/environments.h"
#include "renderer/world/framing.h"

#include <gtest/gtest.h>

#include <string>

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

TEST(DefaultLook, HidesPanelsBehindAGradient) {
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
  RenderSettings settings;
  settings.background = default_background(&most);
  EXPECT_TRUE(validated(settings));
}

}  // namespace
}  // namespace asos
