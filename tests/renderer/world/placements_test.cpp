#include "renderer/world/placements.h"

#include "renderer/world/ground.h"
#include "renderer/world/range_index.h"
#include "renderer/world/world.h"
#include "tests/support/instanced_scene.h"

#include <gtest/gtest.h>

#include <limits>

namespace asos {
namespace {

constexpr std::uint64_t any_copies = 1;

World flat(const Scene& scene, std::uint64_t fewest_copied) {
  auto flattened = flatten(scene, most_triangles, std::nullopt, fewest_copied);
  EXPECT_TRUE(flattened) << flattened.error().message();
  return std::move(flattened->world);
}

/// The corners of a part's triangle, by the part's own numbering.
glm::uvec3 corners(const World& world, const Part& part, std::uint32_t t) {
  return world.triangles[part.first_triangle + t];
}

void expect_same_surfaces(const World& world, const World& copies) {
  ASSERT_EQ(world.parts.size(), copies.parts.size());
  EXPECT_EQ(world.triangles.size(), copies.triangles.size());
  EXPECT_EQ(world.positions.size(), copies.positions.size());
  for (std::size_t p = 0; p < world.parts.size(); ++p) {
    const Part &a = world.parts[p], &b = copies.parts[p];
    ASSERT_EQ(a.triangle_count, b.triangle_count);
    EXPECT_EQ(a.name, b.name);
    EXPECT_EQ(a.material, b.material);
    EXPECT_EQ(a.bounds.lo, b.bounds.lo);
    EXPECT_EQ(a.bounds.hi, b.bounds.hi);
    for (std::uint32_t t = 0; t < a.triangle_count; ++t) {
      ASSERT_EQ(world.triangle_part[a.first_triangle + t], p);
      const glm::uvec3 v = corners(world, a, t), w = corners(copies, b, t);
      for (int k = 0; k < 3; ++k) {
        ASSERT_EQ(world.positions[v[k]], copies.positions[w[k]]);
        ASSERT_LT(glm::distance(world.normals[v[k]], copies.normals[w[k]]), 1e-5f);
      }
    }
  }
}

TEST(Placements, HoldTheSameSurfacesAsCopies) {
  const Scene scene = test::instanced_scene(24, 8);
  const World world = flat(scene, any_copies), copies = flat(scene, never_shared);
  ASSERT_TRUE(world.placements);
  EXPECT_EQ(world.placements->meshes.size(), 2u);
  EXPECT_EQ(world.placements->places.size(), 24u);
  EXPECT_EQ(world.triangles.own().size(), 2u);
  EXPECT_FALSE(copies.placements);
  EXPECT_EQ(world.origin, copies.origin);
  expect_same_surfaces(world, copies);
}

TEST(Placements, KeepTheirSurfacesOnAGround) {
  World world = flat(test::instanced_scene(24, 8), any_copies);
  World copies = flat(test::instanced_scene(24, 8), never_shared);
  put_on_ground(world, Ground::on);
  put_on_ground(copies, Ground::on);
  expect_same_surfaces(world, copies);
  put_on_ground(world, Ground::off);
  put_on_ground(copies, Ground::off);
  expect_same_surfaces(world, copies);
}

TEST(Placements, HaveTheAttributesOfTheirMeshes) {
  Scene scene = test::instanced_scene(12, 8);
  Image image;
  image.width = image.height = 1;
  image.rgba = std::vector<std::uint8_t>(4, 128);
  scene.images.push_back(image);
  scene.textures.push_back({"texture", 0});
  scene.materials[0].base_color_texture.texture = 0;
  scene.materials[0].normal_texture.texture = 0;
  Mesh& ball = scene.meshes[0];
  for (std::size_t i = 0; i < ball.positions.size(); ++i) {
    const auto at = static_cast<float>(i);
    ball.texcoords[0].emplace_back(0.1f * at, 1.0f - at);
    ball.tangents.emplace_back(1.0f, 0.0f, 0.0f, i % 2 == 0 ? 1.0f : -1.0f);
    ball.colors.emplace_back(0.01f * at, 0.5f, 1.0f, 1.0f);
  }
  const World world = flat(scene, any_copies), copies = flat(scene, never_shared);
  ASSERT_TRUE(world.placements);
  ASSERT_EQ(world.tangents.size(), copies.tangents.size());
  ASSERT_EQ(world.texcoords[0].size(), copies.texcoords[0].size());
  ASSERT_EQ(world.colors.size(), copies.colors.size());
  for (std::size_t p = 0; p < world.parts.size(); ++p) {
    for (std::uint32_t i = 0; i < world.parts[p].vertex_count; ++i) {
      const std::size_t v = world.parts[p].first_vertex + i, w = copies.parts[p].first_vertex + i;
      ASSERT_LT(glm::distance(world.tangents[v], copies.tangents[w]), 1e-5f) << p << " " << i;
      ASSERT_EQ(world.texcoords[0][v], copies.texcoords[0][w]);
      ASSERT_EQ(world.colors[v], copies.colors[w]);
    }
  }
}

TEST(Placements, ShareNoMeshThatHasDataForEachTriangle) {
  const auto shares = [](const Scene& scene) {
    return flat(scene, any_copies).placements != nullptr;
  };
  Scene scene = test::instanced_scene(2, 8);
  EXPECT_FALSE(shares(scene)) << "two meshes with one instance each";
  scene = test::instanced_scene(4, 8);
  EXPECT_TRUE(shares(scene));
  scene.materials[0].alpha_mode = AlphaMode::mask;
  scene.materials[1].emissive = glm::vec3(1.0f);
  EXPECT_FALSE(shares(scene));
  scene = test::instanced_scene(4, 8);
  scene.meshes[2].segments.emplace_back(0, 1);
  EXPECT_FALSE(shares(scene)) << "lines come after all triangles";
  scene = test::instanced_scene(4, 8);
  for (Instance& instance : scene.instances)
    instance.world_from_mesh[1] *= instance.mesh < 2 ? 1000.0 : 1.0;
  EXPECT_FALSE(shares(scene)) << "rounding may make flat edges creases";
}

TEST(Placements, TakeMemoryByTheirMeshes) {
  const World few = flat(test::instanced_scene(50, 24), any_copies);
  const World many = flat(test::instanced_scene(450, 24), any_copies);
  const double more = static_cast<double>(geometry_bytes(many) - geometry_bytes(few));
  EXPECT_LT(more / 400.0, 600.0);
  const double triangles = static_cast<double>(many.triangles.size() - few.triangles.size());
  EXPECT_LT(more / triangles, 0.6);
}

TEST(Distortion, BoundsHowMuchLengthsGrow) {
  const Distortion turned = distortion_of(
      glm::dmat3(glm::rotate(glm::scale(glm::dmat4(1.0), glm::dvec3(3.0)), 1.0, glm::dvec3(1.0))));
  EXPECT_NEAR(turned.most_growth, 3.0, 1e-12);
  EXPECT_EQ(turned.anisotropy, 1.0);
  const Distortion stretched = distortion_of(glm::dmat3(2.0, 0, 0, 0, 1.0, 0, 0, 0, 0.5));
  EXPECT_GE(stretched.most_growth, 2.0);
  EXPECT_GE(stretched.anisotropy, 4.0);
  EXPECT_LT(stretched.anisotropy, 16.0);
  EXPECT_EQ(distortion_of(glm::dmat3(1, 0, 0, 0, 1, 0, 0, 0, 0)).anisotropy,
            std::numeric_limits<double>::infinity());
}

TEST(RangeIndex, FindsTheRangeOfEachNumber) {
  const std::vector<std::uint32_t> first{0, 1, 2, 1000, 1001, 5000};
  const RangeIndex index(first, 5003);
  for (std::uint32_t i = 0; i < 5003; ++i) {
    std::size_t range = 0;
    while (range + 1 < first.size() && first[range + 1] <= i) ++range;
    ASSERT_EQ(index.find(i), range) << i;
  }
}

}  // namespace
}  // namespace asos
