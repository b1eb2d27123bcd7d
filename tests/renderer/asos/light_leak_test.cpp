#include "renderer/shading/sky.h"
#include "tests/support/make_settings.h"
#include "tests/support/render_picture.h"
#include "tests/support/sample_lights.h"
#include "tests/support/tiny_scene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

// Shadows without leaks, at scales from a watch to a city.

namespace asos::test::light_leak_test {
namespace {

constexpr double scales[] = {1e-4, 1.0, 1e4};

/// A box as one part with unshared corners, or with each face as a part.
void add_box(World& world, glm::vec3 lo, glm::vec3 hi, bool in_parts) {
  const Material material = matte({0.6f, 0.6f, 0.6f});
  std::vector<TinyVertex> vertices;
  std::vector<glm::uvec3> triangles;
  for (int axis = 0; axis < 3; ++axis) {
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    for (const int sign : {-1, 1}) {
      glm::vec3 corner = lo, a(0.0f), b(0.0f), n(0.0f);
      if (sign > 0) corner[axis] = hi[axis];
      (sign > 0 ? a : b)[u] = hi[u] - lo[u];
      (sign > 0 ? b : a)[v] = hi[v] - lo[v];
      n[axis] = static_cast<float>(sign);
      if (in_parts) {
        add_quad(world, corner, a, b, material);
        continue;
      }
      const auto first = static_cast<std::uint32_t>(vertices.size());
      for (const glm::vec3& p : {corner, corner + a, corner + a + b, corner + b})
        vertices.push_back({p, n, {}});
      triangles.emplace_back(first, first + 1, first + 2);
      triangles.emplace_back(first, first + 2, first + 3);
    }
  }
  if (!in_parts) add_part(world, vertices, triangles, material);
}

RenderSettings small(int width, int height) {
  RenderSettings settings = make_settings(width, height);
  settings.cull = false;
  settings.asos.eps = 0.0;  // so that weak lights are not skipped
  return settings;
}

double largest(glm::vec3 v) {
  return std::max({v.x, v.y, v.z});
}

/// The largest amount by which any channel of a pixel is brighter in `lit` than in `dark`.
double excess(const Picture& lit, const Picture& dark) {
  double worst = 0.0;
  for (std::size_t i = 0; i < lit.film.radiance.size(); ++i)
    worst = std::max(worst, largest(lit.film.radiance[i] - dark.film.radiance[i]));
  return worst;
}

void expect_dark_room(const std::vector<Light>& lights, Camera::Type eye) {
  for (const double scale : scales) {
    const auto s = static_cast<float>(scale);
    for (const bool in_parts : {false, true}) {
      World room;
      add_box(room, s * glm::vec3(-1, 0, -1), s * glm::vec3(1, 1, 1), in_parts);
      RenderSettings settings = small(24, 16);
      settings.sky = std::make_shared<const Sky>(glm::vec3(0.0f));
      for (const glm::dvec3 target : {glm::dvec3(0, 0, 1), glm::dvec3(-1, 1, -1)}) {
        Camera camera = look_at(scale * glm::dvec3(0.5, 0.6, -0.7), scale * target, 1.2);
        camera.type = eye;
        camera.height = 0.4 * scale;
        const Picture dark = render_picture(*make_render_scene(room), camera, settings);
        for (const Light& light : lights) {
          const Picture lit =
              render_picture(*make_render_scene(room, {scaled(light, scale)}), camera, settings);
          EXPECT_LE(excess(lit, dark), 0.0) << light.name << ' ' << scale << ' ' << in_parts;
        }
      }
    }
  }
}

std::vector<Light> all_but(Light::Type type) {
  std::vector<Light> lights = all_lights();
  std::erase_if(lights, [&](const Light& light) {
    return light.type == type && light.angular_diameter_rad == 0.0;
  });
  return lights;
}

TEST(LightLeak, AClosedRoomStaysDarkWhateverShinesOutside) {
  expect_dark_room(all_but(Light::Type::directional), Camera::Type::perspective);
  expect_dark_room(all_lights(), Camera::Type::orthographic);
}

// A ray to the sun starts with an offset, but not beyond the wall that borders its floor. Of many
// samples some start within that offset of the wall.
TEST(LightLeak, NoneOfManySamplesMeetsASunBehindTheWalls) {
  World room;
  add_box(room, {-1, 0, -1}, {1, 1, 1}, false);
  RenderSettings settings = small(24, 16);
  settings.method = Method::sobol;
  settings.sampling.spp = 4096;
  settings.sky = std::make_shared<const Sky>(glm::vec3(0.0f));
  for (const glm::dvec3 target : {glm::dvec3(0, 0, 1), glm::dvec3(-1, 1, -1)}) {
    Camera camera = look_at({0.5, 0.6, -0.7}, target, 1.2);
    camera.type = Camera::Type::orthographic;
    camera.height = 0.4;
    const Picture lit = render_picture(*make_render_scene(room, {sun_light()}), camera, settings);
    const Picture dark = render_picture(*make_render_scene(room), camera, settings);
    EXPECT_LE(excess(lit, dark), 0.0) << target.x;
  }
}

TEST(LightLeak, AClosedRoomStaysDarkUnderDirectionalLight) {
  expect_dark_room({distant_light()}, Camera::Type::perspective);
}

// Lights whose sum is below EPS: a small error does not justify letting them through walls. The
// office's lawn was 5e-4 too bright from lights inside.
TEST(LightLeak, DimLightsDoNotShineThroughWalls) {
  World room;
  add_box(room, {-1, 0, -1}, {1, 1, 1}, false);
  RenderSettings settings = small(24, 16);
  settings.asos.eps = AsosSettings{}.eps;
  settings.sky = std::make_shared<const Sky>(glm::vec3(0.0f));
  const Camera camera = look_at({0.5, 0.6, -0.7}, {0, 0, 1}, 1.2);
  const Picture dark = render_picture(*make_render_scene(room), camera, settings);
  for (Light light : all_lights()) {
    light.intensity *= 1e-3f;
    const Picture lit = render_picture(*make_render_scene(room, {light}), camera, settings);
    EXPECT_LE(excess(lit, dark), 0.0) << light.name;
  }
}

/// A floor with a box on it, lit by `light`.
Picture still_life_at(double scale, const Light& light, bool refined) {
  const auto s = static_cast<float>(scale);
  World world;
  add_quad(world, s * glm::vec3(-4, 0, 4), s * glm::vec3(8, 0, 0), s * glm::vec3(0, 0, -8),
           matte({0.7f, 0.7f, 0.6f}));
  add_box(world, s * glm::vec3(-0.3f, 0, -0.2f), s * glm::vec3(0.4f, 0.6f, 0.3f), false);
  RenderSettings settings = small(48, 32);
  settings.asos.refine_shading = refined;
  const Camera camera =
      look_at(scale * glm::dvec3(1.1, 1.3, 2.4), scale * glm::dvec3(0, 0.2, 0), 0.8);
  return render_picture(*make_render_scene(std::move(world), {scaled(light, scale)}), camera,
                        settings);
}

void expect_same_at_all_scales(const std::vector<Light>& lights) {
  for (const Light& light : lights) {
    const Picture one = still_life_at(1.0, light, false);
    for (const double scale : {1e-4, 1e-2, 1e2, 1e4}) {
      const Picture other = still_life_at(scale, light, false);
      double worst = 0.0;
      for (std::size_t i = 0; i < one.film.radiance.size(); ++i) {
        const glm::vec3 a = one.film.radiance[i], b = other.film.radiance[i];
        worst = std::max(worst, largest(glm::abs(a - b) / glm::max(a, glm::vec3(1e-6f))));
      }
      EXPECT_LT(worst, 1e-4) << light.name << ' ' << scale;
      testing::Test::RecordProperty(
          light.name + "_" + std::to_string(std::lround(std::log10(scale))),
          testing::PrintToString(worst));
    }
  }
}

TEST(LightLeak, APictureDoesNotDependOnTheScale) {
  expect_same_at_all_scales(all_but(Light::Type::linear));
}

/// Rounding may change which leaves are split or sampled, and on which side of an edge a ray
/// passes. Each picture's pixels have a standard error of half of the tolerance at the default MAX,
/// 1/256; the difference of two has at most 0.71 of the tolerance.
void expect_refined_at_all_scales(const std::vector<Light>& lights) {
  const double let_pass = std::ldexp(1.0, -8);
  for (const Light& light : lights) {
    const Picture one = still_life_at(1.0, light, true);
    for (const double scale : {1e-4, 1e4}) {
      const Picture other = still_life_at(scale, light, true);
      double sum2 = 0.0;
      for (std::size_t i = 0; i < one.film.radiance.size(); ++i) {
        const double off = largest(glm::abs(one.film.radiance[i] - other.film.radiance[i]));
        sum2 += off * off / static_cast<double>(one.film.radiance.size());
      }
      EXPECT_LT(std::sqrt(sum2), std::sqrt(0.5) * let_pass) << light.name << ' ' << scale;
    }
  }
}

TEST(LightLeak, ARefinedPictureDoesNotDependOnTheScale) {
  expect_refined_at_all_scales({point_light(), spot_light(), ball_light(), distant_light(),
                                rectangle_light(), disk_light(), polygon_light()});
}

TEST(LightLeak, ARefinedPictureUnderASunDoesNotDependOnTheScale) {
  expect_refined_at_all_scales({sun_light()});
}

TEST(LightLeak, APictureUnderALinearLightDoesNotDependOnTheScale) {
  expect_same_at_all_scales({linear_light()});
}

// No light arrives right behind the box, up to its contact line with the floor.
TEST(LightLeak, TheLineWhereABoxMeetsTheFloorIsDark) {
  for (const double scale : scales) {
    const auto s = static_cast<float>(scale);
    for (Light light : all_lights()) {
      light.position += glm::dvec3(-3.5, -1.2, 0.0);
      for (auto& outline : light.outlines)
        for (glm::dvec3& corner : outline) corner += glm::dvec3(-3.5, -1.2, 0.0);
      light.direction = glm::normalize(glm::dvec3(1.0, -0.5, 0.0));
      if (light.type == Light::Type::polygon || light.type == Light::Type::rectangle ||
          light.type == Light::Type::disk)
        light.direction = {0, -1, 0};
      light.two_sided = true;
      World world;
      add_quad(world, s * glm::vec3(-9, 0, 9), s * glm::vec3(18, 0, 0), s * glm::vec3(0, 0, -18),
               matte({0.7f, 0.7f, 0.6f}));
      add_box(world, s * glm::vec3(-1, 0, -9), s * glm::vec3(0, 4, 9), false);
      RenderSettings settings = small(16, 8);
      // A view from above on a few pixels of the box's top and side and the floor behind it; and a
      // close-up of the contact line alone.
      for (const double size : {1.0, 1e-2}) {
        const Camera camera = look_at(scale * (glm::dvec3(2.0, 1.5, 0.3) * size),
                                      scale * glm::dvec3(0.05 * size, 0, 0), 0.3);
        const Picture lit =
            render_picture(*make_render_scene(world, {scaled(light, scale)}), camera, settings);
        const Picture dark = render_picture(*make_render_scene(world), camera, settings);
        constexpr double rounding = 1e-6;  // of means over different numbers of samples
        EXPECT_LE(excess(lit, dark), rounding) << light.name << ' ' << scale << ' ' << size;
      }
    }
  }
}

}  // namespace
}  // namespace asos::test::light_leak_test
