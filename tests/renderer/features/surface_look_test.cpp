#include "renderer/features/surface_look.h"

#include "renderer/features/feature_set.h"
#include "tests/renderer/features/feature_worlds.h"

#include <gtest/gtest.h>

#include <cmath>

namespace asos::test {
namespace {

TEST(SurfaceLook, NeighboursOfAnotherMaterialMeetInASeam) {
  World world = empty_world(2);
  world.materials[1].roughness = 0.5f;
  add_part(world, square, up, two_triangles, 0);
  std::vector<glm::vec3> beside = square;
  for (glm::vec3& p : beside) p.x += 1.0f;
  add_part(world, beside, up, two_triangles, 1);
  const FeatureSet features(world);
  EXPECT_EQ(features.counts().seam, 1u);
  EXPECT_EQ(features.counts().open, 6u);
  EXPECT_NE(features.smooth_surface(0), features.smooth_surface(2));
}

TEST(SurfaceLook, MaterialsThatDifferInNothingVisibleMeetInNoSeam) {
  const auto seams = [](auto&& change) {
    World world = empty_world(2);
    world.images.resize(2);
    world.textures.resize(2);
    for (std::size_t i = 0; i < 2; ++i) {
      world.textures[i].image = 0;
      world.materials[i].base_color_texture.texture = static_cast<int>(i);
    }
    change(world);
    add_part(world, square, up, two_triangles, 0);
    std::vector<glm::vec3> beside = square;
    for (glm::vec3& p : beside) p.x += 1.0f;
    add_part(world, beside, up, two_triangles, 1);
    world.texcoords[0].resize(8);
    const FeatureSet features(world);
    EXPECT_EQ(features.smooth_surface(0) == features.smooth_surface(2),
              features.counts().seam == 0);
    return features.counts().seam;
  };
  EXPECT_EQ(seams([](World&) {}), 0u);
  EXPECT_EQ(seams([](World& w) { w.materials[1].name = "other"; }), 0u);
  EXPECT_EQ(seams([](World& w) { w.materials[1].alpha_cutoff = 0.1f; }), 0u);  // not masked
  EXPECT_EQ(seams([](World& w) { w.materials[1].base_color.y = 0.9f; }), 1u);
  EXPECT_EQ(seams([](World& w) { w.materials[1].unlit = true; }), 1u);
  EXPECT_EQ(seams([](World& w) { w.materials[1].emissive.x = 1.0f; }), 1u);
  EXPECT_EQ(seams([](World& w) { w.textures[1].image = 1; }), 1u);
  EXPECT_EQ(seams([](World& w) { w.textures[1].wrap_u = Wrap::clamp_to_edge; }), 1u);
  EXPECT_EQ(seams([](World& w) { w.textures[1].filter = Filter::nearest; }), 1u);
  EXPECT_EQ(seams([](World& w) { w.materials[1].base_color_texture.texcoord = 1; }), 1u);
  EXPECT_EQ(seams([](World& w) { w.materials[1].base_color_texture.uv_transform[2].x = 0.5f; }),
            1u);
  EXPECT_EQ(seams([](World& w) { w.materials[1].base_color_texture.texture = -1; }), 1u);
}

// Two adjacent squares whose texture coordinates jump by (0.5, 0): a texture with this period hides
// the jump. `texture` is a function of (u, v).
std::uint64_t seams_of_jump(TextureAt texture, const Material& material) {
  World world = empty_world();
  world.materials[0] = material;
  world.images.resize(1);
  world.images[0].width = 64;
  world.images[0].height = 64;
  world.textures.resize(1);
  world.textures[0].image = 0;
  std::vector<glm::vec3> positions = square, normals(8, glm::vec3(0, 0, 1));
  for (const glm::vec3& p : square) positions.push_back(p + glm::vec3(1, 0, 0));
  add_part(world, positions, normals, {{0, 1, 2}, {0, 2, 3}, {4, 5, 6}, {4, 6, 7}});
  world.texcoords[0] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}, {1.5f, 0}, {2, 0}, {2, 1}, {1.5f, 1}};
  return FeatureSet(world, texture).counts().seam;
}

glm::vec2 texcoord(const World& w, std::uint32_t triangle, float b1, float b2) {
  const glm::uvec3 t = w.triangles[triangle];
  return (1.0f - b1 - b2) * w.texcoords[0][t.x] + b1 * w.texcoords[0][t.y] +
         b2 * w.texcoords[0][t.z];
}

TEST(SurfaceLook, AJumpOfTextureCoordinatesThatDoesNotShowIsNoSeam) {
  Material textured{.base_color_texture = {.texture = 0}};
  const TextureAt periodic = [](const World& w, const TextureUse&, std::uint32_t t, float b1,
                                float b2) {
    const glm::vec2 uv = texcoord(w, t, b1, b2);
    return glm::vec4(2.0f * uv.x - std::floor(2.0f * uv.x + 1e-3f), uv.y, 0.0f, 1.0f);
  };
  EXPECT_EQ(seams_of_jump(periodic, textured), 0u);
  EXPECT_EQ(seams_of_jump(nullptr, textured), 1u);
  Material bumpy = textured;
  bumpy.normal_texture.texture = 0;
  EXPECT_EQ(seams_of_jump(periodic, bumpy), 1u);
  Material emissive{.emissive_texture = {.texture = 0}};
  EXPECT_EQ(seams_of_jump(periodic, emissive), 0u);
}

// The jump is visible in one texel of 64 along the edge.
TEST(SurfaceLook, AJumpThatShowsInOneTexelIsASeam) {
  Material textured{.base_color_texture = {.texture = 0}};
  const TextureAt speck = [](const World& w, const TextureUse&, std::uint32_t t, float b1,
                             float b2) {
    const glm::vec2 uv = texcoord(w, t, b1, b2);
    const bool inside = uv.x > 1.25f && uv.y > 41.0f / 64.0f && uv.y < 42.0f / 64.0f;
    return glm::vec4(inside ? 0.5f : 0.4f);
  };
  EXPECT_EQ(seams_of_jump(speck, textured), 1u);
  const TextureAt faint = [](const World& w, const TextureUse&, std::uint32_t t, float b1,
                             float b2) {
    return glm::vec4(texcoord(w, t, b1, b2).x > 1.25f ? 0.5f : 0.5f + 1.0f / 600.0f);
  };
  EXPECT_EQ(seams_of_jump(faint, textured), 0u);
}

TEST(SurfaceLook, TextureCoordinatesCountOnlyWhereATextureUsesThem) {
  for (const bool textured : {false, true}) {
    World world = empty_world();
    if (textured) world.materials[0].base_color_texture.texture = 0;
    // Two adjacent squares with a jump of the coordinates.
    std::vector<glm::vec3> positions = square, normals(8, glm::vec3(0, 0, 1));
    for (const glm::vec3& p : square) positions.push_back(p + glm::vec3(1, 0, 0));
    add_part(world, positions, normals, {{0, 1, 2}, {0, 2, 3}, {4, 5, 6}, {4, 6, 7}});
    world.texcoords[0] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0, 0}, {1, 0}, {1, 1}, {0, 1}};
    const FeatureSet features(world);
    EXPECT_EQ(features.counts().seam, textured ? 1u : 0u);
  }
}

}  // namespace
}  // namespace asos::test
