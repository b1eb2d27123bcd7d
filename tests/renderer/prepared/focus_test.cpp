#include "renderer/prepared/focus.h"

#include "tests/support/make_settings.h"
#include "tests/support/tiny_scene.h"

#include <gtest/gtest.h>

#include <utility>

namespace asos::test::focus_test {
namespace {

// The lens focuses on the visible surface, not on a card of opacity 0 before it.
TEST(Focus, PassesSurfacesOfOpacityZero) {
  World world;
  Material card = unlit(glm::vec3(0.5f), 0.0f);
  add_quad(world, {-1, -1, -1}, {2, 0, 0}, {0, 2, 0}, card);
  add_quad(world, {-9, -9, -5}, {18, 0, 0}, {0, 18, 0}, matte(glm::vec3(0.5f)));
  const auto scene = make_render_scene(std::move(world));
  Camera camera = look_at({0, 0, 0}, {0, 0, -1}, 0.8);
  camera.lens.radius = 0.1;
  EXPECT_NEAR(focused(*scene, camera, make_settings(8, 8)).lens.focus.value(), 5.0, 1e-5);
}

}  // namespace
}  // namespace asos::test::focus_test
