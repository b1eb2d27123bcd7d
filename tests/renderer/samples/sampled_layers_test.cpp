#include "renderer/gltf/load.h"
#include "renderer/samples/sample_block.h"
#include "renderer/samples/sample_sums.h"
#include "renderer/shading/sky.h"
#include "tests/support/make_light.h"
#include "tests/support/make_settings.h"
#include "tests/support/render_picture.h"

#include <gtest/gtest.h>

#include <array>
#include <memory>
#include <utility>

// Pictures by batches of samples, against Shader for single rays. Lights have no extent and no
// shadows, and reflections are not followed, so that both are without noise.

namespace asos::test::sampled_layers_test {
namespace {

class OnlyShader final : public LightTransport {
 public:
  void add(const Illumination& /*lit*/, glm::vec3& /*radiance*/,
           RenderStatistics& /*counts*/) override {
    ADD_FAILURE() << "no light casts shadows";
  }
};

constexpr int side = 32;

struct Pictures {
  double farthest = 0.0;  ///< largest difference in any pixel
  RenderStatistics counts;

  [[nodiscard]] std::uint64_t by(SamplePath path) const {
    return counts.samples_by_path[static_cast<std::size_t>(path)];
  }
};

/// Compares one sample per pixel with its ray.
Pictures compared(Scene&& scene) {
  for (Light& light : scene.lights) light.casts_shadows = false;
  const auto prepared = prepare(std::move(scene)).value();
  RenderSettings settings = make_settings(side, side);
  settings.mirror.bounces = 0;
  settings.shadow.cast = false;
  settings.sky = std::make_shared<const Sky>(Environment::softboxes);
  const View view(first_camera(prepared->world(), 1.0), side, side);
  GridSampler places(1, false);
  SampleSums sums(*prepared, view, settings, places);
  sums.resize(side * side);
  const Shader shader = shader_of(*prepared, settings, view);
  for (int y = 0; y < side; ++y) {
    for (int x = 0; x < side; ++x) {
      PointSample sample{.at = {x + 0.5, y + 0.5}, .side = 0.5f};
      sample.x = x, sample.y = y;
      sample.target = static_cast<std::size_t>(y * side + x);
      sums.add(sample);
    }
  }
  sums.trace();
  Pictures found;
  for (int y = 0; y < side; ++y) {
    for (int x = 0; x < side; ++x) {
      const Ray ray = view.ray(x + 0.5, y + 0.5);
      OnlyShader none;
      RenderStatistics counts;
      const Hit hit = prepared->rays().closest(ray, culling_of(settings));
      const glm::vec3 expected = shader.radiance(ray, hit, 0.5f, none, counts);
      const SampleSums::Sum sum = sums.sum(static_cast<std::size_t>(y * side + x));
      EXPECT_EQ(sum.count, 1u);
      found.farthest = std::max(found.farthest, glm::length(sum.mean() - glm::dvec3(expected)));
    }
  }
  found.counts = sums.statistics();
  return found;
}

/// A scene with this change of all its materials, in the light of a distant point.
template <typename Change>
Scene lit(const char* source, const Change& change) {
  Scene scene = load_scene(source).value();
  for (Material& material : scene.materials) {
    material.emissive = glm::vec3(0.0f);
    change(material);
  }
  const Light light = make_sun(glm::normalize(glm::dvec3(-1.0, -2.0, -1.5)), 2.0f);
  scene.lights = {light};
  return scene;
}

void blend(Material& m) {
  m.alpha_mode = AlphaMode::blend;
  m.base_color.a = 0.4f;
}
void blend_coated(Material& m) {
  blend(m);
  m.coat.factor = 0.7f;
  m.sheen.color = {0.5f, 0.2f, 0.6f};
}
void transmit(Material& m) {
  m.transmission = 0.8f;
  m.roughness = 0.0f;
}
void blend_unlit(Material& m) {
  blend(m);
  m.unlit = true;
}
void clear(Material& m) {
  blend(m);
  m.base_color.a = 0.0f;
}

void fill(Material& m) {
  transmit(m);
  m.roughness = 0.2f;
  m.volume.thickness = 0.2f;
  m.volume.attenuation_color = {0.3f, 0.8f, 0.5f};
  m.volume.attenuation_distance = 0.7f;
}

constexpr double rounding = 1e-5;

TEST(SampledLayers, AreThoseOfShader) {
  for (const auto& change : {blend, blend_coated, transmit, blend_unlit, fill}) {
    for (const char* source : {"builtin:boxes", "builtin:house-textured", "builtin:park"}) {
      SCOPED_TRACE(source);
      const Pictures found = compared(lit(source, change));
      EXPECT_LT(found.farthest, rounding);
      EXPECT_GT(found.by(SamplePath::lanes), side * side / 3);
      EXPECT_EQ(found.by(SamplePath::blended), 0u);
    }
  }
}

TEST(SampledLayers, OfOpacityZeroAreInvisible) {
  const Pictures found = compared(lit("builtin:boxes", clear));
  EXPECT_LT(found.farthest, rounding);
  EXPECT_GT(found.by(SamplePath::lanes), 0u);
}

TEST(SampledLayers, OfLitScenesWithoutShadowsAreInLanes) {
  const Pictures found = compared(lit("builtin:house-textured", [](Material&) {}));
  EXPECT_LT(found.farthest, rounding);
  EXPECT_GT(found.by(SamplePath::lanes), side * side / 2);
  EXPECT_EQ(found.by(SamplePath::lanes) + found.by(SamplePath::background), side * side);
}

TEST(SampledLayers, AreCountedByTheReasonAgainstLanes) {
  const Pictures shapes = compared(lit("builtin:solids", [](Material&) {}));
  EXPECT_GT(shapes.by(SamplePath::face), 0u);
}

}  // namespace
}  // namespace asos::test::sampled_layers_test
