#include "renderer/shading/sky_light.h"

#include "renderer/sampling/sobol_points.h"
#include "renderer/shading/environment.h"
#include "renderer/shading/sky.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <numbers>
#include <vector>

namespace asos::test::sky_light_test {
namespace {

/// A surface that faces up, seen at an angle to its normal.
struct Seen {
  explicit Seen(const SurfaceMaterial& material, double angle) {
    point.shading_normal = point.geometric_normal = {0, 1, 0};
    view = std::make_unique<ViewedPoint>(ViewedPoint{
        point,
        {static_cast<float>(std::sin(angle)), static_cast<float>(std::cos(angle)), 0.0f},
        std::max(static_cast<float>(std::cos(angle)), grazing_cosine)});
    seen = viewed(material, view->n_dot_v);
  }
  [[nodiscard]] SkyQuery under(const Sky* sky) const { return {sky, *view, seen}; }

  SurfacePoint point;
  std::unique_ptr<ViewedPoint> view;
  ViewedMaterial seen{};
};

glm::dvec3 mean_of_samples(const SkyQuery& point, std::uint32_t count) {
  const SobolPixel places(3, 5, 7);
  glm::dvec3 sum(0.0);
  for (std::uint32_t i = 0; i < count; ++i)
    if (const auto sample = sample_sky(point, places.lobe(i, SampleStream::reflections)))
      sum += glm::dvec3(sample->carried);
  return sum / static_cast<double>(count);
}

SurfaceMaterial material_of(float metallic, float roughness) {
  SurfaceMaterial material{
      .base_color = {0.8f, 0.5f, 0.2f}, .metallic = metallic, .roughness = roughness};
  material.f0 = glm::mix(glm::vec3(0.04f), material.base_color, metallic);
  return material;
}

TEST(SampleSky, ItsMeanIsTheClosedFormOfAnOpenSky) {
  for (const float metallic : {0.0f, 1.0f}) {
    for (const float roughness : {0.1f, 0.35f, 0.6f, 1.0f}) {
      for (const double angle : {0.0, 0.6, 1.2, 1.45}) {
        const Seen seen(material_of(metallic, roughness), angle);
        const SkyQuery point = seen.under(nullptr);
        const auto open = unoccluded_sky(point);
        ASSERT_TRUE(open);
        const glm::dvec3 found = mean_of_samples(point, 1 << 15);
        for (int i = 0; i < 3; ++i)
          EXPECT_NEAR(found[i], (*open)[i], 3e-3 * static_cast<double>(sky_radiance))
              << metallic << ' ' << roughness << ' ' << angle << ' ' << i;
      }
    }
  }
}

TEST(SampleSky, OfAMatteSurfaceUnderAGradientItsMeanIsTheClosedForm) {
  const Sky sky({0.2f, 0.5f, 1.0f}, {1.0f, 0.8f, 0.3f});
  SurfaceMaterial matte = material_of(0.0f, 1.0f);
  matte.f0 = glm::vec3(0.0f);
  matte.f90 = 0.0f;
  matte.dielectric_f0 = matte.dielectric_f90 = 0.0f;
  const Seen seen(matte, 0.5);
  const auto open = unoccluded_sky(seen.under(&sky));
  ASSERT_TRUE(open);
  const glm::dvec3 found = mean_of_samples(seen.under(&sky), 1 << 14);
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(found[i], (*open)[i], 5e-4);
  EXPECT_FALSE(unoccluded_sky(Seen(material_of(1.0f, 0.5f), 0.5).under(&sky)))
      << "glossy surfaces under a gradient have no closed form";
}

// With a tilted shading normal a uniform sky gives the same irradiance as with the geometric one.
TEST(SampleSky, NothingIsLostBelowTheSurfaceOfATiltedNormal) {
  const SobolPixel places(3, 5, 7);
  for (const double tilt : {0.2, 0.6}) {
    for (const float roughness : {0.4f, 1.0f}) {
      Seen seen(material_of(1.0f, roughness), 1.2);
      seen.point.geometric_normal =
          glm::vec3(-static_cast<float>(std::sin(tilt)), static_cast<float>(std::cos(tilt)), 0.0f);
      const SkyQuery point = seen.under(nullptr);
      for (std::uint32_t i = 0; i < 256; ++i) {
        const auto sample = sample_sky(point, places.lobe(i, SampleStream::reflections));
        if (sample) {
          EXPECT_GE(glm::dot(sample->direction, seen.point.geometric_normal), -1e-6f);
        }
      }
      const glm::dvec3 found = mean_of_samples(point, 1 << 15), open(*unoccluded_sky(point));
      for (int i = 0; i < 3; ++i)
        EXPECT_NEAR(found[i], open[i], 3e-3 * static_cast<double>(sky_radiance)) << tilt;
    }
  }
}

// The mean of a control variate is 0, whatever the sky and however the normal is tilted.
TEST(OpenSky, LessItsSamplesIsZeroOnAverage) {
  const Sky gradient({0.2f, 0.5f, 1.0f}, {1.0f, 0.8f, 0.3f}), picture(Environment::softboxes);
  const SobolPixel places(3, 5, 7);
  constexpr std::uint32_t count = 1 << 15;
  for (const Sky* sky : {static_cast<const Sky*>(nullptr), &gradient, &picture}) {
    for (const double tilt : {0.0, 0.4}) {
      Seen seen(material_of(0.0f, 0.5f), 0.8);
      seen.point.geometric_normal = {-static_cast<float>(std::sin(tilt)),
                                     static_cast<float>(std::cos(tilt)), 0.0f};
      const SkyQuery point = seen.under(sky);
      glm::dvec3 sum(0.0);
      double squares = 0.0, without = 0.0;
      for (std::uint32_t i = 0; i < count; ++i) {
        const auto sample = sample_sky(point, places.lobe(i, SampleStream::reflections));
        const glm::dvec3 less(open_sky_less(point, sample));
        const glm::dvec3 all(sample ? sample->carried : glm::vec3(0.0f));
        sum += less;
        squares += std::pow(all.x + less.x, 2.0) / count - std::pow(all.x, 2.0) / count;
        without += all.x / count;
      }
      for (int i = 0; i < 3; ++i) EXPECT_NEAR(sum[i] / count, 0.0, 1e-3) << tilt;
      if (tilt == 0.0) {
        EXPECT_LT(squares, -1e-4 * without) << "samples vary less with it";
      }
    }
  }
}

/// A dim sky with a sun of two texels.
Sky sunny() {
  constexpr int height = 64;
  std::vector<glm::vec3> texels(2 * height * height, glm::vec3(0.1f));
  texels[10 * 2 * height + 40] = texels[10 * 2 * height + 41] = glm::vec3(5000.0f);
  return Sky(SkyMap(2 * height, height, std::move(texels)), 30.0, "sunny");
}

TEST(SampleSky, FindsTheSunOfAPicture) {
  const Sky sky = sunny();
  const Seen seen(material_of(0.0f, 1.0f), 0.5);
  // Many samples are the reference.
  const glm::dvec3 many = mean_of_samples(seen.under(&sky), 1 << 16);
  const glm::dvec3 few = mean_of_samples(seen.under(&sky), 1 << 11);
  const double matte = static_cast<double>(sky.ambient({0, 1, 0}).x / sky_visibility) *
                       static_cast<double>(seen.seen.diffuse.x);
  EXPECT_GT(many.x, matte) << "its lobe adds some";
  EXPECT_LT(many.x, 1.15 * matte);
  EXPECT_NEAR(few.x, many.x, 0.1 * many.x) << "a sun of 1e-4 of the sky needs few samples";
}

TEST(SkyDistribution, TellsHowDenselyItsDirectionsAre) {
  const Sky sky = sunny();
  const SobolPixel places(1, 2, 3);
  constexpr std::uint32_t count = 1 << 14;
  double sphere = 0.0;
  std::uint32_t beside = 0;  // near a texel's border, where floats may round over it
  for (std::uint32_t i = 0; i < count; ++i) {
    const SkyDirection found = sky.bright_direction(places.lobe(i, SampleStream::reflections));
    EXPECT_NEAR(glm::length(found.direction), 1.0, 1e-9);
    EXPECT_GT(found.density, 0.0);
    const double told = sky.bright_density(glm::vec3(found.direction));
    beside += std::abs(told / found.density - 1.0) > 1e-9;
    sphere += 1.0 / found.density / count;
  }
  EXPECT_LT(beside, count / 1000);
  EXPECT_NEAR(sphere, 4.0 * std::numbers::pi, 0.05 * 4.0 * std::numbers::pi);
}

}  // namespace
}  // namespace asos::test::sky_light_test
