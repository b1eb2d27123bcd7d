#include "renderer/shading/cube_sky.h"

#include "renderer/shading/sky.h"
#include "renderer/shading/texture.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>

// A cube map (EXT_lights_image_based) as a sky: place, orientation and radiance of its sides.

namespace asos::cube_sky_test {
namespace {

using Texel = std::array<std::uint8_t, 4>;

constexpr int size = 16;

template <typename At>
EnvironmentCube::Side side_of(const At& at, bool divided = false) {
  EnvironmentCube::Side side;
  side.image.width = side.image.height = size;
  side.divided = divided;
  for (int y = 0; y < size; ++y) {
    for (int x = 0; x < size; ++x)
      for (const std::uint8_t byte : at(x, y)) side.image.rgba.own().push_back(byte);
  }
  return side;
}

EnvironmentCube grey_cube(std::uint8_t value) {
  EnvironmentCube cube;
  for (auto& side : cube.sides)
    side = side_of([&](int, int) { return Texel{value, value, value, 255}; });
  return cube;
}

Sky sky_of(const EnvironmentCube& cube) {
  return Sky(sky_map_of(cube), 0.0, "cube");
}

constexpr std::array<glm::vec3, 6> axes{glm::vec3(1, 0, 0), {-1, 0, 0}, {0, 1, 0},
                                        {0, -1, 0},         {0, 0, 1},  {0, 0, -1}};

TEST(CubeSky, SidesAreTowardsTheirAxes) {
  for (std::size_t lit = 0; lit < axes.size(); ++lit) {
    EnvironmentCube cube = grey_cube(0);
    cube.sides[lit] = side_of([](int, int) { return Texel{255, 255, 255, 255}; });
    cube.intensity = 2.0f;
    const Sky sky = sky_of(cube);
    for (std::size_t k = 0; k < axes.size(); ++k)
      EXPECT_NEAR(sky.radiance(axes[k]).y, k == lit ? 2.0f : 0.0f, 1e-5f) << lit << ' ' << k;
  }
}

// The right and upper halves of each side, as seen by a camera at the centre.
TEST(CubeSky, SidesAreTheRightWayUp) {
  // The right and up vectors of each side, for a camera with +Y up; for the upper and lower side,
  // for one that was tilted from looking along +Z.
  constexpr std::array<glm::vec3, 6> right{glm::vec3(0, 0, 1), {0, 0, -1}, {-1, 0, 0},
                                           {-1, 0, 0},         {-1, 0, 0}, {1, 0, 0}};
  for (std::size_t k = 0; k < axes.size(); ++k) {
    const glm::vec3 up = glm::cross(right[k], axes[k]);
    EnvironmentCube cube = grey_cube(0);
    cube.sides[k] = side_of([](int x, int y) {
      return Texel{static_cast<std::uint8_t>(x >= size / 2 ? 255 : 0),
                   static_cast<std::uint8_t>(y < size / 2 ? 255 : 0), 0, 255};
    });
    const Sky sky = sky_of(cube);
    const auto seen = [&](glm::vec3 off) {
      return sky.radiance(glm::normalize(axes[k] + 0.5f * off));
    };
    EXPECT_NEAR(seen(right[k]).x, 1.0f, 1e-5f) << k;
    EXPECT_NEAR(seen(-right[k]).x, 0.0f, 1e-5f) << k;
    EXPECT_NEAR(seen(up).y, 1.0f, 1e-5f) << k;
    EXPECT_NEAR(seen(-up).y, 0.0f, 1e-5f) << k;
  }
}

TEST(CubeSky, IsTurnedByItsRotation) {
  EnvironmentCube cube = grey_cube(0);
  cube.sides[0] = side_of([](int, int) { return Texel{255, 255, 255, 255}; });
  // The cube's +X becomes the world's +Y.
  cube.world_from_cube = {{0, 1, 0}, {-1, 0, 0}, {0, 0, 1}};
  const Sky sky = sky_of(cube);
  EXPECT_NEAR(sky.radiance({0, 1, 0}).x, 1.0f, 1e-5f);
  EXPECT_NEAR(sky.radiance({1, 0, 0}).x, 0.0f, 1e-5f);
}

TEST(CubeSky, ColoursAreDividedByAlpha) {
  EnvironmentCube cube = grey_cube(0);
  cube.sides[4] = side_of([](int, int) { return Texel{128, 255, 0, 51}; }, true);
  const glm::vec3 seen = sky_of(cube).radiance({0, 0, 1});
  EXPECT_NEAR(seen.x, 5.0f * srgb_byte_to_linear(128), 1e-4f);
  EXPECT_NEAR(seen.y, 5.0f, 1e-4f);
  EXPECT_EQ(seen.z, 0.0f);
  cube.sides[4] = side_of([](int, int) { return Texel{128, 255, 0, 0}; }, true);
  EXPECT_EQ(sky_of(cube).radiance({0, 0, 1}), glm::vec3(0.0f));
}

// A uniform cube's irradiance and radiance are a uniform sky's.
TEST(CubeSky, UniformCubeIsAUniformSky) {
  const float grey = srgb_byte_to_linear(128);
  const Sky sky = sky_of(grey_cube(128));
  for (const glm::vec3 d : {glm::vec3(0.6f, 0.8f, 0.0f), glm::vec3(0.0f, -0.28f, 0.96f)}) {
    EXPECT_NEAR(sky.radiance(d).y, grey, 1e-5f);
    EXPECT_NEAR(sky.ambient(d).y / Sky(glm::vec3(grey)).ambient(d).y, 1.0f, 1e-3f);
  }
}

}  // namespace
}  // namespace asos::cube_sky_test
