#include "tests/ui/test_scenes.h"
#include "ui/previewer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <numbers>
#include <thread>

// With a fast camera the picture never mixes two poses.

namespace asos {
using namespace ui;
namespace {

/// A camera between a red wall and a green one.
Result<Scene> two_walls(const std::string& source) {
  Scene scene{.source = source};
  constexpr float far = 300.0f;
  for (const float z : {-5.0f, 5.0f})
    test::add_triangle(scene, {-far, -far, z}, {far, -far, z}, {0, far, z},
                       z < 0.0f ? glm::vec3(1, 0, 0) : glm::vec3(0, 1, 0));
  Camera camera{.fov_y_rad = 0.7};
  scene.cameras = {camera};
  return scene;
}

bool red(glm::vec3 colour) {
  return colour.x > colour.y;
}

TEST(WholePicture, IsOfOnePoseWhileTheCameraTurns) {
  RenderSettings settings{.threads = 1};
  Previewer previewer{{two_walls, {}}, settings};
  double now = 0.0;
  previewer.viewpoint().set_picture_size(480, 300, now);
  previewer.scene().open("walls");
  const auto update = [&] {
    previewer.update(now += 0.001);
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  };
  const PreviewRender& render = previewer.render();
  for (int i = 0; i < 20000 && (render.restarts() == 0 || render.first_picture_pending()); ++i)
    update();
  int torn = 0, turns = 0;
  bool was_red = red(previewer.render().film().radiance.front());
  for (int turn = 0; turn < 20; ++turn) {
    previewer.viewpoint().camera().look_around(std::numbers::pi, 0.0);
    for (int i = 0; i < 60; ++i) {
      update();
      const Film& film = previewer.render().film();
      const bool first = red(film.radiance.front());
      bool same = true;
      for (const glm::vec3& pixel : film.radiance) same &= red(pixel) == first;
      torn += !same;
      turns += first != was_red;
      was_red = first;
    }
  }
  EXPECT_EQ(torn, 0);
  EXPECT_GT(turns, 5) << "otherwise nothing was displayed";
}

// The first pass may take longer than a frame of the clock: its tiles wait for each other.
TEST(WholePicture, IsHeldWhileTheFirstPassRuns) {
  RenderSettings settings{.threads = 1};
  Previewer previewer{{two_walls, {}}, settings};
  double now = 0.0;
  previewer.viewpoint().set_picture_size(1600, 1000, now);
  previewer.scene().open("walls");
  const PreviewRender& render = previewer.render();
  for (int i = 0; i < 20000 && (render.restarts() == 0 || render.first_picture_pending()); ++i) {
    previewer.update(now);
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  ASSERT_FALSE(render.first_picture_pending());
  int torn = 0;
  for (int turn = 0; turn < 10; ++turn) {
    previewer.viewpoint().camera().look_around(std::numbers::pi, 0.0);
    previewer.update(now += 10.0);
    now += 0.5;
    while (render.first_picture_pending()) {
      previewer.update(now);
      const auto& pixels = render.film().radiance;
      const bool first = red(pixels.front());
      torn += std::any_of(pixels.begin(), pixels.end(),
                          [&](glm::vec3 pixel) { return red(pixel) != first; });
    }
  }
  EXPECT_EQ(torn, 0);
}

}  // namespace
}  // namespace asos
