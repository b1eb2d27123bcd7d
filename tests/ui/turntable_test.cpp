#include "ui/turntable.h"

#include "tests/ui/panels_fixture.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace asos {
using namespace ui;
namespace {

constexpr double pi = std::numbers::pi;

/// Azimuth of the eye about the vertical axis, counter-clockwise seen from above, from +Z to +X.
double azimuth_rad(const OrbitCamera& camera) {
  const glm::dvec3 back(camera.camera().world_from_camera[2]);
  return std::atan2(back.x, back.z);
}

OrbitCamera from_the_front() {
  OrbitCamera camera;
  Camera lens;
  lens.world_from_camera[3] = glm::dvec4(0, 0, 5, 1);
  camera.set(lens, 5.0, 1.0);
  return camera;
}

TEST(Turntable, GoesAsFarOnAsTimeHasGone) {
  OrbitCamera camera = from_the_front();
  Turntable turntable;
  turntable.seconds_a_turn = 8.0;
  turntable.update(camera, true, 1.0);
  EXPECT_EQ(azimuth_rad(camera), 0.0) << "it has not been switched on";
  turntable.set_turning(true);
  turntable.update(camera, true, 2.0);
  turntable.update(camera, true, 3.0);
  EXPECT_NEAR(azimuth_rad(camera), pi / 4.0, 1e-12);
  // The camera waits until its picture is displayed, but the angle makes up for that time.
  turntable.update(camera, false, 3.5);
  EXPECT_NEAR(azimuth_rad(camera), pi / 4.0, 1e-12);
  turntable.update(camera, true, 4.0);
  EXPECT_NEAR(azimuth_rad(camera), pi / 2.0, 1e-12);
  EXPECT_LT(glm::distance(camera.pivot(), glm::dvec3(0.0)), 1e-12);
  EXPECT_NEAR(camera.eye().x, 5.0, 1e-12);
}

TEST(Turntable, StopsWhereSomebodyTurnsTheCamera) {
  OrbitCamera camera = from_the_front();
  Turntable turntable;
  turntable.set_turning(true);
  turntable.update(camera, true, 0.0);
  camera.dolly(0.5);
  camera.pan(0.1, 0.2);
  turntable.update(camera, true, 1.0);
  EXPECT_TRUE(turntable.turning()) << "dolly and pan do not stop it";
  const double turned = azimuth_rad(camera);
  EXPECT_GT(turned, 0.0);
  camera.orbit(0.0, 0.1);
  turntable.update(camera, true, 2.0);
  EXPECT_FALSE(turntable.turning());
  EXPECT_EQ(azimuth_rad(camera), turned);
}

TEST(Turntable, ItsTimesAreWithinTheirRange) {
  OrbitCamera camera = from_the_front();
  Turntable turntable;
  turntable.seconds_a_turn = 0.0;
  turntable.set_turning(true);
  turntable.update(camera, true, 0.0);
  turntable.update(camera, true, 0.25);
  EXPECT_NEAR(azimuth_rad(camera), pi / 2.0, 1e-12) << "no faster than a turn a second";
}

using TurntableInTheWindow = test::PanelsTest;

TEST_F(TurntableInTheWindow, TurnsByKeyOrSwitchUntilTheCameraIsDragged) {
  const OrbitCamera& camera = rig.camera();
  Turntable& turntable = rig.previewer().turntable();
  const double start = azimuth_rad(camera);
  const glm::dvec3 pivot = camera.pivot();
  EXPECT_FALSE(rig.controls().contains("Turn time"));
  rig.key(Key::t);
  EXPECT_TRUE(turntable.turning());
  EXPECT_TRUE(rig.frames_until([&] { return std::abs(azimuth_rad(camera) - start) > 0.2; }));
  EXPECT_TRUE(rig.controls().contains("Turn time"));
  EXPECT_LT(glm::distance(camera.pivot(), pivot), 1e-12);
  // A window that sleeps between frames continues by itself.
  const double here = azimuth_rad(camera);
  EXPECT_FALSE(rig.sleeps(0.5));
  EXPECT_NE(azimuth_rad(camera), here);

  rig.drag({200, 300}, {220, 300});
  EXPECT_FALSE(turntable.turning());
  EXPECT_TRUE(rig.settle()) << "the picture refines to its end again";
  rig.click("Turntable");
  EXPECT_TRUE(turntable.turning());
  rig.key(Key::t);
  EXPECT_FALSE(turntable.turning());
}

// A turn is one undo step, however long it was.
TEST_F(TurntableInTheWindow, IsUndoneAsAWhole) {
  const OrbitCamera& camera = rig.camera();
  const double start = azimuth_rad(camera);
  rig.key(Key::t);
  EXPECT_TRUE(rig.frames_until([&] { return std::abs(azimuth_rad(camera) - start) > 0.2; }));
  rig.key(Key::t);
  for (int i = 0; i < 40; ++i) rig.frame();
  rig.chord(Key::ctrl, Key::z);
  EXPECT_NEAR(azimuth_rad(camera), start, 1e-12);
}

// A wide scene that fills the picture from its end is also inside it from its side.
TEST_F(TurntableInTheWindow, MakesRoomWhereEverythingIsFramed) {
  const OrbitCamera& camera = rig.camera();
  rig.camera().orbit(pi / 2.0, 0.0);
  rig.viewpoint().frame_all();
  const double framed = camera.distance();
  rig.key(Key::t);
  rig.frame();
  EXPECT_GT(camera.distance(), 1.2 * framed);
  rig.key(Key::t);
  // A distance that the user changed stays.
  rig.viewpoint().frame_all();
  rig.camera().dolly(0.5);
  const double near = camera.distance();
  rig.key(Key::t);
  rig.frame();
  EXPECT_EQ(camera.distance(), near);
}

}  // namespace
}  // namespace asos
