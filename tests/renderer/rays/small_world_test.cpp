#include "renderer/rays/ray_scene.h"
#include "tests/support/tiny_world.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace asos::small_world_test {
namespace {

// A power of two preserves the digits of floats: hits in a tiny world are the same as at scale 1,
// bit by bit.

struct Answers {
  std::vector<Hit> hits;
  std::vector<Blocker> blockers;
};

float half_opaque(const World&, std::uint32_t, float, float) {
  return 0.5f;
}

Answers ask(float scale) {
  World world = test::still_life().world;
  Material glass = test::unlit({0.5f, 0.5f, 0.5f}, 0.5f);
  test::add_quad(world, {-1, 0, 1.5f}, {2, 0, 0}, {0, 1, 0}, glass);
  for (glm::vec3& p : world.positions) p *= scale;
  world.bounds.lo *= scale;
  world.bounds.hi *= scale;
  const RayScene rays = RayScene::build(world, half_opaque).value();
  std::vector<Ray> sent;
  for (int i = 0; i < 64; ++i) {
    const Ray ray{
        .origin = scale * glm::vec3(0.0f, 1.0f, 6.0f),
        .t_near = 0.5f * scale,
        .direction = glm::normalize(glm::vec3(0.05f * static_cast<float>(i % 8) - 0.2f,
                                              0.05f * static_cast<float>(i / 8) - 0.3f, -1)),
        .t_far = i % 3 ? 40.0f * scale : 5.0f * scale};
    sent.push_back(ray);
  }
  Answers answers{std::vector<Hit>(sent.size()), std::vector<Blocker>(sent.size())};
  rays.closest(sent, answers.hits);
  rays.blockers(sent, answers.blockers);
  return answers;
}

void expect_scaled(const Hit& hit, const Hit& unit, float scale) {
  EXPECT_EQ(hit.triangle, unit.triangle);
  EXPECT_EQ(hit.b1, unit.b1);
  EXPECT_EQ(hit.b2, unit.b2);
  EXPECT_EQ(hit.t, unit.t * scale);
}

TEST(SmallWorld, HitsAreThoseOfScaleOne) {
  const Answers unit = ask(1.0f);
  int met = 0;
  int through = 0;
  for (const int power : {-12, -30, -40}) {
    const float scale = std::ldexp(1.0f, power);
    const Answers small = ask(scale);
    for (std::size_t i = 0; i < unit.hits.size(); ++i) {
      SCOPED_TRACE(testing::Message() << "2^" << power << ", ray " << i);
      expect_scaled(small.hits[i], unit.hits[i], scale);
      expect_scaled(small.blockers[i].hit, unit.blockers[i].hit, scale);
      EXPECT_EQ(small.blockers[i].transmittance, unit.blockers[i].transmittance);
      EXPECT_EQ(small.blockers[i].see_through, unit.blockers[i].see_through);
      met += unit.hits[i].valid();
      through += unit.blockers[i].see_through;
    }
  }
  EXPECT_GT(met, 30);
  EXPECT_GT(through, 10);
}

}  // namespace
}  // namespace asos::small_world_test
