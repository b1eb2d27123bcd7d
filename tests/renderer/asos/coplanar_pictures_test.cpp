#include "tests/support/make_settings.h"
#include "tests/support/render_picture.h"
#include "tests/support/tiny_image.h"
#include "tests/support/tiny_scene.h"
#include "tests/support/tiny_world.h"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

// Decals exactly on a wall: every method shows them completely, for any winding.

namespace asos::test::coplanar_pictures_test {
namespace {

constexpr int side = 32;
constexpr glm::vec3 red(1, 0, 0), blue(0, 0, 1), green(0, 1, 0);

Material paint(glm::vec3 colour, AlphaMode mode, float alpha = 1.0f) {
  Material m = unlit(colour);
  m.base_color.a = alpha;
  m.alpha_mode = mode;
  m.double_sided = true;
  return m;
}

/// A square around the origin, rotated about an oblique axis.
void add_square(World& world, float half, double angle, const Material& material,
                float turn = 0.0f) {
  const glm::dmat4 tilt = glm::rotate(glm::dmat4(1.0), angle, glm::normalize(glm::dvec3(1, 2, 3)));
  const auto placed = [&](float x, float y) {
    const float c = std::cos(turn), s = std::sin(turn);
    return glm::vec3(tilt * glm::dvec4(half * (c * x - s * y), half * (s * x + c * y), 0, 1));
  };
  add_quad(world, placed(-1, -1), placed(1, -1) - placed(-1, -1), placed(-1, 1) - placed(-1, -1),
           material);
}

glm::vec3 middle_of(const Film& film, glm::vec3& least, glm::vec3& most) {
  glm::vec3 sum(0.0f);
  least = glm::vec3(9.0f), most = glm::vec3(-9.0f);
  constexpr int from = side / 2 - 4, to = side / 2 + 4;
  for (int y = from; y < to; ++y) {
    for (int x = from; x < to; ++x) {
      const glm::vec3 c(film.radiance[film.index(x, y)]);
      least = glm::min(least, c), most = glm::max(most, c);
      sum += c / 64.0f;
    }
  }
  return sum;
}

/// Expects that all pixels in the picture's centre have this colour.
void expect_even(const World& world, glm::vec3 expected) {
  const auto scene = make_render_scene(World(world));
  const Camera camera = look_at({0.3, 0.2, 4.0}, {0, 0, 0}, 0.6);
  for (const Method method : {Method::asos, Method::sobol, Method::uniform, Method::whitted}) {
    const RenderSettings settings = make_settings(side, side, method, 4);
    glm::vec3 least, most;
    (void)middle_of(render_picture(*scene, camera, settings).film, least, most);
    for (int c = 0; c < 3; ++c) {
      EXPECT_NEAR(least[c], expected[c], 2e-3f) << static_cast<int>(method);
      EXPECT_NEAR(most[c], expected[c], 2e-3f) << static_cast<int>(method);
    }
  }
}

constexpr double tilts[] = {0.0, 0.3, 0.5, 0.7};

TEST(CoplanarPictures, ADecalIsWholeWhateverItsOrder) {
  for (const double tilt : tilts) {
    for (const AlphaMode mode : {AlphaMode::blend, AlphaMode::mask}) {
      for (const bool first : {true, false}) {
        SCOPED_TRACE(tilt);
        World world;
        if (first) add_square(world, 0.5f, tilt, paint(red, mode));
        add_square(world, 1.0f, tilt, paint(blue, AlphaMode::opaque));
        if (!first) add_square(world, 0.5f, tilt, paint(red, mode));
        expect_even(world, red);
      }
    }
  }
}

TEST(CoplanarPictures, WhatLiesUnderADecalShinesThrough) {
  for (const double tilt : tilts) {
    SCOPED_TRACE(tilt);
    World world;
    add_square(world, 0.5f, tilt, paint(red, AlphaMode::blend, 0.5f));
    add_square(world, 1.0f, tilt, paint(blue, AlphaMode::opaque));
    add_square(world, 0.6f, tilt, paint(green, AlphaMode::blend, 0.5f), 0.5f);
    expect_even(world, 0.5f * green + 0.25f * red + 0.25f * blue);
  }
}

TEST(CoplanarPictures, OfOpaqueOnesTheLastIsSeen) {
  for (const double tilt : tilts) {
    SCOPED_TRACE(tilt);
    World world;
    add_square(world, 0.6f, tilt, paint(red, AlphaMode::opaque));
    add_square(world, 0.7f, tilt, paint(blue, AlphaMode::opaque), 0.4f);
    add_square(world, 0.8f, tilt, paint(green, AlphaMode::opaque), 0.9f);
    expect_even(world, green);
  }
}

}  // namespace
}  // namespace asos::test::coplanar_pictures_test
