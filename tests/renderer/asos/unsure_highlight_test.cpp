#include "tests/support/render_picture.h"
#include "tests/support/tiny_scene.h"

#include <gtest/gtest.h>

// A highlight of a light that is seen in part is sampled: all that the leaf shows, and once.

namespace asos::test::unsure_highlight_test {
namespace {

double mean_of(const Film& film) {
  double sum = 0.0;
  for (const glm::vec3& pixel : film.radiance) sum += static_cast<double>(pixel.y);
  return sum / static_cast<double>(film.radiance.size());
}

TEST(UnsureHighlight, HasTheSkysLightOnce) {
  // A shining floor under a panel, half of which a board hides.
  World world;
  Material floor = matte(glm::vec3(0.4f));
  floor.roughness = 0.3f;
  floor.specular = 1.0f;
  add_quad(world, {-4, 0, 4}, {8, 0, 0}, {0, 0, -8}, floor);
  add_quad(world, {-0.2f, 1.0f, -2.5f}, {3, 0, 0}, {0, 0, 2.0f}, matte(glm::vec3(0.1f)));
  Light panel;
  panel.type = Light::Type::rectangle;
  panel.position = {0, 2.5, -2.5};
  panel.direction = glm::normalize(glm::dvec3(0, -1, 0.6));
  panel.half_u = {0.8, 0, 0};
  panel.half_v = 0.4 * glm::normalize(glm::cross(panel.direction, panel.half_u));
  panel.intensity = 6.0f;
  const auto scene = make_render_scene(std::move(world), {panel});
  RenderSettings settings;
  settings.width = settings.height = 32;
  settings.shadow.sky = true;
  const Camera camera = look_at({0, 1.2, 2.5}, {0, 0, -0.6}, 0.7);
  const Picture asos = render_picture(*scene, camera, settings);
  settings.method = Method::sobol;
  settings.sampling.spp = 256;
  const Picture truth = render_picture(*scene, camera, settings);
  ASSERT_GT(asos.statistics.sky_rays, 0u);
  EXPECT_NEAR(mean_of(asos.film), mean_of(truth.film), 5e-4);
}

}  // namespace
}  // namespace asos::test::unsure_highlight_test
