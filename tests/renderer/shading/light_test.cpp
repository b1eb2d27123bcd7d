#include "renderer/shading/light.h"

#include "renderer/shading/brdf.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace asos {
namespace {

Light point_light(float intensity) {
  Light light;
  light.intensity = intensity;
  light.position = {0, 2, 0};
  return light;
}

TEST(Light, PointFallsWithTheSquareOfTheDistance) {
  const PreparedLight light = prepare_light(point_light(12.0f));
  for (const float y : {1.0f, 0.0f, -4.0f}) {
    const Incident incident = incident_light(light, {0, y, 0});
    EXPECT_FLOAT_EQ(incident.irradiance.g, 12.0f / ((2.0f - y) * (2.0f - y)));
    EXPECT_FLOAT_EQ(incident.direction.y, 1.0f);
  }
}

TEST(Light, RangeEndsInAWindow) {
  Light light = point_light(1.0f);
  light.range = 4.0;
  const PreparedLight prepared = prepare_light(light);
  EXPECT_FLOAT_EQ(incident_light(prepared, {0, 0, 0}).irradiance.r, 0.25f * (1.0f - 1.0f / 16.0f));
  EXPECT_EQ(incident_light(prepared, {0, -2, 0}).irradiance.r, 0.0f);
  EXPECT_EQ(incident_light(prepared, {0, -9, 0}).irradiance.r, 0.0f);
}

TEST(Light, SpotFallsFromInnerToOuterCone) {
  Light light = point_light(1.0f);
  light.type = Light::Type::spot;
  light.direction = {0, -1, 0};
  light.inner_cone_rad = 0.2;
  light.outer_cone_rad = 0.6;
  const PreparedLight prepared = prepare_light(light);
  const auto at_angle = [&](double angle) {
    const glm::vec3 p(2.0 * std::sin(angle), 2.0 - 2.0 * std::cos(angle), 0.0);
    return incident_light(prepared, p).irradiance.r * 4.0f;
  };
  EXPECT_NEAR(at_angle(0.0), 1.0, 1e-6);
  EXPECT_NEAR(at_angle(0.19), 1.0, 1e-5);
  const double share = (std::cos(0.4) - std::cos(0.6)) / (std::cos(0.2) - std::cos(0.6));
  EXPECT_NEAR(at_angle(0.4), share * share, 1e-5);
  EXPECT_EQ(at_angle(0.61), 0.0);
}

TEST(Light, DirectionalDoesNotFall) {
  Light light;
  light.type = Light::Type::directional;
  light.direction = {0, -2, 0};
  light.intensity = 3.0f;
  const PreparedLight prepared = prepare_light(light);
  for (const float y : {0.0f, 1000.0f}) {
    const Incident incident = incident_light(prepared, {5, y, 5});
    EXPECT_EQ(incident.irradiance.b, 3.0f);
    EXPECT_EQ(incident.direction, glm::vec3(0, 1, 0));
  }
}

// The share of light from `n_dot_v` that the surface sends back in all: the white furnace, by the
// midpoint rule over the half vectors' hemisphere, where the lobe is smooth. dl = 4 (v.h) dh.
double furnace(const SurfaceMaterial& material, float n_dot_v, bool diffuse_too) {
  const glm::vec3 v(std::sqrt(1.0f - n_dot_v * n_dot_v), 0.0f, n_dot_v);
  const ViewedMaterial seen = viewed(material, n_dot_v);
  constexpr int steps = 600;
  double sum = 0.0;
  for (int i = 0; i < steps; ++i) {
    // Squared spacing packs the samples towards the normal, where narrow lobes are.
    const double s = (i + 0.5) / steps;
    const double theta = s * s * 0.5 * std::numbers::pi;
    const double d_theta = 2.0 * s * 0.5 * std::numbers::pi / steps;
    for (int j = 0; j < steps; ++j) {
      const double phi = (j + 0.5) * 2.0 * std::numbers::pi / steps;
      const glm::vec3 h(std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi),
                        std::cos(theta));
      const float vh = glm::dot(v, h);
      if (vh <= 0.0f) continue;
      const glm::vec3 l = 2.0f * vh * h - v;
      if (l.z <= 0.0f) continue;
      const BrdfAngles angles{l.z, n_dot_v, h.z, vh};
      const double f = diffuse_too ? static_cast<double>(brdf(seen, angles).r)
                                   : static_cast<double>(ggx_lobe(material.roughness, angles));
      sum += f * l.z * 4.0 * vh * std::sin(theta) * d_theta * 2.0 * std::numbers::pi / steps;
    }
  }
  return sum;
}

glm::vec3 whole(const SurfaceMaterial& material, float n_dot_v) {
  const ViewedMaterial seen = viewed(material, n_dot_v);
  return seen.diffuse + seen.specular;
}

TEST(Brdf, WhiteFurnaceNeverGainsEnergy) {
  // The quadrature errs by less than a thousandth.
  for (const float roughness : {0.0f, 0.1f, 0.3f, 0.6f, 1.0f}) {
    for (const float n_dot_v : {0.1f, 0.5f, 0.95f}) {
      // A lobe without Fresnel returns 1 less what single scattering loses: nearly nothing when
      // smooth, and at normal incidence and roughness 1 all but 1 - ln 2 = 0.307.
      SurfaceMaterial white;
      white.roughness = roughness;
      const double lobe = furnace(white, n_dot_v, false);
      EXPECT_LE(lobe, 1.001) << roughness << " " << n_dot_v;
      EXPECT_GE(lobe, roughness <= 0.1f ? 0.98 : 0.3) << roughness << " " << n_dot_v;
      SurfaceMaterial metal = white;
      metal.metallic = 1.0f;
      metal.f0 = glm::vec3(1.0f);
      EXPECT_NEAR(furnace(metal, n_dot_v, true), lobe, 1e-5) << roughness << " " << n_dot_v;

      // A white dielectric gains no more than the analytic fit of its lobe, which decides what is
      // left for the diffuse part, errs by: below a hundredth but at grazing angles.
      const double gain = furnace(white, n_dot_v, true) - 1.0;
      EXPECT_LE(gain, n_dot_v < 0.3f ? 0.09 : 0.01) << roughness << " " << n_dot_v;
    }
  }
}

TEST(Brdf, NormalIncidenceOnTheRoughestLobeHasAClosedForm) {
  // alpha = 1: D is constant, and the lobe's integral is 1 - ln 2.
  SurfaceMaterial rough;
  rough.roughness = 1.0f;
  EXPECT_NEAR(furnace(rough, 1.0f, false), 1.0 - std::numbers::ln2, 1e-3);
}

TEST(Brdf, IsReciprocalInItsSpecularPart) {
  BrdfAngles there{0.3f, 0.8f, 0.7f, 0.6f};
  BrdfAngles back{0.8f, 0.3f, 0.7f, 0.6f};
  EXPECT_FLOAT_EQ(ggx_lobe(0.5f, there), ggx_lobe(0.5f, back));
}

TEST(Brdf, EnvironmentReflectanceStaysWithinOneAndMetalsAreNotBlack) {
  for (const float roughness : {0.0f, 0.25f, 0.5f, 1.0f}) {
    for (const float n_dot_v : {0.01f, 0.3f, 1.0f}) {
      SurfaceMaterial m;
      m.roughness = roughness;
      const float dielectric = whole(m, n_dot_v).r;
      EXPECT_LE(dielectric, 1.0f);
      EXPECT_GT(dielectric, 0.9f);
      m.metallic = 1.0f;
      m.f0 = glm::vec3(1.0f, 0.5f, 0.5f);
      const glm::vec3 metal = whole(m, n_dot_v);
      EXPECT_LE(metal.r, 1.0f);
      EXPECT_GT(metal.g, 0.4f * m.f0.g);
    }
  }
}

TEST(Brdf, SplitSumAgreesWithTheIntegral) {
  // The fit was made for a masking term (Schlick's) that loses a little more light than ours: it is
  // darker by an eighth at most, and never far brighter.
  for (const float roughness : {0.3f, 0.6f, 1.0f}) {
    for (const float n_dot_v : {0.3f, 0.9f}) {
      SurfaceMaterial metal;
      metal.roughness = roughness;
      metal.metallic = 1.0f;
      metal.f0 = glm::vec3(0.8f);
      EXPECT_NEAR(whole(metal, n_dot_v).r, furnace(metal, n_dot_v, true), 0.125)
          << roughness << " " << n_dot_v;
    }
  }
}

}  // namespace
}  // namespace asos
