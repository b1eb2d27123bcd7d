#include "renderer/shading/sky.h"
#include "renderer/shading/sky_light.h"
#include "tests/support/make_settings.h"
#include "tests/support/render_picture.h"
#include "tests/support/tiny_image.h"
#include "tests/support/tiny_scene.h"
#include "tests/support/tiny_world.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <ostream>

// White furnaces for surfaces whose shading normals differ from their geometric ones. Under a sky
// of radiance 1 a point must have the radiance of its lobes' closed forms (lobe_norms). No light is
// lost where a lobe about the shading normal points below the surface.

namespace asos::test::mesh_furnace_test {
namespace {

enum class Lobe { dielectric, metal, clearcoat, sheen, transmission };
enum class Mesh { sphere, normal_map };

struct Furnace {
  Lobe lobe;
  Mesh mesh;
  double roughness;

  friend std::ostream& operator<<(std::ostream& out, const Furnace& f) {
    return out << "lobe " << static_cast<int>(f.lobe) << " mesh " << static_cast<int>(f.mesh)
               << " roughness " << f.roughness;
  }
};

Material material_of(const Furnace& f) {
  Material m = matte(glm::vec3(1.0f));
  m.double_sided = true;
  m.roughness = static_cast<float>(f.roughness);
  switch (f.lobe) {
    case Lobe::dielectric:
      break;
    case Lobe::metal:
      m.metallic = 1.0f;
      break;
    case Lobe::clearcoat:
      m.metallic = 1.0f;
      m.coat.factor = 1.0f;
      m.coat.roughness = m.roughness;
      m.roughness = 0.5f;
      break;
    case Lobe::sheen:
      m.sheen.color = glm::vec3(1.0f);
      m.sheen.roughness = m.roughness;
      m.roughness = 1.0f;
      break;
    case Lobe::transmission:
      m.transmission = 1.0f;
      break;
  }
  return m;
}

/// Bumps of up to 20 degrees.
Image bumps() {
  return make_image(16, 16, [](int x, int y) {
    const auto byte = [](double slope) {
      return static_cast<std::uint8_t>(std::lround(127.5 + 127.5 * slope));
    };
    const double u = 0.34 * std::sin(0.3927 * x), v = 0.34 * std::cos(0.7854 * y);
    return Texel{byte(u / std::sqrt(1.0 + u * u + v * v)), byte(v / std::sqrt(1.0 + u * u + v * v)),
                 byte(1.0 / std::sqrt(1.0 + u * u + v * v)), 255};
  });
}

std::shared_ptr<const RenderScene> scene_of(const Furnace& f) {
  World world;
  Material material = material_of(f);
  if (f.mesh == Mesh::normal_map)
    material.normal_texture.texture = add_texture(world, bumps(), Wrap::repeat, Filter::linear);
  if (f.mesh == Mesh::normal_map) {
    add_quad(world, {-9, 0, 9}, {18, 0, 0}, {0, 0, -18}, material);
  } else {
    add_sphere(world, {0, 0, 0}, 1.0f, 8, material);
  }
  Light dark;  // without any light there would be default lighting
  dark.type = Light::Type::directional;
  dark.direction = {0, 1, 0};
  dark.intensity = 1e-9f;
  return make_render_scene(std::move(world), {dark});
}

constexpr int side = 12;

Camera camera_of(const Furnace& f) {
  return f.mesh == Mesh::normal_map ? look_at({0, 1.5, 3}, {0, 0, 0}, 0.3)
                                    : look_at({0.7, 1.5, 3}, {0, 0, 0}, 0.6);
}

RenderSettings settings_of(Method method) {
  RenderSettings settings = make_settings(side, side, method, 512);
  settings.asos.eps = 1.0 / 1024.0;
  settings.mirror.bounces = 16;
  settings.shadow.sky = true;
  settings.texture.filter = TextureFilter::point;
  settings.sky = std::make_shared<const Sky>(glm::vec3(1.0f));
  return settings;
}

/// Sums the radiance that all lobes reflect from a white sky.
class ReturnedByLobes final : public LightTransport {
 public:
  void add(const Illumination&, glm::vec3&, RenderStatistics&) override {}
  bool add_sky(const SkyQuery& point, glm::vec3& radiance, RenderStatistics&) override {
    radiance += unoccluded_sky(point).value();
    return true;
  }
  bool reflect(const Reflection& reflection, glm::vec3& radiance, RenderStatistics&) override {
    radiance += reflection.reflected;
    return true;
  }
};

/// Returns a pixel's expected value; negative: it shows the mesh's silhouette.
double returned(const RenderScene& scene, const View& view, const Shader& shader, int x, int y) {
  constexpr int parts = 4;
  double sum = 0.0;
  for (int j = 0; j <= parts; ++j) {
    for (int i = 0; i <= parts; ++i) {
      const Ray ray =
          view.ray(x + static_cast<double>(i) / parts, y + static_cast<double>(j) / parts);
      const Hit hit = scene.rays().closest(ray);
      if (!hit.valid()) return -1.0;
      ReturnedByLobes transport;
      RenderStatistics counts;
      const double weight = (i % parts == 0 ? 0.5 : 1.0) * (j % parts == 0 ? 0.5 : 1.0);
      sum += weight / (parts * parts) *
             static_cast<double>(shader.radiance(ray, hit, 0.0f, transport, counts).y);
    }
  }
  return sum;
}

/// Returns the largest relative difference of a pixel from its expected value.
double worst(const Furnace& f, Method method) {
  const auto scene = scene_of(f);
  const RenderSettings settings = settings_of(method);
  const Camera camera = camera_of(f);
  const View view(camera, side, side);
  const Film film = render_picture(*scene, camera, settings).film;
  ShadingSettings shading{.sky_shadows = true, .sky = settings.sky.get(), .reflections = 16};
  const Shader shader(scene->world(), scene->render_features, scene->rays(), *scene->lighting,
                      shading);
  double most = 0.0;
  int pixels = 0;
  for (int y = 0; y < side; ++y) {
    for (int x = 0; x < side; ++x) {
      const double expected = returned(*scene, view, shader, x, y);
      if (expected < 0.0) continue;
      ++pixels;
      const double found = static_cast<double>(film.radiance[film.index(x, y)].y);
      most = std::max(most, std::abs(found / expected - 1.0));
    }
  }
  EXPECT_GT(pixels, side * side / 4) << f;
  return most;
}

class EveryLobe : public testing::TestWithParam<Lobe> {};

// A pixel of 512 samples, or one within EPS of its mean, differs only by noise.
TEST_P(EveryLobe, ReflectsAsOnAFlatSurface) {
  constexpr double of_samples = 0.02, of_asos = 0.03;
  for (const Mesh mesh : {Mesh::sphere, Mesh::normal_map}) {
    for (const double roughness : {0.0, 0.05, 0.1, 0.2, 0.35, 0.5, 1.0}) {
      // A narrow sheen seen at a grazing angle has too much noise.
      if (GetParam() == Lobe::sheen && mesh == Mesh::sphere && roughness < 0.2) continue;
      const Furnace furnace{GetParam(), mesh, roughness};
      EXPECT_LT(worst(furnace, Method::sobol), of_samples) << furnace;
      EXPECT_LT(worst(furnace, Method::asos), of_asos) << furnace;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(MeshFurnace, EveryLobe,
                         testing::Values(Lobe::dielectric, Lobe::metal, Lobe::clearcoat,
                                         Lobe::sheen, Lobe::transmission));

}  // namespace
}  // namespace asos::test::mesh_furnace_test
