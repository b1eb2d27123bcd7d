#include "tests/support/light_oracle.h"
#include "tests/support/make_settings.h"
#include "tests/support/render_picture.h"
#include "tests/support/sample_lights.h"
#include "tests/support/tiny_scene.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <utility>
#include <vector>

// The published rule for area lights, pixel by pixel, on an unoccluded floor: I A cos(theta) with
// inverse square, spheres without the cosine (CGF'98 section 4.2), and points along linear lights
// (GI'93 "Distributed Light Sources").

namespace asos::test::light_rule_test {
namespace {

constexpr int width = 40, height = 30;
constexpr double pi = std::numbers::pi;

Camera viewer() {
  return look_at({1.5, 2.0, 3.0}, {0.2, 0, 0.3}, 0.8);
}

/// A floor that fills the picture, without highlights, because they differ between the rules.
Picture picture_of(const std::vector<Light>& lights, Method method, LightRule rule) {
  World world;
  Material chalk = matte({0.9f, 0.9f, 0.9f});
  chalk.specular = 0.0f;
  add_quad(world, {-20, 0, 20}, {40, 0, 0}, {0, 0, -40}, chalk);
  RenderSettings settings = make_settings(width, height, method);
  settings.shadow.light_rule = rule;
  settings.asos.refine_shading = false;  // so that pixels are not split
  return render_picture(*make_render_scene(std::move(world), lights), viewer(), settings);
}

/// Irradiance on the floor per candela, or per cd/m² of flat lights.
using Form = std::function<double(const Receiver&)>;

double cosine_over_square(const Light& light, const Receiver& receiver) {
  const glm::dvec3 to_light = light.position - receiver.position;
  const double d = glm::length(to_light);
  return glm::dot(to_light, receiver.normal) / (d * d * d);
}

Form flat_form(const Light& light, double area) {
  return [light, area](const Receiver& receiver) {
    const glm::dvec3 to_light = light.position - receiver.position;
    const double cosine = -glm::dot(to_light, light.direction) / glm::length(to_light);
    return area * cosine * cosine_over_square(light, receiver);
  };
}

struct Case {
  Light light;
  Form form;
};

std::vector<Case> cases() {
  std::vector<Case> all;
  const Light rectangle = rectangle_light();
  all.push_back({rectangle, flat_form(rectangle, 4.0 * glm::length(rectangle.half_u) *
                                                     glm::length(rectangle.half_v))});
  Light tilted = rectangle;
  tilted.name = "tilted";
  tilted.half_v = {0, 0.3, -0.4};
  tilted.direction = {0, -0.8, -0.6};
  tilted.position = {0.2, 2.5, 1.5};
  all.push_back({tilted, flat_form(tilted, 4.0 * 0.8 * 0.5)});
  const Light disk = disk_light();
  all.push_back({disk, flat_form(disk, pi * disk.radius * disk.radius)});
  const Light ball = ball_light(0.3);
  // Radiance times the area of the visible disk: candela.
  all.push_back(
      {ball, [ball](const Receiver& receiver) { return cosine_over_square(ball, receiver); }});
  const Light line = linear_light();
  all.push_back({line, [line](const Receiver& receiver) {
                   return line_oracle(line.position - line.half_u, line.position + line.half_u,
                                      false, receiver) /
                          (2.0 * glm::length(line.half_u));
                 }});
  return all;
}

// The floor reflects irradiance in the same way under both rules, so the physical picture gives its
// reflectance.
TEST(LightRule, PublishedIsItsClosedFormInEveryPixel) {
  const Picture dark = picture_of({}, Method::asos, LightRule::physical);
  const View view(viewer(), width, height);
  for (const Case& c : cases()) {
    const Picture published = picture_of({c.light}, Method::asos, LightRule::published);
    const Picture physical = picture_of({c.light}, Method::asos, LightRule::physical);
    const PreparedLight prepared = prepare_light(c.light);
    double worst = 0.0, least = 1e9, most = 0.0;
    for (int y = 0; y < height; ++y) {
      for (int x = 0; x < width; ++x) {
        const Ray ray = view.ray(x + 0.5, y + 0.5);
        ASSERT_LT(ray.direction.y, 0.0f);
        Receiver receiver;
        receiver.position = glm::dvec3(ray.origin) - static_cast<double>(ray.origin.y) /
                                                         static_cast<double>(ray.direction.y) *
                                                         glm::dvec3(ray.direction);
        receiver.normal = receiver.geometric = {0, 1, 0};
        const std::size_t i = published.film.index(x, y);
        const double by_rule = static_cast<double>(published.film.radiance[i].x) -
                               static_cast<double>(dark.film.radiance[i].x);
        const double by_physics = static_cast<double>(physical.film.radiance[i].x) -
                                  static_cast<double>(dark.film.radiance[i].x);
        ASSERT_GT(by_physics, 0.0);
        const double irradiance =
            by_rule / by_physics * static_cast<double>(unshadowed_irradiance(prepared, receiver).x);
        const double exact = static_cast<double>(c.light.intensity) * c.form(receiver);
        EXPECT_NEAR(irradiance / exact, 1.0, 2e-5) << c.light.name << ' ' << x << ' ' << y;
        worst = std::max(worst, std::abs(irradiance / exact - 1.0));
        least = std::min(least, by_rule / by_physics);
        most = std::max(most, by_rule / by_physics);
      }
    }
    RecordProperty(c.light.name, testing::PrintToString(worst));
    // The rules differ, except for a sphere that is completely above the horizon.
    if (c.light.type == Light::Type::point) {
      EXPECT_NEAR(most - least, 0.0, 1e-5);
    } else {
      EXPECT_GT(most - least, 1e-3) << c.light.name;
    }
  }
}

TEST(LightRule, AsosPublishedShadesByThePublishedRule) {
  for (const Case& c : cases()) {
    const Picture published = picture_of({c.light}, Method::asos, LightRule::published);
    const Picture by_method = picture_of({c.light}, Method::asos_published, LightRule::physical);
    // Rays traced in packets may differ in the last bits of their hits.
    for (std::size_t i = 0; i < published.film.radiance.size(); ++i)
      EXPECT_NEAR(by_method.film.radiance[i].x / published.film.radiance[i].x, 1.0, 1e-5)
          << c.light.name << ' ' << i;
  }
}

}  // namespace
}  // namespace asos::test::light_rule_test
