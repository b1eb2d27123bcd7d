#include "renderer/prepared/own_lights.h"
#include "renderer/shading/sky.h"
#include "tests/support/render_picture.h"
#include "tests/support/rendering_equation.h"
#include "tests/support/sample_lights.h"
#include "tests/support/shape_world.h"
#include "tests/support/tiny_scene.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

// Pictures of direct light against the rendering equation, pixel by pixel.

namespace asos::test::true_light_test {
namespace {

constexpr int width = 80, height = 60;
/// The truth is worked out in every so many pixels, rows and columns.
constexpr int stride = 5;

enum class Subject { sphere, plane, box };

constexpr double sphere_radius = 0.45;
constexpr double box_half = 0.3;

Camera camera_for(Subject subject) {
  if (subject == Subject::sphere) return look_at({0.3, 0.5, 2.2}, {0, 0, 0}, 0.5);
  if (subject == Subject::plane) return look_at({0.3, 0.9, 2.0}, {0, 0, 0}, 0.5);
  return look_at({1.0, 1.1, 1.6}, {0, 0, 0}, 0.5);
}

/// The light above the origin, on the camera's far side a little.
Light placed(Light light) {
  light.position = {0.1, 1.3, -0.3};
  light.direction = glm::normalize(glm::dvec3(0.0, -1.0, 0.15));
  light.color = glm::vec3(1.0f);
  light.intensity = 3.0f;
  return light;
}

Light light_of(const std::string& kind) {
  const glm::dvec3 u(1, 0, 0);
  const glm::dvec3 down = glm::normalize(glm::dvec3(0.0, -1.0, 0.15));
  const glm::dvec3 v = glm::cross(down, u);
  Light light;
  if (kind == "rectangle") {
    light = placed(rectangle_light());
    light.half_u = 0.6 * u;
    light.half_v = 0.3 * v;
  } else if (kind == "disk") {
    light = placed(disk_light());
    light.radius = 0.4;
  } else if (kind == "ball") {
    light = placed(ball_light(0.3));
  } else if (kind == "line") {
    light = placed(linear_light());
    light.half_u = 0.6 * u;
  } else if (kind == "sun") {
    light = placed(sun_light(0.3));
    light.direction = glm::normalize(glm::dvec3(-0.1, -1.0, 0.3));
  } else {
    light = placed(polygon_light());
    const auto outline = [&](double x, double y) {
      const glm::dvec3 p = light.position;
      return std::vector<glm::dvec3>{p - x * u - y * v, p + x * u - y * v, p + x * u + y * v,
                                     p - x * u + y * v};
    };
    light.outlines = {outline(0.6, 0.4), outline(0.3, 0.15)};
  }
  return light;
}

Material material_of(const Reflector& reflector) {
  Material material = matte(glm::vec3(reflector.base));
  material.metallic = static_cast<float>(reflector.metallic);
  material.roughness = static_cast<float>(reflector.roughness);
  return material;
}

World world_of(Subject subject, const Reflector& reflector) {
  World world;
  const Material material = material_of(reflector);
  if (subject == Subject::sphere) {
    add_shape(world, sphere(sphere_radius), glm::dmat4(1.0), material);
  } else if (subject == Subject::plane) {
    add_quad(world, {-20, 0, 20}, {40, 0, 0}, {0, 0, -40}, material);
  } else {
    constexpr auto h = static_cast<float>(box_half);
    for (int axis = 0; axis < 3; ++axis) {
      for (const float side : {-1.0f, 1.0f}) {
        glm::vec3 out(0.0f), u(0.0f), v(0.0f);
        out[axis] = side * h;
        u[(axis + 1) % 3] = 2.0f * h;
        v[(axis + 2) % 3] = 2.0f * h * side;
        add_quad(world, out - 0.5f * u - 0.5f * v, u, v, material);
      }
    }
  }
  return world;
}

/// Where a ray meets the subject, and which of its faces; exact, whatever the world is made of.
struct Met {
  SeenPoint point;
  int face = 0;
};
std::optional<Met> meet(Subject subject, glm::dvec3 origin, glm::dvec3 direction) {
  const auto met = [&](double t, glm::dvec3 normal, int face) {
    return Met{{origin + t * direction, normal, -direction}, face};
  };
  if (subject == Subject::plane) {
    if (!(direction.y < 0.0)) return std::nullopt;
    return met(-origin.y / direction.y, {0, 1, 0}, 0);
  }
  if (subject == Subject::sphere) {
    const double along = -glm::dot(origin, direction);
    const glm::dvec3 beside = origin + along * direction;
    const double depth2 = sphere_radius * sphere_radius - glm::dot(beside, beside);
    if (!(depth2 > 0.0)) return std::nullopt;
    const double t = along - std::sqrt(depth2);
    return met(t, (origin + t * direction) / sphere_radius, 0);
  }
  double enter = 0.0, leave = 1e9;
  int face = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const double side = direction[axis] > 0.0 ? -1.0 : 1.0;
    const double near = (side * box_half - origin[axis]) / direction[axis];
    if (near > enter) enter = near, face = axis;
    leave = std::min(leave, (-side * box_half - origin[axis]) / direction[axis]);
  }
  if (!(enter < leave)) return std::nullopt;
  glm::dvec3 normal(0.0);
  normal[face] = direction[face] > 0.0 ? -1.0 : 1.0;
  return met(enter, normal, face);
}

/// By n x n points of each pixel that shows one face of the subject alone; nothing elsewhere.
std::vector<std::optional<glm::dvec3>> truth(Subject subject, const Reflector& reflector,
                                             const PreparedLight& light, int n) {
  const View view(camera_for(subject), width, height);
  const auto at = [&](double x, double y) {
    const Ray ray = view.ray(x, y);
    return meet(subject, glm::dvec3(ray.origin), glm::normalize(glm::dvec3(ray.direction)));
  };
  std::vector<std::optional<glm::dvec3>> picture;
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      auto& pixel = picture.emplace_back();
      if (x % stride != 2 || y % stride != 2) continue;
      bool whole = true;
      const auto first = at(x, y);
      for (const glm::dvec2 corner : {glm::dvec2(0, 0), {1, 0}, {0, 1}, {1, 1}}) {
        const auto met = at(x + corner.x, y + corner.y);
        whole = whole && met && met->face == first->face;
      }
      if (!whole) continue;
      glm::dvec3 sum(0.0);
      for (int i = 0; i < n * n; ++i) {
        const auto met = at(x + (i % n + 0.5) / n, y + (i / n + 0.5) / n);
        sum += reflected_radiance(light, reflector, met->point);
      }
      pixel = sum / static_cast<double>(n * n);
    }
  }
  return picture;
}

RenderSettings settings_for(Method method) {
  RenderSettings settings;
  settings.method = method;
  settings.width = width;
  settings.height = height;
  settings.sky = std::make_shared<const Sky>(glm::vec3(0.0f));
  settings.asos.max_level = 3;
  return settings;
}

struct Errors {
  double mean = 0.0;  ///< of the truth
  double bias = 0.0;  ///< over the mean
  double rmse = 0.0;
  double worst = 0.0;
};

Errors errors_of(const Film& film, const std::vector<std::optional<glm::dvec3>>& exact) {
  Errors e;
  double square = 0.0;
  int count = 0;
  for (std::size_t i = 0; i < exact.size(); ++i) {
    if (!exact[i]) continue;
    for (int c = 0; c < 3; ++c) {
      // More than white is white.
      const double truth = std::min(1.0, (*exact[i])[c]);
      const double off = std::min(1.0, static_cast<double>(film.radiance[i][c])) - truth;
      e.mean += truth;
      e.bias += off;
      square += off * off;
      e.worst = std::max(e.worst, std::abs(off));
      ++count;
    }
  }
  e.bias /= e.mean;
  e.mean /= count;
  e.rmse = std::sqrt(square / count) / e.mean;
  e.worst /= e.mean;
  return e;
}

const std::array<const char*, 6> kinds{"rectangle", "disk", "ball", "line", "polygon", "sun"};

/// What ASOS may be off at most: RMSE over the mean, where lobes are broad enough that the mean
/// says something; and of display intensity under narrow ones, beside an EPS of 0.0039.
constexpr std::array roughnesses{0.1, 0.2, 0.3, 0.45, 0.6, 1.0};
constexpr double least_relative = 0.25;
using Bounds = std::array<double, roughnesses.size()>;

// Highlights of all that has a size, at MAX 3 and the usual EPS, with reflections followed as
// usual: what mirrors shows lights by its lobe.
void expect_true(Subject subject, double metallic, const Bounds& bounds) {
  for (std::size_t i = 0; i < roughnesses.size(); ++i) {
    double worst = 0.0, worst_bias = 0.0;
    for (const char* kind : kinds) {
      const Light light = light_of(kind);
      const Reflector reflector{{0.9, 0.6, 0.3}, metallic, roughnesses[i]};
      const auto exact =
          truth(subject, reflector, prepare_light(light), roughnesses[i] < 0.25 ? 6 : 2);
      const auto scene = make_render_scene(world_of(subject, reflector), {light});
      RenderSettings settings = settings_for(Method::asos);
      const Picture picture = render_picture(*scene, camera_for(subject), settings);
      const Errors e = errors_of(picture.film, exact);
      EXPECT_GT(e.mean, 1e-4);
      const double off = roughnesses[i] < least_relative ? e.rmse * e.mean : e.rmse;
      EXPECT_LT(off, bounds[i]) << kind << ' ' << roughnesses[i] << ", bias " << e.bias << ", mean "
                                << e.mean;
      worst = std::max(worst, off);
      worst_bias = std::max(worst_bias, std::abs(e.bias));
    }
    testing::Test::RecordProperty(
        "roughness_" + std::to_string(i),
        testing::PrintToString(worst) + " bias " + testing::PrintToString(worst_bias));
  }
}

TEST(TrueLight, OnAMetalSphere) {
  expect_true(Subject::sphere, 1.0, {0.008, 0.0045, 0.055, 0.012, 0.016, 0.016});
}

TEST(TrueLight, OnASphere) {
  expect_true(Subject::sphere, 0.0, {0.027, 0.0006, 0.011, 0.011, 0.0065, 0.011});
}

TEST(TrueLight, OnAMetalPlane) {
  expect_true(Subject::plane, 1.0, {0.0005, 0.0007, 0.0022, 0.0004, 0.0002, 0.0003});
}

TEST(TrueLight, OnAPlane) {
  expect_true(Subject::plane, 0.0, {0.0002, 0.0001, 0.0004, 0.0003, 0.0003, 0.0003});
}

TEST(TrueLight, OnAMetalBox) {
  expect_true(Subject::box, 1.0, {0.0002, 0.0001, 0.004, 0.0011, 0.0013, 0.0055});
}

TEST(TrueLight, OnABox) {
  expect_true(Subject::box, 0.0, {0.0001, 0.0001, 0.0007, 0.0007, 0.0007, 0.0007});
}

// A glossy floor under a panel that shines, as a mesh: the lobe shows it and the reflection does
// not, nor is it lost. What a texture paints is left to the reflection.
TEST(TrueLight, ShowsAPanelThatShinesOnce) {
  const Reflector reflector{{0.9, 0.6, 0.3}, 1.0, 0.3};
  const Light panel = light_of("rectangle");
  const auto exact = truth(Subject::plane, reflector, prepare_light(panel), 2);
  World world = world_of(Subject::plane, reflector);
  Material shining = matte(glm::vec3(0.0f));
  shining.emissive = glm::vec3(1.0f);
  shining.emissive_strength = panel.intensity;
  const glm::vec3 u(panel.half_u), v(panel.half_v);
  // It faces the way that u x v leads.
  ASSERT_GT(glm::dot(glm::cross(u, v), glm::vec3(panel.direction)), 0.0f);
  add_quad(world, glm::vec3(panel.position) - u - v, 2.0f * u, 2.0f * v, shining);
  std::vector<Light> lights = lights_of_meshes(world);
  ASSERT_EQ(lights.size(), 1u);
  const auto scene = make_render_scene(std::move(world), std::move(lights));
  for (const Method method : {Method::asos, Method::sobol}) {
    RenderSettings settings = settings_for(method);
    settings.sampling.spp = 256;
    const Picture picture = render_picture(*scene, camera_for(Subject::plane), settings);
    const Errors e = errors_of(picture.film, exact);
    EXPECT_LT(e.rmse, method == Method::asos ? 0.003 : 0.05) << "bias " << e.bias;
  }
}

// Where a light sets, what is left of it above the horizon is seen: a look at its other part finds
// nothing hidden.
TEST(TrueLight, DoesNotGoOutWhereALightSets) {
  World world;
  add_sphere(world, glm::vec3(0.0f), 0.45f, 64, matte(glm::vec3(0.9f)));
  Light light = placed(rectangle_light());
  light.position = {0.0, 0.55, 0.2};
  light.direction = {0, -1, 0};
  light.half_u = {0.3, 0, 0};
  light.half_v = {0, 0, -0.6};
  const auto scene = make_render_scene(std::move(world), {light});
  const Camera camera = look_at({0.0, 0.4, 2.4}, {0, 0, 0}, 0.6);
  const Film found = render_picture(*scene, camera, settings_for(Method::asos)).film;
  RenderSettings sampled = settings_for(Method::sobol);
  sampled.sampling.spp = 64;
  const Film expected = render_picture(*scene, camera, sampled).film;
  int lit = 0, dark = 0;
  for (std::size_t i = 0; i < found.radiance.size(); ++i) {
    if (!(expected.radiance[i].x > 1.0f / 256.0f)) continue;
    ++lit;
    dark += found.radiance[i].x == 0.0f;
  }
  EXPECT_GT(lit, 500);
  EXPECT_EQ(dark, 0);
}

// The quadrature itself does not change when it is made finer.
TEST(TrueLight, QuadratureHasConverged) {
  const SeenPoint at{{0.1, 0.0, 0.2}, {0, 1, 0}, glm::normalize(glm::dvec3(0.3, 0.5, 1.0))};
  for (const char* kind : kinds) {
    const PreparedLight light = prepare_light(light_of(kind));
    for (const double roughness : {0.1, 0.3, 1.0}) {
      for (const double metallic : {0.0, 1.0}) {
        const Reflector reflector{{0.9, 0.6, 0.3}, metallic, roughness};
        const double coarse = reflected_radiance(light, reflector, at).x;
        const double fine = reflected_radiance(light, reflector, at, 3.0).x;
        EXPECT_NEAR(coarse, fine, 1e-5 * fine) << kind << ' ' << roughness;
        EXPECT_GT(fine, 0.0);
      }
    }
  }
}

}  // namespace
}  // namespace asos::test::true_light_test
