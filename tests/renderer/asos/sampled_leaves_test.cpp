#include "tests/support/render_picture.h"
#include "tests/support/tiny_scene.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>

// What is shaded unevenly is sampled where that costs less than splitting it.

namespace asos::test::sampled_leaves_test {
namespace {

constexpr int side = 24;

/// The penumbra of a post's edge under a ball, on a plane, seen from above.
auto penumbra() {
  World world;
  add_quad(world, {-2, -2, 0}, {4, 0, 0}, {0, 4, 0}, matte(glm::vec3(0.6f)));
  add_quad(world, {-4.3f, -3, 0.6f}, {4.0f, 0.1f, 0}, {0, 6, 0}, matte(glm::vec3(0.3f)));
  Light ball;
  ball.type = Light::Type::point;
  ball.position = {-2.0, 0.4, 3.0};
  ball.radius = 0.4;
  ball.intensity = 12.0f;
  return make_render_scene(std::move(world), {ball});
}

Picture picture_of(const RenderScene& scene, int max_level, double eps) {
  RenderSettings settings;
  settings.width = settings.height = side;
  settings.asos.max_level = max_level;
  settings.asos.eps = eps;
  return render_picture(scene, orthographic(4.0), settings);
}

TEST(SampledLeaves, OfAPenumbraAreAsExactAsEpsAsks) {
  const auto scene = penumbra();
  const Picture sampled = picture_of(*scene, 3, 1.0 / 256.0);
  const Picture exact = picture_of(*scene, 6, 0.0);
  EXPECT_EQ(sampled.statistics.pyrays_by_level[1], 0u) << "none is split for its shadow";
  EXPECT_GT(exact.statistics.pyrays_by_level[1], 0u) << "to be more exact they are split";
  double squares = 0.0, off = 0.0;
  std::size_t uneven = 0;
  for (std::size_t i = 0; i < sampled.film.radiance.size(); ++i) {
    if (sampled.film.cause[i] != SplitCause::shadow) continue;
    ++uneven;
    EXPECT_GE(sampled.film.split_level[i], 2) << "by the number of its samples";
    const auto d = static_cast<double>(sampled.film.radiance[i].x - exact.film.radiance[i].x);
    squares += d * d;
    off += d;
  }
  ASSERT_GT(uneven, 20u);
  EXPECT_EQ(uneven, sampled.statistics.uneven_pixels);
  const auto count = static_cast<double>(uneven);
  EXPECT_LT(std::sqrt(squares / count), 0.5 / 256.0) << "half of the tolerance";
  EXPECT_LT(std::abs(off / count), 0.5 / 256.0 / std::sqrt(count) * 3.0) << "and in no direction";
}

}  // namespace
}  // namespace asos::test::sampled_leaves_test
