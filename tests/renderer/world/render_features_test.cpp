#include "renderer/world/render_features.h"

#include "renderer/lights/lighting.h"
#include "tests/support/shape_world.h"
#include "tests/support/tiny_image.h"
#include "tests/support/tiny_world.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <set>
#include <string>

namespace asos {
namespace {

/// A matte, double-sided triangle without light.
World plain() {
  World world;
  Material material = test::matte(glm::vec3(0.5f));
  material.double_sided = true;
  test::add_triangle(world, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, material);
  return world;
}

Image image_of(int side) {
  return test::make_image(side, side, [](int, int) { return test::Texel{200, 100, 50, 255}; });
}

int add_texture(World& world, int side) {
  return test::add_texture(world, image_of(side), Wrap::repeat, Filter::linear);
}

Light light_of(Light::Type type, double radius = 0.0, double angular_diameter_rad = 0.0) {
  return {.type = type, .radius = radius, .angular_diameter_rad = angular_diameter_rad};
}

/// The features of a plain world: those that the world alone cannot exclude.
RenderFeatures least_needs() {
  return {.unused_images = true, .boundaries = true, .intersections = true};
}

std::set<std::string> beyond_least(const RenderFeatures& render_features) {
  std::set<std::string> names;
  for (const RenderFeature& feature : render_feature_list()) {
    if (render_features.*feature.needed && !(least_needs().*feature.needed))
      names.insert(feature.name);
  }
  return names;
}

/// The features that a change of a plain world adds.
std::set<std::string> added_by(const std::function<void(World&)>& change) {
  World world = plain();
  change(world);
  return beyond_least(find_render_features(world));
}

std::set<std::string> added_by_material(const std::function<void(Material&)>& change) {
  return added_by([&](World& world) { change(world.materials.front()); });
}

std::set<std::string> added_by_light(const Light& light) {
  return beyond_least(find_render_features({&light, 1}));
}

using Names = std::set<std::string>;

TEST(Needs, APlainWorldNeedsNothing) {
  EXPECT_EQ(find_render_features(plain()), least_needs());
}

TEST(Needs, EachMaterialsPropertyAsksForItsOwnFeaturesOnly) {
  EXPECT_EQ(added_by_material([](Material& m) { m.metallic = 0.5f; }), Names{"metals"});
  EXPECT_EQ(added_by_material([](Material& m) {
              m.emissive = {0, 0, 1};
            }),
            Names{"emissive materials"});
  EXPECT_EQ(added_by_material([](Material& m) { m.double_sided = false; }),
            Names{"culling of backs"});
  EXPECT_EQ(added_by_material([](Material& m) { m.alpha_mode = AlphaMode::mask; }),
            Names{"alpha cut-outs"});
  EXPECT_EQ(added_by_material([](Material& m) { m.alpha_mode = AlphaMode::blend; }),
            Names{"alpha blending and transmission"});
  EXPECT_EQ(added_by_material([](Material& m) { m.transmission = 0.5f; }),
            (Names{"alpha blending and transmission", "mirrors"}));
  EXPECT_EQ(added_by_material([](Material& m) {
              m.transmission = 0.5f;
              m.unlit = true;
            }),
            Names{"alpha blending and transmission"});
  EXPECT_EQ(added_by_material([](Material& m) { m.roughness = 0.35f; }), Names{"mirrors"});
  EXPECT_EQ(added_by_material([](Material& m) { m.roughness = 0.36f; }), Names{});
  EXPECT_EQ(added_by_material([](Material& m) { m.dfr = Dfr{}; }), Names{"mirrors"});
  EXPECT_EQ(added_by_material([](Material& m) {
              m.roughness = 0.0f;
              m.specular = 0.0f;
            }),
            Names{})
      << "it reflects nothing";
  EXPECT_EQ(added_by_material([](Material& m) {
              m.emissive = {1, 1, 1};
              m.emissive_strength = 0.0f;
            }),
            Names{});
  EXPECT_EQ(added_by_material([](Material& m) {
              m.unlit = true;
              m.metallic = 1.0f;
              m.emissive = {1, 1, 1};
            }),
            Names{})
      << "unlit materials show their base colour alone";
}

TEST(Needs, TexturesAskForMipChainsWhereTheyHaveTexels) {
  const auto with_base = [](int side, AlphaMode mode) {
    return added_by([=](World& world) {
      world.materials[0].base_color_texture.texture = add_texture(world, side);
      world.materials[0].alpha_mode = mode;
    });
  };
  EXPECT_EQ(with_base(1, AlphaMode::opaque), Names{"textures"});
  EXPECT_EQ(with_base(2, AlphaMode::opaque), (Names{"textures", "mip chains"}));
  EXPECT_EQ(with_base(2, AlphaMode::mask),
            (Names{"textures", "mip chains", "alpha cut-outs", "varying opacity"}));
  EXPECT_EQ(added_by([](World& world) {
              world.materials[0].normal_texture.texture = add_texture(world, 4);
            }),
            (Names{"textures", "mip chains", "normal maps"}));
}

TEST(Needs, ATextureOfRoughnessMayMakeAMirror) {
  EXPECT_EQ(added_by([](World& world) {
              world.materials[0].metallic_roughness_texture.texture = add_texture(world, 1);
            }),
            (Names{"textures", "mirrors"}));
}

TEST(Needs, ShapesAreToldFromMeshes) {
  EXPECT_EQ(added_by([](World& world) {
              Material material = test::matte(glm::vec3(0.5f));
              material.double_sided = true;
              test::add_shape(world, test::sphere(1.0), glm::dmat4(1.0), material);
            }),
            Names{"analytic shapes"});
}

TEST(Needs, ImagesThatNothingShowsAreReleased) {
  World world = plain();
  world.materials[0].base_color_texture.texture = add_texture(world, 4);
  EXPECT_TRUE(find_render_features(world).unused_images);
  add_texture(world, 8);
  Material hidden{.base_color_texture = {.texture = 1}};
  world.materials.push_back(hidden);  // used by no part
  EXPECT_FALSE(find_render_features(world).unused_images);
  release_unused_images(world);
  EXPECT_EQ(world.images[0].rgba.size(), 64u);
  EXPECT_TRUE(world.images[1].rgba.empty());
  EXPECT_EQ(world.images[1].width, 8);
}

TEST(Needs, OpacityVariesWithTheColoursOfAPart) {
  const auto varies = [](float last_alpha, AlphaMode mode) {
    World world = plain();
    world.colors.assign(3, glm::vec4(0.5f));
    world.colors.back().a = last_alpha;
    world.materials[0].alpha_mode = mode;
    return find_render_features(world).varying_opacity;
  };
  EXPECT_FALSE(varies(0.5f, AlphaMode::blend));
  EXPECT_TRUE(varies(0.25f, AlphaMode::blend));
  EXPECT_TRUE(varies(0.25f, AlphaMode::mask));
  EXPECT_FALSE(varies(0.25f, AlphaMode::opaque));
}

TEST(Needs, EachKindOfLightIsToldApart) {
  using Type = Light::Type;
  const Names hard{"punctual lights", "shadows"};
  EXPECT_EQ(added_by_light(light_of(Type::point)), hard);
  EXPECT_EQ(added_by_light(light_of(Type::spot)), hard);
  EXPECT_EQ(added_by_light(light_of(Type::directional)), hard);
  const auto soft = [](const char* kind) { return Names{kind, "shadows", "soft shadows"}; };
  EXPECT_EQ(added_by_light(light_of(Type::point, 0.5)), soft("ball lights"));
  EXPECT_EQ(added_by_light(light_of(Type::spot, 0.5)), soft("ball lights"));
  EXPECT_EQ(added_by_light(light_of(Type::directional, 0.0, 0.01)), soft("suns"));
  EXPECT_EQ(added_by_light(light_of(Type::linear)), soft("linear lights"));
  EXPECT_EQ(added_by_light(light_of(Type::disk, 1.0)), soft("disk lights"));
  EXPECT_EQ(added_by_light(light_of(Type::rectangle)), soft("rectangular and polygonal lights"));
  EXPECT_EQ(added_by_light(light_of(Type::polygon)), soft("rectangular and polygonal lights"));
  Light shadowless = light_of(Type::disk, 1.0);
  shadowless.casts_shadows = false;
  EXPECT_EQ(added_by_light(shadowless), Names{"disk lights"});
}

TEST(Needs, MaterialsThatNoTriangleShowsDoNotCount) {
  EXPECT_EQ(added_by([](World& world) {
              Material hidden{.alpha_mode = AlphaMode::blend};
              world.materials.push_back(hidden);
            }),
            Names{});
}

TEST(Needs, EveryFeatureIsNamedOnceWithAReason) {
  Names names;
  for (const RenderFeature& feature : render_feature_list()) {
    EXPECT_TRUE(names.insert(feature.name).second) << feature.name;
    EXPECT_NE(std::string(feature.reason), "") << feature.name;
  }
  EXPECT_EQ(RenderFeatures{}.left_out().size(), render_feature_list().size());
  EXPECT_EQ(features_left_out(RenderFeatures::all()).size(), 2u);
  RenderFeatures not_forced{.varying_opacity = true, .sky_picture = true};
  EXPECT_TRUE(not_forced.with(RenderFeatures::all()).left_out().empty());
  const std::vector<std::string> left_out = find_render_features(plain()).left_out();
  EXPECT_NE(std::find(left_out.begin(), left_out.end(),
                      "normal maps (no material that is shown has a normal map; stages: turning of "
                      "normals by maps; memory: tangents, normal maps' mip chains)"),
            left_out.end());
}

}  // namespace
}  // namespace asos
