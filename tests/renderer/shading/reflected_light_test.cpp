#include "renderer/shading/reflected_light.h"

#include "renderer/shading/light_transport.h"
#include "renderer/shading/patch_lobe.h"
#include "tests/support/make_light.h"
#include "tests/support/white_lobe.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

// Highlights in closed form.

namespace asos::reflected_light_test {
namespace {

PreparedLight rectangle(glm::vec3 color) {
  Light light =
      test::make_panel({1.0, 0.0, 1.0}, {-1.0, 0.0, -1.0}, {0.0, 0.2, 0.0}, {0.1, 0.0, -0.1}, 3.0f);
  light.color = color;
  return prepare_light(light);
}

/// A point seen at 45 degrees, whose mirrored view direction hits the light's centre.
struct Seen {
  Seen() {
    point.geometric_normal = point.shading_normal = {0, 0, 1};
    material.diffuse = glm::vec3(0.2f, 0.1f, 0.0f);
    material.lobe.f0 = glm::vec3(0.9f, 0.5f, 0.04f);
    material.lobe.roughness = 0.3f;
  }
  [[nodiscard]] glm::vec3 radiance(const PreparedLight& light) const {
    const ViewedPoint view{point, glm::normalize(glm::vec3(-1, 0, 1)), std::sqrt(0.5f)};
    const LightingQuery lit{{}, view, material};
    const glm::vec3 irradiance = unshadowed_irradiance(light, receiver_at(point));
    return ReflectedLights(lit).of(light, irradiance).reflected * irradiance;
  }

  SurfacePoint point;
  ViewedMaterial material{};
};

TEST(MirroredLights, AreThoseThatHaveASurface) {
  Light line{.type = Light::Type::linear, .half_u = {1.0, 0.0, 0.0}};
  PreparedLight tube = prepare_light(line);
  EXPECT_FALSE(shows(MirroredLights::all, tube)) << "a line has no surface to reflect";
  tube.own_part = 0;
  EXPECT_TRUE(shows(MirroredLights::all, tube)) << "the tube that the line replaces is reflected";
  EXPECT_FALSE(shows(MirroredLights::patterned, tube))
      << "the lobe shows the light, the mirror does not";
  tube.patterned = true;
  EXPECT_TRUE(shows(MirroredLights::patterned, tube)) << "the lobe would not show its texture";
  EXPECT_FALSE(shows(MirroredLights::none, tube));
  EXPECT_TRUE(shows(MirroredLights::all, rectangle(glm::vec3(1.0f))));
}

TEST(ReflectedLights, SendOnDiffuseLightAndTheSpecularIntegral) {
  Seen seen;
  seen.material.lobe.f90 = glm::vec3(0.7f);
  seen.material.falloff = 0.6f;
  // The light lacks one of the colours.
  const PreparedLight light = rectangle({1.0f, 0.25f, 0.0f});
  const Receiver receiver = receiver_at(seen.point);
  const ReflectedIntegral all =
      LightQuadrature(receiver, glm::normalize(glm::dvec3(-1, 0, 1)), test::white_lobe(0.3))(light);
  const glm::vec3 radiance = seen.radiance(light);
  const glm::vec3 irradiance = unshadowed_irradiance(light, receiver);
  for (int i = 0; i < 3; ++i) {
    const double f0 = seen.material.lobe.f0[i];
    const double diffuse = seen.material.diffuse[i] * std::numbers::inv_pi *
                           (irradiance[i] - 0.6 * light.power[i] * all.scattered);
    const double expected = diffuse + light.power[i] * (f0 * all.lobe + (0.7 - f0) * all.fresnel);
    EXPECT_NEAR(radiance[i], expected, 1e-5 * expected) << i;
  }
  EXPECT_GT(radiance.x, 0.1f * light.power.x) << "the light is mirrored";
}

TEST(ReflectedLights, AreFainterWhereNormalsTurn) {
  Seen seen;
  const PreparedLight light = rectangle(glm::vec3(1.0f));
  const glm::vec3 flat = seen.radiance(light);
  seen.point.spread = {{0.5f, 0.0f, 0.0f}, {0.0f, 0.5f, 0.0f}, 0.0f};
  const glm::vec3 turned = seen.radiance(light);
  EXPECT_LT(turned.x, 0.9f * flat.x);
  EXPECT_GT(turned.x, 0.2f * flat.x);
  // The same as from a rougher flat surface.
  const PatchLobe lobe(seen.point.spread, test::white_lobe(0.3), seen.point.shading_normal);
  ASSERT_TRUE(lobe.wider());
  seen.point.spread = {};
  seen.material.lobe.roughness = lobe.round_roughness();
  EXPECT_NEAR(seen.radiance(light).x, turned.x, 1e-4f * turned.x);
}

}  // namespace
}  // namespace asos::reflected_light_test
