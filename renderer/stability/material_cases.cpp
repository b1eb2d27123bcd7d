#include "renderer/scene/make_light.h"
#include "renderer/stability/case.h"
#include "renderer/stability/closed_forms.h"
#include "renderer/stability/picture.h"
#include "renderer/stability/scenes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <string>
#include <vector>

// Materials with unintended factors, overflowing light, and endless layers.

namespace asos::stability {
namespace {

constexpr const char* material_group = "materials";

/// A wall of a material that fills the picture, under one lux from the camera's side.
Scene wall(const Material& material) {
  Scene scene = scene_of({}, look_at({0, 0, 4}, {0, 0, 0}, 50.0));
  place(scene, mesh_of({{-9, -9, 0}, {9, -9, 0}, {9, 9, 0}, {-9, 9, 0}}), material);
  scene.lights.push_back(make_sun({0, 0, -1}));
  return scene;
}

/// A scene whose samples are all not finite: they are dropped and counted, and pixels are black.
Case overflowing(const std::string& name, const std::function<Scene()>& make) {
  return {name, material_group, true, [make] {
            return one_value(
                {"pixels of 64 that are black, with samples counted as dropped", 0.0,
                 "samples that are not finite are left out of their pixel and counted; a pixel "
                 "without any other is black"},
                64.0, render(make(), settings_of(small_side, small_side)), [](const Picture& p) {
                  if (p.statistics.rejected_samples < p.film.radiance.size()) return 0.0;
                  return static_cast<double>(
                      std::count(p.film.radiance.begin(), p.film.radiance.end(), glm::vec3(0.0f)));
                });
          }};
}

void add_overflow(std::vector<Case>& cases) {
  cases.push_back(
      overflowing("a colour that is not a number", [] { return wall(unlit(not_a_number)); }));
  cases.push_back(overflowing("an infinite colour", [] { return wall(unlit(infinite)); }));
  cases.push_back(overflowing("emission that overflows float32", [] {
    Material material = matte(0.5f);
    material.emissive = glm::vec3(1e30f);
    material.emissive_strength = 1e30f;
    return wall(material);
  }));
  cases.push_back(overflowing("light times colour that overflows float32", [] {
    Scene scene = wall(matte(1e30f));
    scene.lights[0].intensity = 1e30f;
    return scene;
  }));
  cases.push_back(overflowing("vertex colours that are not numbers", [] {
    Scene scene = wall(unlit(1.0f));
    scene.meshes[0].colors.assign(4, glm::vec4(not_a_number));
    return scene;
  }));
  cases.push_back({"a light that is not a number gives nothing", material_group, true, [] {
                     Scene scene = wall(matte(0.5f));
                     const auto lit = render(scene, settings_of(small_side, small_side));
                     scene.lights.push_back(scene.lights[0]);
                     scene.lights[1].intensity = not_a_number;
                     return one_value({"pixels that are black or as without that light", 0.0,
                                       "a sample that is not finite is dropped and counted, and "
                                       "never shown"},
                                      64.0, render(scene, settings_of(small_side, small_side)),
                                      [&](const Picture& p) {
                                        int sound = 0;
                                        for (int i = 0; lit && i < small_side * small_side; ++i) {
                                          const double got = p.at(i % small_side, i / small_side);
                                          sound += got == 0.0 ||
                                                   got == lit->at(i % small_side, i / small_side);
                                        }
                                        return static_cast<double>(sound);
                                      });
                   }});
}

/// Compares a material under the sky alone with the fraction of light that it reflects.
Case under_sky(const std::string& name, const Material& material, double share,
               const Measure& measure, double fov_deg = 50.0) {
  return {name, material_group, true, [=] {
            Scene scene = wall(material);
            scene.lights[0].direction = {0, 0, 1};
            scene.materials[0].double_sided = true;
            scene.cameras[0] = look_at({0, 0, 4}, {0, 0, 0}, fov_deg);
            const double sky = 0.6 * background;
            return worst_pixel(measure, render(scene, settings_of(small_side, small_side)),
                               [=](int, int) { return share * sky; });
          }};
}

// Smooth white metal reflects the whole sky.
Case mirrors_sky(std::string name, const Material& material) {
  return {std::move(name), material_group, true, [material] {
            Scene scene = wall(material);
            scene.lights[0].direction = {0, 0, 1};
            scene.materials[0].double_sided = true;
            return worst_pixel({"radiance of the worst of 8x8 pixels", 16.0 * rounding,
                                "all of the sky's light, 0.35, but for rounding"},
                               render(scene, settings_of(small_side, small_side)),
                               [](int, int) { return background; });
          }};
}

void add_factors(std::vector<Case>& cases) {
  for (const float roughness : {0.0f, 1e-20f, 1.0f}) {
    Material material = matte(1.0f);
    material.roughness = roughness;
    material.metallic = 1.0f;
    const std::string name = fmt::format("metal of roughness {:g}", roughness);
    if (roughness < 0.5f) {
      cases.push_back(mirrors_sky(name, material));
      continue;
    }
    cases.push_back(under_sky(name, material, 1.0 - std::numbers::ln2,
                              {"radiance of the worst of 8x8 pixels", 2e-3 * 0.6 * background,
                               "the integral of the lobe at a right angle is 1 - ln 2 of the sky's "
                               "light, 0.6 of 0.35; the table's steps"},
                              0.5));
  }
  for (const float ior : {0.0f, 1.0f, 1e9f}) {
    Material material = matte(1.0f);
    material.specular = 1.0f;
    material.ior = ior;
    cases.push_back(under_sky(fmt::format("an index of refraction of {:g}", ior), material, 1.0,
                              {"radiance of the worst of 8x8 pixels", 16.0 * rounding,
                               "white matter under gloss returns all of the sky's light, 0.6 of "
                               "0.35, but for rounding"}));
  }
  cases.push_back({"grazing light on a grazing view of metal", material_group, true, [] {
                     Material metal = matte(1.0f);
                     metal.metallic = 1.0f;
                     metal.roughness = 0.0f;
                     Scene scene = wall(metal);
                     scene.lights[0].direction = glm::normalize(glm::dvec3(1, 0, -1e-7));
                     scene.cameras[0] = look_at({-4, 0, 1e-3}, {0, 0, 0}, 20.0);
                     return one_value({"pixels of 64 that are finite and not below 0", 0.0,
                                       "light is finite and not negative"},
                                      64.0, render(scene, settings_of(small_side, small_side)),
                                      [](const Picture& p) {
                                        return static_cast<double>(std::count_if(
                                            p.film.radiance.begin(), p.film.radiance.end(),
                                            [](glm::vec3 c) { return c.x >= 0.0f && c.x < 1e9f; }));
                                      });
                   }});
}

/// `count` unlit layers of the same opacity before the background.
Case layers(const std::string& name, int count, float opacity, AlphaMode mode, double expected,
            const Measure& measure) {
  return {name, material_group, true, [=] {
            Scene scene = scene_of({}, look_at({0, 0, 4}, {0, 0, 0}, 50.0));
            Material material = unlit(1.0f);
            material.base_color.a = opacity;
            material.alpha_mode = mode;
            for (int i = 0; i < count; ++i) {
              const double z = -0.01 * i;
              place(scene, mesh_of({{-9, -9, z}, {9, -9, z}, {9, 9, z}, {-9, 9, z}}), material);
            }
            return worst_pixel(measure, render(scene, settings_of(small_side, small_side)),
                               [expected](int, int) { return expected; });
          }};
}

void add_layers(std::vector<Case>& cases) {
  const Measure exact{"radiance of the worst of 8x8 pixels", 64.0 * rounding,
                      "64 roundings of a sum of layers"};
  cases.push_back(layers("1000 layers of opacity 1/2", 1000, 0.5f, AlphaMode::blend, 1.0,
                         {"radiance of the worst of 8x8 pixels", 1.0 / 65536.0 + 64.0 * rounding,
                          "what lies behind layers that leave 2^-16 is dropped"}));
  cases.push_back(layers("40 layers of opacity 1/128", 40, 0.0078125f, AlphaMode::blend,
                         1.0 - 0.65 * std::pow(1.0 - 0.0078125, 40), exact));
  cases.push_back(layers("a layer of opacity 0", 1, 0.0f, AlphaMode::blend, background, exact));
  cases.push_back(layers("a blended layer of opacity 1", 1, 1.0f, AlphaMode::blend, 1.0, exact));
  cases.push_back(layers("a cut-out exactly at its cut-off", 1, 0.5f, AlphaMode::mask, 1.0, exact));
  cases.push_back(layers("a cut-out just below its cut-off", 1, std::nextafter(0.5f, 0.0f),
                         AlphaMode::mask, background, exact));
}

}  // namespace

std::vector<Case> material_cases() {
  std::vector<Case> cases;
  add_overflow(cases);
  add_factors(cases);
  add_layers(cases);
  return cases;
}

}  // namespace asos::stability
