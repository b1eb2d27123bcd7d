#include "tests/renderer/asos/glass_world.h"
#include "tests/support/shape_world.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <utility>
#include <vector>

// Volumes within each other, and overlapping ones: the smaller volume is the medium, from any
// direction. Closed forms: Snell's law between two media, Beer's and Lambert's laws.

namespace asos::test::glass {
namespace {

constexpr float water_index = 1.33f;

/// An axis-aligned block from z = `back` to `front`, 2 `reach` wide and high.
void add_block(World& world, double front, double back, const Material& material,
               double reach = 5.0) {
  add_bar(world, {{-reach, front}, {reach, front}, {reach, back}, {-reach, back}},
          static_cast<float>(reach), material);
}

// The shift by a plate depends on the ratio of the indices, in water as in air.
TEST(NestedGlass, BendsByTheRatioOfBothIndices) {
  constexpr double thickness = 0.4;
  for (const double i : {0.5, 0.9}) {
    for (const float plate : {1.5f, 1.1f}) {
      World world;
      add_block(world, 8.0, -12.0, clear(water_index), 12.0);
      add_plate(world, i, thickness, clear(plate));
      add_edge(world, 0.05, -14.0);
      const auto scene = make_render_scene(std::move(world));
      const double n = static_cast<double>(plate / water_index);
      const double r = std::asin(std::sin(i) / n);
      const double shift = thickness * std::sin(i) * (1.0 - std::cos(i) / (n * std::cos(r)));
      for (const Method method : methods) {
        const double seen = edge_in(picture(*scene, orthographic(1.0), method), 1.0);
        EXPECT_NEAR(seen - 0.05, shift, 1e-3)
            << i << ' ' << plate << ", method " << static_cast<int>(method);
      }
    }
  }
}

// In an overlap the smaller volume attenuates, and the boundary of the larger one is invisible.
TEST(NestedGlass, SmallerVolumeWinsInAnOverlap) {
  Material water = clear(water_index), glass = clear(1.5f);
  water.volume.attenuation_color = {0.25f, 0.5f, 1.0f};
  water.volume.attenuation_distance = 2.0f;
  glass.volume.attenuation_color = {1.0f, 0.5f, 0.25f};
  glass.volume.attenuation_distance = 1.0f;
  for (const bool from_water : {false, true}) {
    const double sign = from_water ? -1.0 : 1.0;
    World world;
    add_block(world, sign * 0.5, sign * -2.0, water);
    add_block(world, sign * 1.0, 0.0, glass, 4.0);
    add_quad(world, {-50, -50, -20}, {100, 0, 0}, {0, 100, 0}, wall(glm::vec3(1.0f)));
    const auto scene = make_render_scene(std::move(world));
    for (const Method method : methods) {
      const glm::dvec3 seen = mean(picture(*scene, orthographic(0.5), method));
      EXPECT_NEAR(seen.x, 0.25, 1e-3) << from_water;
      EXPECT_NEAR(seen.y, 0.5 * 0.5, 1e-3) << from_water;
      EXPECT_NEAR(seen.z, 0.25, 1e-3) << from_water;
    }
  }
}

// A volume with the index of its surroundings is invisible, and reflects nothing.
TEST(NestedGlass, IsInvisibleWithTheSameIndex) {
  Material glass = clear(1.5f);
  glass.specular = 1.0f;
  const auto sky =
      std::make_shared<const Sky>(glm::vec3(0.2f, 0.5f, 1.0f), glm::vec3(1.0f, 0.1f, 0.0f));
  for (const Method method : methods) {
    std::vector<glm::vec3> seen[2];
    for (const bool nested : {false, true}) {
      World world;
      add_block(world, 1.0, -1.0, glass);
      if (nested) add_plate(world, 0.6, 0.2, glass);
      seen[nested ? 1 : 0] =
          picture(*make_render_scene(std::move(world)), orthographic(0.5), method, sky);
    }
    for (std::size_t k = 0; k < seen[0].size(); ++k) {
      for (int c = 0; c < 3; ++c)
        EXPECT_NEAR(seen[0][k][c], seen[1][k][c], 2e-3) << static_cast<int>(method);
    }
  }
}

// A medium entered through an open sheet ends with the sheet's part, and does not affect the plate
// behind it.
TEST(NestedGlass, OpenSheetsEndWithTheirBoxes) {
  constexpr double thickness = 0.4, i = 0.8, n = 1.5;
  World world;
  add_quad(world, {-5, -5, 4}, {10, 0, 0}, {0, 10, 0}, clear(1.3f));
  add_plate(world, i, thickness, clear(static_cast<float>(n)));
  add_edge(world, 0.05, -6.0);
  const auto scene = make_render_scene(std::move(world));
  const double r = std::asin(std::sin(i) / n);
  const double shift = thickness * std::sin(i) * (1.0 - std::cos(i) / (n * std::cos(r)));
  for (const Method method : methods) {
    const double seen = edge_in(picture(*scene, orthographic(1.0), method), 1.0);
    EXPECT_NEAR(seen - 0.05, shift, 1e-3) << static_cast<int>(method);
  }
}

}  // namespace
}  // namespace asos::test::glass
