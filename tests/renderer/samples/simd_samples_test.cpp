#include "renderer/samples/simd_samples.h"

#include "renderer/gltf/load.h"
#include "renderer/kernels/surface_kernel.h"
#include "renderer/shading/sky.h"
#include "tests/support/render_picture.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <numbers>
#include <string>
#include <vector>

// The SIMD path for arrays of points, against Shader for single points.

namespace asos::test::plain_samples_test {
namespace {

/// Records Shader's results for one ray.
class OnePoint final : public LightTransport {
 public:
  HandledLights gather(const LightingQuery& point) override {
    mirrors |= point.mirrored != MirroredLights::none;
    lit->add(point, glm::vec3(1.0f));
    return {{}, true};
  }
  void add(const Illumination& /*lit*/, glm::vec3& /*radiance*/,
           RenderStatistics& /*counts*/) override {
    ADD_FAILURE() << "lights are gathered, not added one by one";
  }
  bool reflect(const Reflection& reflection, glm::vec3& /*radiance*/,
               RenderStatistics& /*counts*/) override {
    width = reflection.width;
    reflected += reflection.reflected;
    return true;
  }

  std::unique_ptr<ShadingPoints> lit = std::make_unique<ShadingPoints>();
  glm::vec3 width{-1.0f};
  glm::vec3 reflected{0.0f};  // summed over the layers
  bool mirrors = false;       // some layer does
};

constexpr float tolerance = 1e-5f;

float off(glm::vec3 a, glm::vec3 b) {
  const glm::vec3 d = glm::abs(a - b);
  return std::max({d.x, d.y, d.z});
}

/// Numbers of compared and of special points.
struct Compared {
  int points = 0, mirrored = 0, textured = 0, layered = 0, alone = 0;
};

class Comparison {
 public:
  Comparison(const std::string& source, std::shared_ptr<const Sky> sky)
      : Comparison(load_scene(source).value(), std::move(sky)) {}
  Comparison(Scene&& scene, std::shared_ptr<const Sky> sky) {
    scene_ = prepare(std::move(scene)).value();
    settings_.width = settings_.height = side;
    settings_.sky = std::move(sky);
    view_.emplace(first_camera(scene_->world(), 1.0), side, side);
    shader_.emplace(shader_of(*scene_, settings_, *view_));
    viewer_.emplace(ViewContext::camera(*view_, *shader_));
  }

  /// Compares points that the eye sees, or the same ones as if in reflections, each with a spacing
  /// of its own.
  [[nodiscard]] Compared compare(bool reflected = false) const {
    Compared all;
    SimdSamples plain(*scene_, *viewer_);
    std::vector<Ray> rays;
    std::vector<Hit> hits(static_cast<std::size_t>(side));
    for (int y = 0; y < side; ++y) {
      rays.clear();
      plain.clear();
      for (int x = 0; x < side; ++x) rays.push_back(view_->ray(x + 0.5, y + 0.5));
      scene_->rays().closest(rays, hits, culling_of(settings_));
      std::vector<PixelSpacing> spacings(hits.size(), viewer_->spacing);
      std::vector<ViewedRay> seen;
      for (std::size_t i = 0; i < hits.size(); ++i) {
        seen.push_back(viewer_->viewed(rays[i], hits[i], 0.25f));
        if (!reflected) {
          all.alone +=
              hits[i].valid() && plain.add(i, rays[i], hits[i], 0.25f) != SamplePath::lanes;
          continue;
        }
        spacings[i].right *= 1.0f + 0.1f * static_cast<float>(i);
        spacings[i].perspective = i % 4 != 1;
        seen[i].spacing = &spacings[i];
        seen[i].bounces = static_cast<int>(i % 3);
        seen[i].hides_lights = i % 2 == 0;
        all.alone += hits[i].valid() && plain.add_reflected(i, seen[i]) != SamplePath::lanes;
      }
      if (plain.count() == 0) continue;
      const auto points = std::make_unique<ShadingPoints>();
      EXPECT_TRUE(plain.shade(*points));
      points->count = plain.count();
      std::vector<Pair> pairs(hits.size());
      for (std::size_t i = 0; i < plain.count(); ++i) {
        Pair& pair = pairs[plain.index(i)];
        const ViewedRay& ray = seen[plain.index(i)];
        RenderStatistics counts;
        if (plain.is_top(i)) pair.radiance = shader_->radiance(ray, pair.expected, counts);
        const bool mirrors =
            plain.may_mirror(i) && plain.reflect(i, ray, *points, pair.found, counts);
        plain.set_mirrors(i, mirrors);
        pair.mirrors |= mirrors;
      }
      plain.reflect_skies(*points);
      for (std::size_t i = 0; i < plain.count(); ++i) {
        SCOPED_TRACE("pixel " + std::to_string(plain.index(i)) + ", " + std::to_string(y));
        compare(plain, *points, i, pairs[plain.index(i)], all);
        all.textured += scene_->plain->of(scene_->world(), hits[plain.index(i)].triangle).textured;
      }
    }
    return all;
  }

 private:
  static constexpr int side = 48;

  struct Pair {
    OnePoint expected, found;
    glm::vec3 radiance{0.0f}, summed{0.0f};
    std::size_t layers = 0;  // compared
    bool mirrors = false;
  };

  static void compare(const SimdSamples& plain, const ShadingPoints& points, std::size_t i,
                      Pair& pair, Compared& all) {
    const OnePoint& expected = pair.expected;
    const std::size_t k = pair.layers++;
    const glm::vec3 share = plain.share(i);
    pair.summed += share * plain.unlit_radiance(i, points);
    ++all.points;
    if (expected.lit->count == 0) return;  // an unlit surface
    ASSERT_LT(k, expected.lit->count);
    const ShadingPoints& one = *expected.lit;
    EXPECT_EQ(points.position.at(i), one.position.at(k));
    EXPECT_EQ(points.geometric.at(i), one.geometric.at(k));
    EXPECT_LT(off(points.normal.at(i), one.normal.at(k)), tolerance);
    EXPECT_LT(off(points.to_viewer.at(i), one.to_viewer.at(k)), tolerance);
    EXPECT_EQ(points.clear_height[i], one.clear_height[k]);
    EXPECT_LT(off(share * points.diffuse.at(i), one.diffuse.at(k)), tolerance);
    EXPECT_LT(off(share * points.f0.at(i), one.f0.at(k)), tolerance);
    EXPECT_LT(off(share * points.f90_less_f0.at(i), one.f90_less_f0.at(k)), tolerance);
    EXPECT_NEAR(points.alpha[i], one.alpha[k], tolerance);
    EXPECT_EQ(points.shows_lights[i], one.shows_lights[k]);
    EXPECT_EQ(points.turns[i], one.turns[k]);
    EXPECT_EQ(points.sheen[i], one.sheen[k]);
    if (one.turns[k] > 0.0f) {
      const float patch = glm::length(one.patch_right.at(k)) + glm::length(one.patch_down.at(k));
      EXPECT_LE(off(points.patch_right.at(i), one.patch_right.at(k)), tolerance * patch);
      EXPECT_LE(off(points.patch_down.at(i), one.patch_down.at(k)), tolerance * patch);
      EXPECT_LT(off(points.stretch.at(i), one.stretch.at(k)), tolerance);
      EXPECT_LT(off(points.spread_right.at(i), one.spread_right.at(k)), tolerance);
      EXPECT_LT(off(points.spread_down.at(i), one.spread_down.at(k)), tolerance);
      EXPECT_NEAR(points.spread_variance[i], one.spread_variance[k], tolerance);
      EXPECT_NEAR(points.viewer_nearness[i], one.viewer_nearness[k], tolerance);
    }
    if (pair.layers < one.count) return;
    EXPECT_LT(off(pair.summed, pair.radiance), tolerance);
    EXPECT_EQ(pair.mirrors, expected.mirrors);
    EXPECT_LT(off(pair.found.width, expected.width), tolerance);
    EXPECT_LT(off(pair.found.reflected, expected.reflected), tolerance);
    all.mirrored += pair.mirrors;
    all.layered += one.count > 1;
  }

  std::shared_ptr<const RenderScene> scene_;
  RenderSettings settings_;
  std::optional<View> view_;
  std::optional<Shader> shader_;
  std::optional<ViewContext> viewer_;
};

TEST(SimdSamples, AreTheOnesShadedOneByOne) {
  const Compared found = Comparison("builtin:boxes", nullptr).compare();
  EXPECT_GT(found.points, 500);
  EXPECT_EQ(found.alone, 0);
}

TEST(SimdSamples, MirrorWhatShaderMirrors) {
  const Compared found = Comparison("builtin:office-metal", nullptr).compare();
  EXPECT_GT(found.points, 500);
  EXPECT_GT(found.mirrored, 50);
}

TEST(SimdSamples, HaveTheirTexturesAndMapsOfNormals) {
  for (const char* source : {"builtin:house-textured", "builtin:workshop"}) {
    SCOPED_TRACE(source);
    const Compared found = Comparison(source, nullptr).compare();
    EXPECT_GT(found.textured, 200);
  }
}

/// The scene with this change of all its materials.
template <typename Change>
Scene changed(const char* source, const Change& change) {
  Scene scene = load_scene(source).value();
  for (Material& material : scene.materials) change(material);
  return scene;
}

void coat(Material& m) {
  m.coat.factor = 0.8f;
  m.coat.roughness = 0.15f;
}
void sheen(Material& m) {
  m.sheen.color = {0.7f, 0.4f, 0.9f};
  m.sheen.roughness = 0.5f;
}
void film(Material& m) {
  m.film.factor = 1.0f;
  m.film.thickness_max_nm = 420.0f;
}
void brush(Material& m) {
  m.roughness = 0.3f;
  m.anisotropy.strength = 0.8f;
}
void let_through(Material& m) {
  m.diffuse_transmission.factor = 0.6f;
  m.diffuse_transmission.color = {0.9f, 0.5f, 0.2f};
}
void all_layers(Material& m) {
  coat(m), sheen(m), film(m), let_through(m);
}

TEST(SimdSamples, HaveTheLayersOfShader) {
  for (const auto& change : {coat, sheen, film, brush, let_through, all_layers}) {
    for (const char* source : {"builtin:house-textured", "builtin:office-metal"}) {
      SCOPED_TRACE(source);
      const auto sky = std::make_shared<const Sky>(Environment::softboxes);
      const Compared found = Comparison(changed(source, change), sky).compare();
      EXPECT_GT(found.points, 500);
      EXPECT_EQ(found.alone, 0);
    }
  }
  EXPECT_GT(Comparison(changed("builtin:boxes", all_layers), nullptr).compare().layered, 500);
}

TEST(SimdSamples, HaveTheNormalMapsOfCoats) {
  const auto mapped_coat = [](Material& m) {
    all_layers(m);
    if (m.normal_texture.used()) m.coat.normal_texture = m.normal_texture;
    m.coat.normal_texture.scale *= -0.5f;
  };
  const Compared found = Comparison(changed("builtin:workshop", mapped_coat), nullptr).compare();
  EXPECT_GT(found.layered, 500);
}

TEST(SimdSamples, InReflectionsAreTheOnesShadedOneByOne) {
  for (const char* source : {"builtin:office-metal", "builtin:house-textured"}) {
    SCOPED_TRACE(source);
    const auto sky = std::make_shared<const Sky>(Environment::softboxes);
    EXPECT_GT(Comparison(source, sky).compare(true).points, 500);
  }
}

TEST(SimdSamples, ReflectSkiesOfAllKinds) {
  for (const auto& sky :
       {std::make_shared<const Sky>(glm::vec3(0.4f, 0.6f, 1.0f)),
        std::make_shared<const Sky>(glm::vec3(0.2f, 0.5f, 1.0f), glm::vec3(0.9f, 0.9f, 0.7f)),
        std::make_shared<const Sky>(Environment::softboxes)}) {
    SCOPED_TRACE(sky->name());
    EXPECT_GT(Comparison("builtin:boxes", sky).compare().points, 500);
  }
}

}  // namespace
}  // namespace asos::test::plain_samples_test
