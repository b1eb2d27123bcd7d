#include "renderer/comparison/method.h"
#include "tests/support/make_settings.h"
#include "tests/support/tiny_world.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <numbers>
#include <random>
#include <string>
#include <utility>
#include <vector>

// Meshes with typical defects against beam tracing, which uses triangles and knows no edges. Flat
// unlit colours, so that a pixel's value is a sum of areas.

namespace asos::test::rough_meshes_test {
namespace {

constexpr int size = 48;

struct Solid {
  std::vector<glm::vec3> positions;
  std::vector<glm::uvec3> triangles;
};

// A closed surface of revolution about the y axis; `profile` goes from (0, bottom) to (0, top) as
// (radius, y).
Solid revolved(const std::vector<glm::vec2>& profile, std::uint32_t segments) {
  Solid solid;
  std::vector<std::vector<std::uint32_t>> rings;
  for (const glm::vec2& p : profile) {
    std::vector<std::uint32_t>& ring = rings.emplace_back();
    const bool pole = p.x == 0.0f;
    for (std::uint32_t i = 0; i < segments; ++i) {
      const float angle =
          2.0f * std::numbers::pi_v<float> * static_cast<float>(i) / static_cast<float>(segments);
      if (!pole || i == 0)
        solid.positions.emplace_back(p.x * std::cos(angle), p.y, p.x * std::sin(angle));
      ring.push_back(static_cast<std::uint32_t>(solid.positions.size() - 1));
    }
  }
  for (std::size_t r = 0; r + 1 < rings.size(); ++r) {
    for (std::uint32_t i = 0; i < segments; ++i) {
      const std::uint32_t k = (i + 1) % segments;
      const glm::uvec4 q(rings[r][i], rings[r][k], rings[r + 1][k], rings[r + 1][i]);
      if (q.x != q.y) solid.triangles.emplace_back(q.x, q.y, q.z);
      if (q.z != q.w) solid.triangles.emplace_back(q.x, q.z, q.w);
    }
  }
  return solid;
}

Solid sphere() {
  std::vector<glm::vec2> profile{{0, -1}};
  for (int i = 1; i < 12; ++i) {
    const float angle = std::numbers::pi_v<float> * static_cast<float>(i) / 12.0f;
    profile.emplace_back(std::sin(angle), -std::cos(angle));
  }
  profile.emplace_back(0.0f, 1.0f);
  return revolved(profile, 24);
}

Solid cylinder() {
  return revolved({{0, -1}, {0.6f, -1}, {0.6f, 1}, {0, 1}}, 24);
}

Solid box() {
  return revolved({{0, -0.7f}, {1, -0.7f}, {1, 0.7f}, {0, 0.7f}}, 4);
}

Solid quad(glm::vec3 corner, glm::vec3 a, glm::vec3 b) {
  return {{corner, corner + a, corner + a + b, corner + b}, {{0, 1, 2}, {0, 2, 3}}};
}

glm::mat3 random_turn(std::mt19937& random) {
  std::normal_distribution<float> normal;
  const auto vector = [&] { return glm::vec3(normal(random), normal(random), normal(random)); };
  const glm::vec3 x = glm::normalize(vector());
  const glm::vec3 y = glm::normalize(glm::cross(x, vector()));
  return {x, y, glm::cross(x, y)};
}

class RoughScene {
 public:
  Mesh& add(const Solid& solid, const Material& material) {
    Mesh mesh{.positions = solid.positions};
    mesh.normals.assign(solid.positions.size(), glm::vec3(0, 0, 1));
    mesh.triangles = solid.triangles;
    mesh.material = static_cast<int>(scene_.materials.size());
    scene_.materials.push_back(material);
    Instance instance{.mesh = static_cast<int>(scene_.meshes.size())};
    scene_.instances.push_back(instance);
    scene_.meshes.push_back(std::move(mesh));
    return scene_.meshes.back();
  }

  Scene& scene() { return scene_; }

  [[nodiscard]] std::shared_ptr<const RenderScene> prepared() const {
    return prepare(scene_).value();
  }

 private:
  Scene scene_;
};

struct Picture {
  std::vector<BlockResult> blocks;
  RenderStatistics statistics;

  [[nodiscard]] double rms(const Picture& other) const {
    double sum = 0.0;
    std::size_t pixels = 0;
    for (std::size_t b = 0; b < blocks.size(); ++b) {
      for (std::size_t i = 0; i < blocks[b].tile.radiance.size(); ++i, ++pixels) {
        const glm::dvec3 d = blocks[b].tile.radiance[i] - other.blocks[b].tile.radiance[i];
        sum += glm::dot(d, d) / 3.0;
      }
    }
    return std::sqrt(sum / static_cast<double>(pixels));
  }
  [[nodiscard]] bool same(const Picture& other, float bound) const {
    for (std::size_t b = 0; b < blocks.size(); ++b) {
      for (std::size_t i = 0; i < blocks[b].tile.radiance.size(); ++i) {
        const glm::vec3 d = glm::abs(blocks[b].tile.radiance[i] - other.blocks[b].tile.radiance[i]);
        if (!(std::max({d.x, d.y, d.z}) <= bound)) return false;
      }
    }
    return true;
  }
};

Picture render(const RenderScene& scene, Method method, glm::dvec3 eye = {1.5, 2.0, 5.0}) {
  RenderSettings settings = make_settings(size, size, method);
  settings.asos.max_level = 4;
  settings.asos.eps = 0.0;
  const glm::dvec3 origin = scene.world().origin;
  const View view(look_at(eye - origin, -origin, 0.6), size, size);
  Picture picture;
  for (int y = 0; y < size; y += block_size) {
    for (int x = 0; x < size; x += block_size) {
      picture.blocks.push_back(render_block(scene, view, settings, {x, y, block_size, block_size}));
      picture.statistics += picture.blocks.back().statistics;
    }
  }
  return picture;
}

// No edge is missing: the error is limited by the area of unresolved cells, with colours that
// differ by at most 1 per channel, and by single-precision rounding of lines.
void expect_exact(const RenderScene& scene, const std::string& what) {
  const Picture asos = render(scene, Method::asos), beam = render(scene, Method::beam);
  EXPECT_EQ(asos.statistics.missed_splits, 0u) << what;
  EXPECT_GT(asos.statistics.split_pixels, 0u) << what;
  constexpr double rounding = 1e-4;
  for (std::size_t b = 0; b < asos.blocks.size(); ++b) {
    const BlockResult& found = asos.blocks[b];
    glm::dvec3 wrong(0.0);
    for (std::size_t i = 0; i < found.tile.radiance.size(); ++i)
      wrong += glm::abs(glm::dvec3(found.tile.radiance[i] - beam.blocks[b].tile.radiance[i]));
    EXPECT_LE(std::max({wrong.x, wrong.y, wrong.z}),
              found.statistics.unresolved_area + rounding * block_size * block_size)
        << what << ", block " << b;
    // A cell of level 4 has 1/256 of a pixel's area, so this limit is meaningful.
    EXPECT_LT(found.statistics.unresolved_area, 1.0) << what << ", block " << b;
  }
}

TEST(RoughMeshes, SolidsThatPassThroughEachOtherMeetInExactLines) {
  const std::vector<std::pair<std::string, Solid>> solids{
      {"sphere", sphere()}, {"box", box()}, {"cylinder", cylinder()}};
  std::mt19937 random(21);
  std::uniform_real_distribution<float> unit(-0.6f, 0.6f);
  for (std::size_t i = 0; i < solids.size(); ++i) {
    for (std::size_t k = i; k < solids.size(); ++k) {
      for (int pose = 0; pose < 4; ++pose) {
        RoughScene rough;
        for (const std::size_t which : {i, k}) {
          Solid solid = solids[which].second;
          const glm::mat3 turn = random_turn(random);
          const glm::vec3 at(unit(random), unit(random), unit(random));
          for (glm::vec3& p : solid.positions) p = at + turn * p;
          rough.add(solid, unlit(rough.scene().meshes.empty() ? glm::vec3(0.9f, 0.2f, 0.1f)
                                                              : glm::vec3(0.1f, 0.8f, 0.3f)));
        }
        const auto scene = rough.prepared();
        EXPECT_GT(scene->features().counts().intersection, 0u);
        expect_exact(
            *scene, solids[i].first + " and " + solids[k].first + ", pose " + std::to_string(pose));
      }
    }
  }
}

// One large slab of floor next to three small ones with corners on its edge.
TEST(RoughMeshes, TJunctionsLeaveNoGap) {
  RoughScene rough;
  rough.add(quad({-2, -0.5f, 1.5f}, {2, 0, 0}, {0, 0, -3}), unlit({0.8f, 0.7f, 0.2f}));
  const float ends[]{1.5f, 0.37f, -0.71f, -1.5f};
  for (int i = 0; i < 3; ++i)
    rough.add(quad({0, -0.5f, ends[i]}, {2, 0, 0}, {0, 0, ends[i + 1] - ends[i]}),
              unlit({0.2f, 0.3f * static_cast<float>(i), 0.8f}));
  expect_exact(*rough.prepared(), "floor");
}

// A fan of walls on one floor: modelled once, and with some walls duplicated and flipped.
TEST(RoughMeshes, WallsModelledTwiceLookAsOnce) {
  RoughScene once, twice;
  for (int i = 0; i < 5; ++i) {
    const float angle = 1.2f * static_cast<float>(i);
    const glm::vec3 along(std::cos(angle), 0, std::sin(angle));
    Solid wall = quad({0, -1, 0}, 0.5f * along, {0, 1, 0});
    const Solid rest = quad(0.5f * along + glm::vec3(0, -1, 0), 0.7f * along, {0, 1, 0});
    for (const glm::vec3& p : rest.positions) wall.positions.push_back(p);
    for (const glm::uvec3& t : rest.triangles) wall.triangles.push_back(t + 4u);
    Material paint = unlit({0.2f * static_cast<float>(i), 0.5f, 0.9f});
    paint.double_sided = true;
    once.add(wall, paint);
    for (std::size_t k = 0, n = wall.triangles.size(); i % 2 == 0 && k < n; ++k) {
      const glm::uvec3 t = wall.triangles[k];
      wall.triangles.emplace_back(t.x, t.z, t.y);
    }
    twice.add(wall, paint);
  }
  const auto single = once.prepared(), doubled = twice.prepared();
  EXPECT_EQ(doubled->features().counts().open, single->features().counts().open);
  expect_exact(*single, "once");
  expect_exact(*doubled, "twice");
  const Picture a = render(*single, Method::asos), b = render(*doubled, Method::asos);
  EXPECT_EQ(a.statistics.eye_rays, b.statistics.eye_rays);
  EXPECT_TRUE(a.same(b, 1e-5f));
}

// The winding changes neither edges nor shading, here with light and shadows.
TEST(RoughMeshes, FlippedFacesLookTheSame) {
  std::mt19937 random(22);
  RoughScene sound;
  const glm::mat3 turn = random_turn(random);
  for (const Solid& part : {sphere(), box()}) {
    Solid solid = part;
    for (glm::vec3& p : solid.positions) p = 0.7f * (turn * p) + glm::vec3(0, 0.3f, 0);
    Mesh& mesh = sound.add(solid, matte({0.7f, 0.4f, 0.3f}));
    for (std::size_t i = 0; i < mesh.positions.size(); ++i)
      mesh.normals[i] = glm::normalize(mesh.positions[i] - glm::vec3(0, 0.3f, 0));
  }
  Mesh& floor = sound.add(quad({-2, -0.6f, 2}, {4, 0, 0}, {0, 0, -4}), matte({0.6f, 0.6f, 0.6f}));
  floor.normals.assign(4, glm::vec3(0, 1, 0));
  for (Material& material : sound.scene().materials) material.double_sided = true;
  RoughScene flipped = sound;
  for (Mesh& mesh : flipped.scene().meshes)
    for (glm::uvec3& t : mesh.triangles)
      if (random() % 2) std::swap(t.y, t.z);
  const auto before = sound.prepared(), after = flipped.prepared();
  EXPECT_EQ(before->features().edges().size(), after->features().edges().size());
  const Picture a = render(*before, Method::asos), b = render(*after, Method::asos);
  EXPECT_EQ(a.statistics.split_pixels, b.statistics.split_pixels);
  EXPECT_EQ(a.statistics.missed_splits, 0u);
  EXPECT_EQ(b.statistics.missed_splits, 0u);
  // Barycentric coordinates are rounded differently, and rays that sample a penumbra may pass an
  // edge on the other side: within the tolerance of a pixel at MAX 4.
  EXPECT_TRUE(a.same(b, std::ldexp(1.0f, -10)));
  EXPECT_LT(a.rms(b), 1e-5);
}

// A wall of two halves with separate vertices and a continuous texture.
TEST(RoughMeshes, ContinuousTexturesNeedNoSeam) {
  const auto wall = [](float jump) {
    RoughScene rough;
    Material paint = unlit({1, 1, 1});
    paint.double_sided = true;
    paint.base_color_texture.texture = 0;
    Solid solid = quad({-1.125f, -0.75f, 0}, {1, 0, 0}, {0, 1.5f, 0});
    const Solid right = quad({-0.125f, -0.75f, 0}, {1, 0, 0}, {0, 1.5f, 0});
    solid.positions.insert(solid.positions.end(), right.positions.begin(), right.positions.end());
    for (const glm::uvec3& t : right.triangles) solid.triangles.push_back(t + 4u);
    Mesh& mesh = rough.add(solid, paint);
    mesh.texcoords[0] = {{0, 1},        {1, 1},        {1, 0},        {0, 0},
                         {1 + jump, 1}, {2 + jump, 1}, {2 + jump, 0}, {1 + jump, 0}};
    Image image;
    image.width = image.height = 16;
    std::mt19937 random(23);
    for (int i = 0; i < 4 * 256; ++i)
      image.rgba.own().push_back(i % 4 == 3 ? 255 : static_cast<std::uint8_t>(random() % 256));
    rough.scene().images.push_back(image);
    Texture texture{.image = 0};
    rough.scene().textures.push_back(texture);
    return rough.prepared();
  };
  const auto whole = wall(0.0f), periods = wall(3.0f), broken = wall(0.5f);
  EXPECT_EQ(periods->features().counts().seam, 0u);
  EXPECT_EQ(broken->features().counts().seam, 1u);
  const Picture a = render(*whole, Method::asos), b = render(*periods, Method::asos);
  EXPECT_EQ(a.statistics.eye_rays, b.statistics.eye_rays);
  EXPECT_EQ(b.statistics.missed_splits, 0u);
  EXPECT_GT(render(*broken, Method::asos).statistics.eye_rays, a.statistics.eye_rays);
  // 3 + u keeps 22 bits of u: 1e-6 of the width of 16 texels, whose values may go from 0 to 1.
  EXPECT_TRUE(a.same(b, 1e-4f));
}

}  // namespace
}  // namespace asos::test::rough_meshes_test
