#include "renderer/shading/reflected_light.h"

#include "renderer/shading/light_transport.h"
#include "renderer/shading/lobe.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

// What shading makes of a highlight in closed form.

namespace asos::reflected_light_test {
namespace {

PreparedLight rectangle(glm::vec3 color) {
  Light light;
  light.type = Light::Type::rectangle;
  light.position = {1.0, 0.0, 1.0};
  light.direction = {-1.0, 0.0, -1.0};
  light.half_u = {0.0, 0.2, 0.0};
  light.half_v = {0.1, 0.0, -0.1};
  light.color = color;
  light.intensity = 3.0f;
  return prepare_light(light);
}

/// A point that is seen at 45 degrees, whose mirrored view meets the middle of the light.
struct Seen {
  Seen() {
    point.geometric_normal = point.shading_normal = {0, 0, 1};
    material.diffuse = glm::vec3(0.2f, 0.1f, 0.0f);
    material.f0 = glm::vec3(0.9f, 0.5f, 0.04f);
    material.roughness = 0.3f;
  }
  [[nodiscard]] glm::vec3 radiance(const PreparedLight& light) const {
    const ViewedPoint view{point, glm::normalize(glm::vec3(-1, 0, 1)), std::sqrt(0.5f)};
    const Receiver receiver = receiver_at(point);
    const SpecularView own(receiver, glm::dvec3(view.to_viewer), material.roughness);
    const glm::vec3 irradiance = unshadowed_irradiance(light, receiver);
    const Highlight highlight = highlight_of(
        light, receiver.position, glm::reflect(glm::dvec3(-view.to_viewer), receiver.normal));
    return mirrored_share(light, material, view, own, highlight, irradiance) * irradiance;
  }

  SurfacePoint point;
  ViewedMaterial material{};
};

TEST(MirroredShare, IsDiffuseLightAndTheSpecularIntegral) {
  Seen seen;
  seen.material.f90 = 0.7f;
  // Also of a light that lacks a colour.
  const PreparedLight light = rectangle({1.0f, 0.25f, 0.0f});
  const Receiver receiver = receiver_at(seen.point);
  const SpecularIntegral all =
      specular_of(light, SpecularView(receiver, glm::normalize(glm::dvec3(-1, 0, 1)), 0.3));
  const glm::vec3 radiance = seen.radiance(light);
  const glm::vec3 irradiance = unshadowed_irradiance(light, receiver);
  for (int i = 0; i < 3; ++i) {
    const double f0 = seen.material.f0[i];
    const double expected = seen.material.diffuse[i] * std::numbers::inv_pi * irradiance[i] +
                            light.power[i] * (f0 * all.lobe + (0.7 - f0) * all.fresnel);
    EXPECT_NEAR(radiance[i], expected, 1e-5 * expected) << i;
  }
  EXPECT_GT(radiance.x, 0.1f * light.power.x) << "the light is mirrored";
}

TEST(MirroredShare, IsFainterWhereNormalsTurn) {
  Seen seen;
  const PreparedLight light = rectangle(glm::vec3(1.0f));
  const glm::vec3 flat = seen.radiance(light);
  seen.point.spread = {{0.5f, 0.0f, 0.0f}, {0.0f, 0.5f, 0.0f}, 0.0f};
  const glm::vec3 turned = seen.radiance(light);
  EXPECT_LT(turned.x, 0.9f * flat.x);
  EXPECT_GT(turned.x, 0.2f * flat.x);
  // As a rougher surface that is flat.
  const PatchLobe lobe(seen.point.spread, 0.3f, seen.point.shading_normal);
  ASSERT_TRUE(lobe.wider());
  seen.point.spread = {};
  seen.material.roughness = lobe.round_roughness();
  EXPECT_NEAR(seen.radiance(light).x, turned.x, 1e-4f * turned.x);
}

}  // namespace
}  // namespace asos::reflected_light_test
