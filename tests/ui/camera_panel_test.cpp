#include "tests/ui/panels_fixture.h"
#include "ui/camera_text.h"

#include <gtest/gtest.h>
#include <imgui.h>
#include <nlohmann/json.hpp>

#include <string>

namespace asos {
using namespace ui;
namespace {

using CameraPanelTest = test::PanelsTest;

TEST_F(CameraPanelTest, LooksFromASideByKeyOrButton) {
  const auto back = [this] { return glm::dvec3(rig.camera().camera().world_from_camera[2]); };
  const auto expect_back = [&](glm::dvec3 expected) {
    EXPECT_LT(glm::distance(back(), expected), 1e-12);
  };
  const glm::dvec3 pivot = rig.camera().pivot();
  rig.key(Key::pad_three);
  expect_back({1, 0, 0});
  rig.chord(Key::ctrl, Key::pad_three);
  expect_back({-1, 0, 0});
  rig.key(Key::pad_seven);
  expect_back({0, 1, 0});
  rig.chord(Key::ctrl, Key::pad_seven);
  expect_back({0, -1, 0});
  rig.chord(Key::ctrl, Key::pad_one);
  expect_back({0, 0, -1});
  rig.key(Key::pad_one);
  expect_back({0, 0, 1});
  rig.click("Right");
  expect_back({1, 0, 0});
  rig.click("Top");
  expect_back({0, 1, 0});
  rig.click("Front");
  expect_back({0, 0, 1});
  EXPECT_LT(glm::distance(rig.camera().pivot(), pivot), 1e-12);
  EXPECT_TRUE(restarted());
}

// A view of a whole long object from one side has to contain all of it.
TEST_F(CameraPanelTest, FromASideTheWholeSceneIsFramedAsItWasBefore) {
  Viewpoint& viewpoint = rig.viewpoint();
  const auto distance = [&] { return viewpoint.camera().distance(); };
  viewpoint.choose_camera(-1);
  rig.frame();
  const double all = distance();
  rig.key(Key::pad_three);
  const double from_the_side = distance();
  EXPECT_LT(from_the_side, 0.9 * all) << "from the side the triangles are edge on";
  rig.key(Key::pad_one);
  EXPECT_GT(distance(), 1.1 * from_the_side);
  // A distance that the user changed stays.
  rig.wheel({200, 300}, 3.0f);
  const double near = distance();
  rig.key(Key::pad_three);
  EXPECT_NEAR(distance(), near, 1e-9 * near);
}

TEST_F(CameraPanelTest, TheLensIsChangedAndUndone) {
  const auto lens = [this] { return rig.camera().camera(); };
  const double fov = lens().fov_y_rad;
  rig.key(Key::pad_five);
  EXPECT_EQ(lens().type, Camera::Type::orthographic);
  EXPECT_TRUE(restarted());
  EXPECT_FALSE(rig.controls().contains("Field of view"));
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

// A section view: the plane moves with the camera until the whole scene is framed.
TEST_F(CameraPanelTest, PlanesOfTheFilesCameraCanBeSwitchedOff) {
  Viewpoint& viewpoint = rig.viewpoint();
  EXPECT_FALSE(rig.controls().contains("Clip at planes"));
  const auto near = [&] { return viewpoint.camera().camera().near_depth; };
  Camera camera = viewpoint.camera().camera();
  camera.near_depth = 1.5;
  viewpoint.take_over(camera, 0);
  EXPECT_TRUE(restarted());
  EXPECT_EQ(near(), 1.5);
  rig.click("Clip at planes");
  EXPECT_TRUE(restarted());
  EXPECT_EQ(near(), std::nullopt);
  EXPECT_FALSE(viewpoint.left_chosen()) << "it is still the file's camera";
  rig.click("Clip at planes");
  EXPECT_EQ(near(), 1.5);
  rig.key(Key::pad_three);
  EXPECT_EQ(near(), 1.5);
  rig.click("Frame all");
  EXPECT_EQ(near(), std::nullopt);
  rig.frame();
  EXPECT_FALSE(rig.controls().contains("Clip at planes"));
}

TEST_F(CameraPanelTest, ProjectionKeepsThePlanesPlaces) {
  Viewpoint& viewpoint = rig.viewpoint();
  Camera camera = viewpoint.camera().camera();
  camera.near_depth = 0.5 * viewpoint.camera().distance();
  viewpoint.take_over(camera, 0);
  const auto place = [&] {
    return viewpoint.camera().distance() - *viewpoint.camera().camera().near_depth;
  };
  const double before = place();
  const double distance = viewpoint.camera().distance();
  rig.key(Key::pad_five);
  EXPECT_GT(viewpoint.camera().distance(), 1.1 * distance);
  EXPECT_NEAR(place(), before, 1e-12);
}

TEST(CameraText, IsWhatCommandLineAndFilesRead) {
  Camera camera;
  camera.fov_y_rad = glm::radians(30.0);
  camera.world_from_camera[3] = glm::dvec4(1.0, 2.5, -3.0, 1.0);
  const glm::dvec3 origin(100.0, 0.0, 0.0);
  EXPECT_EQ(camera_options(camera, {1.0, 2.0, -8.0}, origin),
            "--look-at 101,2.5,-3,101,2,-8 --fov 30");
  const auto root = nlohmann::json::parse(camera_as_gltf(camera, origin));
  const auto& matrix = root.at("nodes").at(0).at("matrix");
  EXPECT_EQ(matrix.at(12), 101.0);
  EXPECT_EQ(matrix.at(13), 2.5);
  EXPECT_EQ(root.at("nodes").at(0).at("camera"), 0);
  EXPECT_NEAR(root.at("cameras").at(0).at("perspective").at("yfov").get<double>(), camera.fov_y_rad,
              1e-15);
  camera.type = Camera::Type::orthographic;
  EXPECT_EQ(camera_options(camera, {}, origin), "");
  EXPECT_EQ(nlohmann::json::parse(camera_as_gltf(camera, origin)).at("cameras").at(0).at("type"),
            "orthographic");
}

TEST_F(CameraPanelTest, IsCopied) {
  rig.click("Copy options");
  EXPECT_EQ(std::string(ImGui::GetClipboardText()).rfind("--look-at ", 0), 0u);
  rig.click("Copy as glTF");
  EXPECT_NE(std::string(ImGui::GetClipboardText()).find("yfov"), std::string::npos);
  EXPECT_FALSE(restarted());
}

}  // namespace
}  // namespace asos
