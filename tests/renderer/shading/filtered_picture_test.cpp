#include "renderer/shading/shade.h"
#include "tests/support/make_light.h"
#include "tests/support/ray_transport.h"
#include "tests/support/tiny_image.h"
#include "tests/support/tiny_world.h"

#include <gtest/gtest.h>

#include <cmath>

// Whole pictures through the shader: one sample per pixel against the limit of many point samples.

namespace asos {
namespace {

class Picture {
 public:
  static constexpr int width = 64;
  static constexpr int height = 48;

  Picture(World world, const Camera& camera, std::vector<Light> lights = {})
      : world_(std::move(world)),
        lighting_(prepare_lighting(world_, std::move(lights))),
        needs_(find_render_features(world_).with(lighting_.render_features)),
        mips_(world_, needs_),
        view_(camera, width, height),
        rays_(RayScene::build(world_, alpha_at).value()) {}
  Picture(const Picture&) = delete;

  /// RMSE of one sample per pixel against n x n point samples per pixel.
  [[nodiscard]] double error(float side, int n) const {
    const ShadingSettings settings{
        .shadows = false, .mips = &mips_, .spacing = PixelSpacing::of(view_)};
    const Shader shader(world_, needs_, rays_, lighting_, settings);
    double sum = 0.0;
    for (int y = 0; y < height; ++y) {
      for (int x = 0; x < width; ++x) {
        glm::dvec3 mean(0.0);
        for (int i = 0; i < n * n; ++i)
          mean += look(shader, x + (i % n + 0.5) / n, y + (i / n + 0.5) / n, 0.0f);
        const glm::dvec3 d = look(shader, x + 0.5, y + 0.5, side) - mean / double(n * n);
        sum += glm::dot(d, d) / 3.0;
      }
    }
    return std::sqrt(sum / (width * height));
  }

 private:
  [[nodiscard]] glm::dvec3 look(const Shader& shader, double x, double y, float side) const {
    RenderStatistics counts;
    const Ray ray = view_.ray(x, y);
    test::RayTransport transport(rays_);
    return glm::dvec3(shader.radiance(ray, rays_.closest(ray), side, transport, counts));
  }

  World world_;
  Lighting lighting_;
  RenderFeatures needs_;
  MipChains mips_;
  View view_;
  RayScene rays_;
};

World floor_to_the_horizon() {
  World world;
  Material m = test::unlit(glm::vec3(1));
  m.base_color_texture.texture = test::add_texture(
      world,
      test::make_image(
          64, 64,
          [](int x, int y) {
            const bool white = (x / 8 + y / 8) % 2 == 0;
            return white ? test::Texel{255, 220, 180, 255} : test::Texel{20, 30, 60, 255};
          }),
      Wrap::repeat, Filter::linear);
  test::add_quad(world, {-200, 0, 5}, {400, 0, 0}, {0, 0, -400}, m);
  for (glm::vec2& uv : world.texcoords[0]) uv *= 200.0f;
  return world;
}

TEST(FilteredPicture, ATexturedPlaneToTheHorizonHasNoMoire) {
  const Picture picture(floor_to_the_horizon(), test::look_at({0, 1, 4}, {0, 0.6, 0}, 0.9));
  const double point = picture.error(0.0f, 32);
  const double footprint = picture.error(1.0f, 32);
  RecordProperty("point", std::to_string(point));
  RecordProperty("footprint", std::to_string(footprint));
  EXPECT_LT(footprint, point / 4.0) << point << " " << footprint;
}

TEST(FilteredPicture, HighlightsOnSmallShinyThingsDoNotSparkle) {
  // Spheres of two pixels, whose highlights are far narrower than a pixel.
  World world;
  Material m = test::matte(glm::vec3(0.8f));
  m.metallic = 1.0f;
  m.roughness = 0.15f;
  for (int y = 0; y < 8; ++y)
    for (int x = 0; x < 10; ++x)
      test::add_sphere(
          world, {0.37f * static_cast<float>(x) - 1.6f, 0.37f * static_cast<float>(y) - 1.3f, 0},
          0.16f, 24, m);
  const Light sun = test::make_sun(glm::normalize(glm::dvec3(-0.3, -0.4, -1)), 2.0f);
  const Picture picture(std::move(world), test::orthographic(3.0), {sun});
  const double point = picture.error(0.0f, 32);
  const double footprint = picture.error(1.0f, 32);
  EXPECT_LT(footprint, point / 2.0) << point << " " << footprint;
}

}  // namespace
}  // namespace asos
