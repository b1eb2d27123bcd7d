#include "renderer/film/layers.h"
#include "renderer/gltf/load.h"
#include "renderer/shading/sky.h"
#include "tests/renderer/comparison/rival_scenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

// The layers of light: emission, direct light, reflection, transmission and background.

namespace asos::test::light_layers_test {
namespace {

constexpr LayerSet light_layers{Layer::direct, Layer::emission, Layer::reflection,
                                Layer::transmission, Layer::background};

/// The largest difference of a pixel's radiance from the sum of its parts, relative to 1 or to a
/// brighter pixel.
double largest_difference(const Film& film) {
  double most = 0.0;
  for (std::size_t i = 0; i < film.radiance.size(); ++i) {
    glm::dvec3 sum(0.0);
    for (const Layer layer : light_layers.layers()) {
      const auto part = find_plane(film.layers, layer)->at(i);
      sum += glm::dvec3(part[0], part[1], part[2]);
    }
    const glm::dvec3 whole(film.radiance[i]);
    const glm::dvec3 off = glm::abs(sum - whole) / glm::max(glm::dvec3(1.0), whole);
    most = std::max({most, off.x, off.y, off.z});
  }
  return most;
}

/// The mean of a layer over a picture and its colours; of bright pixels 1.
double mean_of(const Film& film, Layer layer) {
  double sum = 0.0;
  const std::vector<float>& values = find_plane(film.layers, layer)->values;
  for (const float value : values) sum += std::min(1.0, static_cast<double>(value));
  return sum / static_cast<double>(values.size());
}

// Every built-in scene with other materials or lights; the sum of a picture's light.
TEST(LightLayers, AddUpToTheRadiance) {
  for (const char* name : {"solids", "glass", "workshop", "neon", "office-metal", "foliage"}) {
    const auto scene =
        with_boundaries(prepare(load_scene(std::string("builtin:") + name).value()).value())
            .value();
    const Camera camera = first_camera(scene->world(), 1.5);
    for (const Method method : {Method::asos, Method::sobol}) {
      RenderSettings settings = settings_for(method, 4);
      settings.width = 12, settings.height = 8;
      settings.asos.max_level = 1;
      settings.background.kind = BackgroundKind::colours;
      settings.layers = light_layers;
      const Film film = render_picture(*scene, camera, settings).film;
      EXPECT_LT(largest_difference(film), 1e-5) << name << " by " << row_of(method).name;
    }
  }
}

// Leaves that share samples of the sky show the fit in their layers, too.
TEST(LightLayers, AddUpUnderAnOccludedSky) {
  const auto scene = with_boundaries(prepare(load_scene("builtin:boxes").value()).value()).value();
  RenderSettings settings = test::settings_for(Method::asos, 4);
  settings.width = 24, settings.height = 16;
  settings.shadow.sky = true;
  settings.layers = light_layers;
  const Film film =
      test::render_picture(*scene, test::first_camera(scene->world(), 1.5), settings).film;
  EXPECT_LT(largest_difference(film), 1e-5);
}

// Both methods divide the light of a picture in the same way.
TEST(LightLayers, AreTheSameByRaysAndByPyrays) {
  for (const char* name : {"solids", "glass"}) {
    const auto scene =
        with_boundaries(prepare(load_scene(std::string("builtin:") + name).value()).value())
            .value();
    const Camera camera = first_camera(scene->world(), 1.5);
    RenderSettings settings = settings_for(Method::asos, 64);
    settings.width = 24, settings.height = 16;
    settings.asos.max_level = 3;
    settings.layers = light_layers;
    const Film exact = render_picture(*scene, camera, settings).film;
    settings.method = Method::sobol;
    const Film sampled = render_picture(*scene, camera, settings).film;
    for (const Layer layer : light_layers.layers())
      EXPECT_NEAR(mean_of(exact, layer), mean_of(sampled, layer), 3e-3)
          << name << ": " << row_of(layer).name;
    EXPECT_GT(mean_of(exact, Layer::reflection), 5e-3) << name;
  }
}

/// A picture of one card that fills it, lit by the sky alone.
Film picture_of_card(const Material& material, Method method) {
  World world;
  add_card(world, {-9, -9}, {17, 17}, material);
  const auto scene = make_render_scene(std::move(world));
  RenderSettings settings = settings_for(method, 4);
  settings.sky = std::make_shared<const Sky>(glm::vec3(0.5f));
  settings.layers = light_layers;
  return render_picture(*scene, orthographic(8.0), settings).film;
}

glm::vec3 light_at(const Film& film, Layer layer) {
  const auto values = find_plane(film.layers, layer)->at(8 * 3 + 4);
  return {values[0], values[1], values[2]};
}

TEST(LightLayers, EmissionIsThatOfTheSurface) {
  for (const Method method : {Method::asos, Method::sobol}) {
    Material lamp = matte(glm::vec3(0.5f));
    lamp.emissive = {2.0f, 1.0f, 0.25f};
    const Film film = picture_of_card(lamp, method);
    EXPECT_EQ(light_at(film, Layer::emission), lamp.emissive);
    EXPECT_GT(light_at(film, Layer::direct).y, 0.1f) << "by the sky";
    EXPECT_EQ(light_at(film, Layer::background), glm::vec3(0.0f));
    EXPECT_LT(largest_difference(film), 1e-6);
    // An unlit surface shows its colour by itself.
    const Film unlit = picture_of_card(test::unlit(glm::vec3(0.7f)), method);
    EXPECT_EQ(light_at(unlit, Layer::emission), unlit.radiance[8 * 3 + 4]);
    EXPECT_EQ(light_at(unlit, Layer::direct), glm::vec3(0.0f));
  }
}

TEST(LightLayers, MirrorShowsNothingElse) {
  Material mirror = matte(glm::vec3(1.0f));
  mirror.metallic = 1.0f, mirror.roughness = 0.0f;
  Material rough = mirror;
  rough.roughness = 0.3f;
  for (const Method method : {Method::asos, Method::sobol})
    for (const Material& metal : {mirror, rough}) {
      const Film film = picture_of_card(metal, method);
      EXPECT_GT(light_at(film, Layer::reflection).x, 0.4f);
      EXPECT_NEAR(light_at(film, Layer::direct).x, 0.0f, 1e-6f);
      EXPECT_EQ(light_at(film, Layer::transmission), glm::vec3(0.0f));
      EXPECT_LT(largest_difference(film), 1e-6);
    }
}

TEST(LightLayers, GlassTransmitsWhatItDoesNotReflect) {
  Material glass = matte(glm::vec3(1.0f));
  glass.roughness = 0.2f, glass.transmission = 1.0f;
  for (const Method method : {Method::asos, Method::sobol}) {
    const Film film = picture_of_card(glass, method);
    EXPECT_GT(light_at(film, Layer::transmission).x, 0.3f);
    EXPECT_GT(light_at(film, Layer::reflection).x, 0.0f);
    EXPECT_LT(light_at(film, Layer::reflection).x, 0.1f);
    EXPECT_LT(largest_difference(film), 1e-6);
  }
}

// A card covers half of the pixel.
TEST(LightLayers, BackgroundCountsByItsArea) {
  World world;
  add_card(world, {-9, -9}, {4.5, 17}, unlit(glm::vec3(0.25f)));
  const auto scene = make_render_scene(std::move(world));
  RenderSettings settings = settings_for(Method::asos);
  settings.background.kind = BackgroundKind::colours;
  settings.background.top = settings.background.bottom = glm::vec3(0.8f);
  settings.layers = light_layers;
  const Film film = render_picture(*scene, orthographic(8.0), settings).film;
  EXPECT_NEAR(light_at(film, Layer::background).x, 0.4f, 1e-5f);
  EXPECT_NEAR(light_at(film, Layer::emission).x, 0.125f, 1e-5f);
}

}  // namespace
}  // namespace asos::test::light_layers_test
