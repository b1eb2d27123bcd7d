#include "tests/ui/panels_fixture.h"

#include <gtest/gtest.h>

namespace asos {
namespace {

using CameraPanelTest = test::PanelsTest;

TEST_F(CameraPanelTest, LooksFromASideByKeyOrButton) {
  const auto back = [this] {
    return glm::dvec3(rig.previewer().viewpoint().camera().camera().world_from_camera[2]);
  };
  const auto expect_back = [&](glm::dvec3 expected) {
    EXPECT_LT(glm::distance(back(), expected), 1e-12);
  };
  const glm::dvec3 pivot = rig.previewer().viewpoint().camera().pivot();
  rig.key(Key::three);
  expect_back({1, 0, 0});
  rig.chord(Key::ctrl, Key::three);
  expect_back({-1, 0, 0});
  rig.key(Key::seven);
  expect_back({0, 1, 0});
  rig.chord(Key::ctrl, Key::seven);
  expect_back({0, -1, 0});
  rig.chord(Key::ctrl, Key::one);
  expect_back({0, 0, -1});
  rig.key(Key::one);
  expect_back({0, 0, 1});
  rig.click("Right");
  expect_back({1, 0, 0});
  rig.click("Top");
  expect_back({0, 1, 0});
  rig.click("Front");
  expect_back({0, 0, 1});
  EXPECT_LT(glm::distance(rig.previewer().viewpoint().camera().pivot(), pivot), 1e-12);
  EXPECT_TRUE(restarted());
}

TEST_F(CameraPanelTest, TheLensIsChangedAndUndone) {
  const auto lens = [this] { return rig.previewer().viewpoint().camera().camera(); };
  const double fov = lens().fov_y_rad;
  rig.key(Key::five);
  EXPECT_EQ(lens().type, Camera::Type::orthographic);
  EXPECT_TRUE(restarted());
  EXPECT_FALSE(rig.content().controls().all().contains("Field of view"));
  rig.click("Projection/Perspective");
  EXPECT_EQ(lens().type, Camera::Type::perspective);
  EXPECT_TRUE(restarted());
  for (int i = 0; i < 40; ++i) rig.frame();
  slide("Field of view", 0.4f, 0.6f);
  EXPECT_NEAR(lens().fov_y_rad, glm::radians(1.0 + 0.6 * 169.0), 0.05);
  EXPECT_TRUE(restarted());
  for (int i = 0; i < 40; ++i) rig.frame();
  rig.chord(Key::ctrl, Key::z);
  EXPECT_NEAR(lens().fov_y_rad, fov, 1e-12);
}

}  // namespace
}  // namespace asos
