#pragma once

#include "renderer/sampling/sobol_points.h"
#include "renderer/shading/shade.h"
#include "renderer/shading/sky.h"
#include "renderer/shading/sky_light.h"
#include "tests/support/make_light.h"
#include "tests/support/reflector_material.h"
#include "tests/support/rendering_equation.h"
#include "tests/support/tiny_world.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <span>
#include <utility>
#include <vector>

// Shading of a material on a floor, against the formulas of glTF and its extensions.

namespace asos::test {

/// Sums the light from lights and sky through all layers; the sky by samples, or in closed form if
/// nothing occludes it.
class FloorTransport final : public LightTransport {
 public:
  explicit FloorTransport(std::uint32_t samples) : samples_(samples) {}

  void add(const Illumination& lit, glm::vec3& radiance, RenderStatistics& /*counts*/) override {
    radiance += lit.reflected * lit.unshadowed;
  }
  bool add_sky(const SkyQuery& point, glm::vec3& radiance, RenderStatistics& /*counts*/) override {
    const SobolPixel places(3, 5, 7);
    glm::dvec3 sum(0.0);
    for (std::uint32_t i = 0; i < samples_; ++i)
      if (const auto sample = sample_sky(point, places.lobe(i, SampleStream::reflections)))
        sum += glm::dvec3(sample->carried);
    radiance += glm::vec3(sum / static_cast<double>(samples_));
    return true;
  }

 private:
  std::uint32_t samples_;
};

/// Number of sky samples for an error of about 1e-2.
inline constexpr std::uint32_t sky_samples = 1 << 13;

/// The floor's centre, seen at an angle to the vertical.
inline SeenPoint seen_at(double angle) {
  return {{0, 0, 0}, {0, 1, 0}, {std::sin(angle), std::cos(angle), 0}};
}

/// A floor in y = 0 with texture coordinate u along x and v against z, under a sky and optional
/// lights.
struct SeenFloor {
  World world;
  Lighting lighting;
  RenderFeatures render_features;
  RayScene rays;

  explicit SeenFloor(const Material& material, std::vector<Light> lights = {}) {
    add_quad(world, {-50, 0, 50}, {100, 0, 0}, {0, 0, -100}, material);
    lighting = prepare_lighting(world, std::move(lights));
    render_features = find_render_features(world).with(lighting.render_features);
    rays = RayScene::build(world, alpha_at, lighting.lights).value();
  }
  SeenFloor(const SeenFloor&) = delete;

  /// Radiance at the floor's centre towards a unit direction; for an unoccluded sky without
  /// samples.
  [[nodiscard]] glm::vec3 look(glm::vec3 to_viewer, const Sky& sky,
                               std::uint32_t samples = 0) const {
    ShadingSettings settings{.sky_shadows = samples > 0, .sky = &sky};
    FloorTransport transport(samples);
    RenderStatistics counts;
    const Ray ray{.origin = 10.0f * to_viewer, .direction = -to_viewer};
    return Shader(world, render_features, rays, lighting, settings)
        .radiance(ray, rays.closest(ray), 0.0f, transport, counts);
  }
  [[nodiscard]] glm::vec3 look(double angle, const Sky& sky, std::uint32_t samples = 0) const {
    return look(glm::vec3(seen_at(angle).to_viewer), sky, samples);
  }
};

/// Expects the sky's samples to give the integral of the formula, at most `most`, under a sky of
/// radiance 1.
inline void expect_albedo_under_white_sky(const Reflector& reflector,
                                          std::span<const double> angles,
                                          float most = std::numeric_limits<float>::infinity()) {
  const Sky white(glm::vec3(1.0f));
  const SeenFloor floor(material_of(reflector));
  for (const double angle : angles) {
    const SeenPoint at = seen_at(angle);
    const LayersSeen layers(reflector, at);
    const glm::dvec3 albedo =
        over_hemisphere(at, 150, [&](glm::dvec3 l) { return gltf_brdf(reflector, at, layers, l); });
    const glm::vec3 found = floor.look(angle, white, sky_samples);
    for (int c = 0; c < 3; ++c) {
      EXPECT_NEAR(found[c], albedo[c], 1e-2) << angle;
      EXPECT_LE(found[c], most) << angle;
    }
  }
}

/// Expects the formula's radiance for suns in several places.
inline void expect_formula_under_suns(const Reflector& reflector, std::span<const double> angles) {
  const Sky dark(glm::vec3(0.0f));
  for (const double angle : angles) {
    for (const glm::dvec3 light : {glm::dvec3(0.2, 1, 0.1), {-0.9, 0.5, 0.3}, {1, 0.2, -1}}) {
      const glm::dvec3 to_light = glm::normalize(light);
      const Light sun = make_sun(-to_light, 2.0f);
      const SeenFloor floor(material_of(reflector), {sun});
      const SeenPoint at = seen_at(angle);
      const glm::dvec3 expected =
          2.0 * to_light.y * gltf_brdf(reflector, at, LayersSeen(reflector, at), to_light);
      const glm::vec3 found = floor.look(angle, dark);
      for (int c = 0; c < 3; ++c)
        EXPECT_NEAR(found[c], expected[c], 4e-3 * expected[c] + 1e-4) << angle << ' ' << light.x;
    }
  }
}

}  // namespace asos::test
