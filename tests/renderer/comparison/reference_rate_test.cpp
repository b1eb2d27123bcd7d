#include "tests/support/render_picture.h"
#include "tests/support/rendering_equation.h"
#include "tests/support/sample_lights.h"
#include "tests/support/tiny_scene.h"
#include "tests/support/tiny_world.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <memory>
#include <string>
#include <utility>
#include <vector>

// Sobol sampling is the reference for everything else and must be unbiased: the mean over seeds
// converges to the rendering equation with the square root of the sample count.

namespace asos::test::reference_rate_test {
namespace {

constexpr int seeds = 512;
constexpr int side = 8;
constexpr int samples = 4;

/// Pictures of a tiny area around the origin, so that all pixels have the same expectation. Each
/// pixel of each seed is an estimate (mean over the channels).
std::vector<double> estimates(const RenderScene& scene, RenderSettings settings, glm::dvec3 eye) {
  settings.method = Method::sobol;
  settings.width = settings.height = side;
  settings.sampling.spp = samples;
  std::vector<double> all;
  for (int seed = 0; seed < seeds; ++seed) {
    settings.seed = seed;
    const Film film = render_picture(scene, look_at(eye, {0, 0, 0}, 1e-4), settings).film;
    for (const glm::vec3& c : film.radiance)
      all.push_back(static_cast<double>(c.x + c.y + c.z) / 3.0);
  }
  return all;
}

struct Mean {
  double value = 0.0;
  double standard_error = 0.0;
};

Mean mean_of(const std::vector<double>& all) {
  const auto count = static_cast<double>(all.size());
  double sum = 0.0, squares = 0.0;
  for (const double x : all) sum += x;
  for (const double x : all) squares += (x - sum / count) * (x - sum / count);
  return {sum / count, std::sqrt(squares / (count * (count - 1.0)))};
}

/// RMSE of means of `together` estimates.
double error_of_means(const std::vector<double>& all, std::size_t together, double truth) {
  double squares = 0.0;
  for (std::size_t first = 0; first < all.size(); first += together) {
    double sum = 0.0;
    for (std::size_t i = first; i < first + together; ++i) sum += all[i];
    const double off = sum / static_cast<double>(together) - truth;
    squares += off * off;
  }
  return std::sqrt(squares * static_cast<double>(together) / static_cast<double>(all.size()));
}

/// Exponent of the error of means by their number, from single estimates to means of 2048: -1/2
/// without bias.
double rate(const std::vector<double>& all, double truth) {
  return std::log2(error_of_means(all, 2048, truth) / error_of_means(all, 1, truth)) / 11.0;
}

// Either test detects a bias of one percent.
void expect_unbiased(const std::vector<double>& all, double truth, const std::string& name) {
  ASSERT_EQ(all.size(), std::size_t{seeds * side * side});
  const Mean mean = mean_of(all);
  constexpr double likely = 3.5;
  EXPECT_NEAR(mean.value, truth, likely * mean.standard_error) << name;
  EXPECT_NEAR(rate(all, truth), -0.5, 0.1) << name;
  std::vector<double> biased = all;
  for (double& x : biased) x += 0.01 * truth;
  const Mean off = mean_of(biased);
  EXPECT_GT(std::abs(off.value - truth), likely * off.standard_error) << name;
  EXPECT_GT(std::abs(rate(biased, truth) + 0.5), 0.1) << name;
}

Light lamp() {
  Light light = rectangle_light();
  light.position = {0.2, 1.0, -0.4};
  light.direction = {0, -1, 0};
  light.half_u = {0.4, 0, 0};
  light.half_v = {0, 0, -0.25};
  light.color = glm::vec3(1.0f);
  light.intensity = 3.0f;
  return light;
}

RenderSettings in_the_dark() {
  RenderSettings settings;
  settings.sky = std::make_shared<const Sky>(glm::vec3(0.0f));
  return settings;
}

/// A floor of this material under the lamp, seen at its centre.
void expect_unbiased_floor(const Reflector& reflector, const std::string& name) {
  World world;
  Material material = matte(glm::vec3(reflector.base));
  material.metallic = static_cast<float>(reflector.metallic);
  material.roughness = static_cast<float>(reflector.roughness);
  add_quad(world, {-5, 0, 5}, {10, 0, 0}, {0, 0, -10}, material);
  const auto scene = make_render_scene(std::move(world), {lamp()});
  const glm::dvec3 eye(0.1, 0.8, 0.7);
  const SeenPoint at{{0, 0, 0}, {0, 1, 0}, glm::normalize(eye)};
  const glm::dvec3 truth = reflected_radiance(prepare_light(lamp()), reflector, at);
  expect_unbiased(estimates(*scene, in_the_dark(), eye), (truth.x + truth.y + truth.z) / 3.0, name);
}

TEST(ReferenceRate, OfAMatteFloorUnderAnAreaLight) {
  expect_unbiased_floor({{0.8, 0.5, 0.3}, 0.0, 1.0}, "matte");
}

TEST(ReferenceRate, OfAGlossyMetalUnderAnAreaLight) {
  expect_unbiased_floor({{0.9, 0.6, 0.3}, 1.0, 0.45}, "metal");
}

TEST(ReferenceRate, OfADielectricUnderAnAreaLight) {
  expect_unbiased_floor({{0.2, 0.3, 0.1}, 0.0, 0.3}, "dielectric");
}

// A black wall of practically infinite length hides 28 % of a uniform sky's light.
TEST(ReferenceRate, OfTheSkyBesideAWall) {
  constexpr double albedo = 0.5, radiance = 0.8, height = 2.0;
  World world;
  Material chalk = matte(glm::vec3(static_cast<float>(albedo)));
  chalk.specular = 0.0f;
  add_quad(world, {-500, 0, 500}, {1000, 0, 0}, {0, 0, -1000}, chalk);
  add_quad(world, {1, 0, 1000}, {0, 0, -2000}, {0, static_cast<float>(height), 0},
           matte(glm::vec3(0.0f)));
  Light dark = distant_light();
  dark.direction = {0, 1, 0};
  dark.intensity = 1e-9f;
  const auto scene = make_render_scene(std::move(world), {dark});
  RenderSettings settings = in_the_dark();
  settings.sky = std::make_shared<const Sky>(glm::vec3(static_cast<float>(radiance)));
  settings.shadow.sky = true;
  const double hidden = 0.5 * (1.0 - 1.0 / std::hypot(1.0, height));
  expect_unbiased(estimates(*scene, settings, {0, 0.4, 0.9}), albedo * radiance * (1.0 - hidden),
                  "sky");
}

}  // namespace
}  // namespace asos::test::reference_rate_test
