#include "renderer/lights/studio_lighting.h"

#include "renderer/lights/prepared_light.h"
#include "tests/support/tiny_world.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace asos::studio_rig_test {
namespace {

using std::numbers::pi;

Box box(glm::vec3 lo, glm::vec3 hi) {
  Box b;
  b.grow(lo);
  b.grow(hi);
  return b;
}

/// Radiance of a white diffuse surface in the light's strongest colour component.
double radiance(const Light& light, glm::dvec3 position, glm::dvec3 normal) {
  const glm::dvec3 all = unshadowed_irradiance(prepare_light(light), {position, normal, normal});
  return std::max({all.r, all.g, all.b}) / pi;
}

TEST(StudioLighting, HasAWarmKeyAndACoolFill) {
  const std::vector<Light> lights =
      studio_lighting(test::look_at({0, 0, 5}, {0, 0, 0}, 1.0), box(glm::vec3(-1), glm::vec3(1)));
  EXPECT_GT(lights[0].color.r, lights[0].color.b);
  EXPECT_LT(lights[1].color.r, lights[1].color.b);
}

TEST(StudioLighting, LightsTheMiddleAlikeAtEverySize) {
  for (const float size : {1e-3f, 1.0f, 1e4f}) {
    const glm::dvec3 middle(2.0 * size, -size, 0.5 * size);
    const Box bounds =
        box(glm::vec3(middle) - glm::vec3(size), glm::vec3(middle) + glm::vec3(size));
    const double radius = 0.5 * glm::length(glm::dvec3(bounds.hi) - glm::dvec3(bounds.lo));
    const Camera camera = test::look_at(middle + glm::dvec3(3, 2, 5) * double(size), middle, 0.7);
    const std::vector<Light> lights = studio_lighting(camera, bounds);
    ASSERT_EQ(lights.size(), 2u);
    const double expected[2] = {key_radiance, fill_radiance};
    for (std::size_t i = 0; i < 2; ++i) {
      const Light& light = lights[i];
      EXPECT_EQ(light.type, Light::Type::rectangle);
      EXPECT_TRUE(light.casts_shadows);
      EXPECT_FALSE(light.two_sided);
      const glm::dvec3 to_light = glm::normalize(light.position - middle);
      EXPECT_NEAR(glm::distance(light.direction, -to_light), 0.0, 1e-5);
      const double distance = glm::distance(light.position, middle);
      EXPECT_NEAR(2.0 * glm::length(light.half_u), 0.4 * distance, 1e-4 * distance);
      EXPECT_NEAR(2.0 * glm::length(light.half_v), 0.4 * distance, 1e-4 * distance);
      EXPECT_NEAR(radiance(light, middle + 0.5 * radius * to_light, to_light), expected[i], 1e-4);
      const double nearest = radiance(light, middle + radius * to_light, to_light);
      const double farthest = radiance(light, middle - radius * to_light, to_light);
      EXPECT_LT(nearest, 1.1 * expected[i]);
      EXPECT_GT(farthest, 0.7 * expected[i]);
    }
    // The key light comes from the upper left, the fill light from the right, both from the front.
    const glm::dmat4& m = camera.world_from_camera;
    const glm::dvec3 key = lights[0].position - middle;
    const glm::dvec3 fill = lights[1].position - middle;
    EXPECT_LT(glm::dot(key, glm::dvec3(m[0])), 0.0);
    EXPECT_GT(key.y, 0.5 * glm::length(key));
    EXPECT_GT(glm::dot(fill, glm::dvec3(m[0])), 0.0);
    EXPECT_GT(fill.y, 0.0);
    EXPECT_GT(glm::dot(key, glm::dvec3(m[2])), 0.0);
    EXPECT_GT(glm::dot(fill, glm::dvec3(m[2])), 0.0);
  }
}

TEST(StudioLighting, TurnsWithTheCameraButNotWithItsPitch) {
  const Box bounds = box(glm::vec3(-1), glm::vec3(1));
  const std::vector<Light> level =
      studio_lighting(test::look_at({0, 0, 5}, {0, 0, 0}, 1.0), bounds);
  const std::vector<Light> pitched =
      studio_lighting(test::look_at({0, 4, 3}, {0, 0, 0}, 1.0), bounds);
  const std::vector<Light> turned =
      studio_lighting(test::look_at({5, 0, 0}, {0, 0, 0}, 1.0), bounds);
  for (std::size_t i = 0; i < 2; ++i) {
    const glm::dvec3 p = level[i].position;
    EXPECT_NEAR(glm::distance(pitched[i].position, p), 0.0, 1e-9);
    EXPECT_NEAR(glm::distance(turned[i].position, {p.z, p.y, -p.x}), 0.0, 1e-9);
  }
}

TEST(StudioLighting, AnyCameraAndBoundsGiveFiniteLightsFromAbove) {
  Camera down;
  down.world_from_camera = glm::dmat4(glm::dvec4(1, 0, 0, 0), glm::dvec4(0, 0, -1, 0),
                                      glm::dvec4(0, 1, 0, 0), glm::dvec4(0, 9, 0, 1));
  for (const Camera& camera : {Camera{}, down}) {
    for (const Box& bounds : {Box{}, box({1, 2, 3}, {1, 2, 3}), box({0, 0, 0}, {1, 0, 0})}) {
      for (const Light& light : studio_lighting(camera, bounds)) {
        EXPECT_NEAR(glm::length(light.direction), 1.0, 1e-12);
        EXPECT_LT(light.direction.y, 0.0);
        EXPECT_GT(light.intensity, 0.0f);
        EXPECT_TRUE(std::isfinite(light.intensity));
      }
    }
  }
}

/// The inside of a box, whose walls may be single-sided.
struct Room {
  glm::dvec3 lo, hi;

  /// Distance to the walls from inside, or to the nearest wall from outside.
  [[nodiscard]] double operator()(glm::dvec3 from, glm::dvec3 direction) const {
    double enter = 0.0;
    double leave = std::numeric_limits<double>::infinity();
    for (int k = 0; k < 3; ++k) {
      if (direction[k] == 0.0) {
        if (from[k] < lo[k] || from[k] > hi[k]) return std::numeric_limits<double>::infinity();
        continue;
      }
      const double a = (lo[k] - from[k]) / direction[k];
      const double b = (hi[k] - from[k]) / direction[k];
      enter = std::max(enter, std::min(a, b));
      leave = std::min(leave, std::max(a, b));
    }
    if (enter > leave) return std::numeric_limits<double>::infinity();
    return enter > 0.0 ? enter : leave;
  }

  [[nodiscard]] std::vector<SeenPoint> seen_from(const Camera& camera) const {
    std::vector<SeenPoint> seen;
    const glm::dmat4& m = camera.world_from_camera;
    const glm::dvec3 eye(m[3]);
    for (int y = -8; y <= 8; ++y) {
      for (int x = -8; x <= 8; ++x) {
        const glm::dvec3 d = glm::normalize(glm::dvec3(m * glm::dvec4(0.08 * x, 0.06 * y, -1, 0)));
        double t = (*this)(eye, d);
        if (!std::isfinite(t)) continue;
        // From outside, the view goes through the near wall.
        if (!holds(eye)) t += (*this)(eye + (t + 1e-9) * d, d);
        const glm::dvec3 p = eye + t * d;
        glm::dvec3 normal(0.0);
        for (int k = 0; k < 3; ++k) {
          if (std::abs(p[k] - lo[k]) < 1e-6) normal = glm::dvec3(k == 0, k == 1, k == 2);
          if (std::abs(p[k] - hi[k]) < 1e-6) normal = -glm::dvec3(k == 0, k == 1, k == 2);
        }
        seen.push_back({eye, p, normal});
      }
    }
    return seen;
  }
  [[nodiscard]] bool holds(glm::dvec3 p) const {
    return glm::all(glm::greaterThan(p, lo)) && glm::all(glm::lessThan(p, hi));
  }
};

TEST(InteriorLighting, StaysInsideTheRoomAndReachesWhatIsSeen) {
  for (const double scale : {0.01, 1.0, 1000.0}) {
    const Room room{scale * glm::dvec3(-3, 0, -2), scale * glm::dvec3(3, 2.5, 4)};
    const Box bounds = box(glm::vec3(room.lo), glm::vec3(room.hi));
    for (const glm::dvec3 target :
         {glm::dvec3(0, 1, -2), glm::dvec3(-3, 0.5, 0), glm::dvec3(2, 0, 3.8)}) {
      const Camera camera = test::look_at(scale * glm::dvec3(1, 1.6, 3.5), scale * target, 1.0);
      const std::vector<SeenPoint> seen = room.seen_from(camera);
      const std::vector<Light> studio = studio_lighting(camera, bounds);
      EXPECT_EQ(reached_share(studio, seen, room), 0.0);
      const std::vector<Light> lights = interior_lighting(camera, bounds, seen, room);
      ASSERT_EQ(lights.size(), 2u);
      EXPECT_GT(reached_share({lights.data(), 1}, seen, room), 0.5);
      EXPECT_GT(reached_share({lights.data() + 1, 1}, seen, room), 0.5);
      for (const Light& light : lights) {
        EXPECT_TRUE(light.casts_shadows);
        for (const double u : {-1.0, 1.0}) {
          for (const double v : {-1.0, 1.0})
            EXPECT_TRUE(room.holds(light.position + u * light.half_u + v * light.half_v));
        }
      }
      EXPECT_LT(lights[0].direction.y, -0.99);
      std::vector<double> bright;
      for (const SeenPoint& p : seen) {
        bright.push_back(radiance(lights[0], p.position, p.normal) +
                         radiance(lights[1], p.position, p.normal));
      }
      std::sort(bright.begin(), bright.end());
      EXPECT_GT(bright[bright.size() / 2], 0.05);
      EXPECT_LT(bright[bright.size() * 8 / 10], key_radiance + fill_radiance);
    }
  }
}

TEST(InteriorLighting, AViewThroughUnseenWallsKeepsTheKeyInside) {
  const Room room{{-3, 0, -2}, {3, 2.5, 4}};
  const Box bounds = box(glm::vec3(room.lo), glm::vec3(room.hi));
  const Camera camera = test::look_at({4, 8, 14}, {0, 1, 1}, 1.0);
  const std::vector<SeenPoint> seen = room.seen_from(camera);
  ASSERT_FALSE(seen.empty());
  const std::vector<Light> lights = interior_lighting(camera, bounds, seen, room);
  ASSERT_EQ(lights.size(), 2u);
  EXPECT_TRUE(room.holds(lights[0].position));
  EXPECT_GT(reached_share({lights.data(), 1}, seen, room), 0.5);
  // The fill light reaches every room that the eye sees into.
  EXPECT_FALSE(lights[1].casts_shadows);
  EXPECT_EQ(lights[1].intensity, studio_lighting(camera, bounds)[1].intensity);
}

}  // namespace
}  // namespace asos::studio_rig_test
