#include "renderer/shadows/penumbra.h"
#include "tests/support/sample_lights.h"
#include "tests/support/shadow_fixture.h"
#include "tests/support/shadow_oracle.h"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>

// Whether the edge of a shadow on a patch is found, for various patches, occluders and lights.

namespace asos::test::penumbra_search_test {
namespace {

/// The decision for a patch around the origin of a plane, below a rectangle light of 2 x 1.5 at
/// distance 2, with the occluders in the world.
class PenumbraSearch : public testing::Test {
 protected:
  [[nodiscard]] Penumbra look(World world, const Patch& patch, double weight = 1.0) {
    Light light{.type = Light::Type::rectangle};
    const float lean = lean_of_light;
    light.position = 2.0f * glm::vec3(std::sin(lean), std::cos(lean), 0);
    light.direction = -glm::normalize(light.position);
    light.half_u = {std::cos(lean), -std::sin(lean), 0};
    light.half_v = {0, 0, 0.75};
    light.intensity = intensity;
    light.two_sided = true;
    const ShadowFixture fixture(std::move(world), light);
    const ShadowScene scene{fixture.world(), fixture.features(), fixture.rays()};
    ShadowGroups groups(scene);
    groups.reset(1);
    ShadowWorkspace work;
    NoView view;
    const Frame eye = Frame::pyramid({0, 0, 0}, {-0.5, -0.5, -1}, {1, 0, 0}, {0, 1, 0});
    ShadowContext block{.scene = &scene,
                        .rules = {.error_budget = {.eps = 1.0 / 256.0, .tolerance = tolerance}},
                        .frame = &eye,
                        .view = &view,
                        .groups = &groups,
                        .work = &work};
    SurfacePoint point;
    point.triangle = 0;  // flat
    point.position = position;
    point.shading_normal = point.geometric_normal = {0, 1, 0};
    RenderStatistics counts;
    return find_penumbra(block, {fixture.light(), 0, point, patch, 1.0f, 0, weight}, counts);
  }

  float lean_of_light = 0.0f;  ///< towards +X, radians
  float intensity = 1000.0f;
  float tolerance = 1.0f / 256.0f;
  glm::vec3 position{0.0f};  ///< of the patch's middle
};

// Next to a wall that hangs from the light, the visible fraction is 1 - |x| / 2: over a patch of
// width w its mean is w / 8 less than at the centre.
TEST_F(PenumbraSearch, SplitsAPatchBelowAHangingWall) {
  tolerance = 1e-4f;
  for (const float width : {0.02f, 0.1f}) {
    const auto error_at = [&](float x) {
      World world;
      add_occluder(world, {0, 1, -4}, {0, 2, 0}, {0, 0, 8});
      position = {x, 0, 0};
      return look(std::move(world), {{width, 0, 0}, {0, 0, width}}).error;
    };
    EXPECT_NEAR(error_at(0.0f), width / 8.0f, 0.3f * width / 8.0f);
    EXPECT_EQ(error_at(0.4f), 0.0f);
  }
}

/// A pole of width 0.02 along z, close above the plane: it hides the light from the patch's centre,
/// and from a fifth of the patch.
World pole(double height, double length) {
  World world;
  add_occluder(world, {-0.01, height, -0.5 * length}, {0.02, 0, 0}, {0, 0, length});
  return world;
}

// The pole's edges extend far beyond the patch on both sides, so their ends are not near it.
TEST_F(PenumbraSearch, FindsALongPoleAcrossANarrowPatch) {
  for (const double length : {1.0, 8.0, 64.0}) {
    for (const float depth : {0.1f, 0.01f, 0.001f}) {
      const Penumbra found = look(pole(0.002, length), {{0.1f, 0, 0}, {0, 0, depth}});
      EXPECT_TRUE(found.too_detailed || found.error > 0.1f) << length << ' ' << depth;
    }
  }
}

TEST_F(PenumbraSearch, LeavesAPatchAloneThatNoShadowReaches) {
  World world;
  add_occluder(world, {3.0, 0.002, -4}, {0.02, 0, 0}, {0, 0, 8});
  const Penumbra found = look(std::move(world), {{0.1f, 0, 0}, {0, 0, 0.01f}});
  EXPECT_EQ(found.error, 0.0f);
  EXPECT_FALSE(found.too_detailed);
}

// A ledge 0.01 above the plane, with an oblique light: the ledge's edge is behind the patch's
// centre as seen from the light, but its shadow falls on a part of the patch.
TEST_F(PenumbraSearch, FindsALedgeBehindThePatch) {
  lean_of_light = 1.1f;  // at 27 degrees: a shadow twice as long as its height
  const Patch patch{{0.1f, 0, 0}, {0, 0, 0.1f}};
  const auto ledge_from = [](double x) {
    World world;
    add_occluder(world, {x - 4.0, 0.01, -4}, {4, 0, 0}, {0, 0, 8});
    return world;
  };
  EXPECT_GT(look(ledge_from(-0.02), patch).error, 0.1f);  // a tenth of the patch, and penumbra
  EXPECT_EQ(look(ledge_from(-0.08), patch).error, 0.0f);  // beyond it
}

// The search is skipped if a few rays are accurate enough: for a small part of a pixel, or a dim
// light.
TEST_F(PenumbraSearch, IsSkippedIfFewRaysSuffice) {
  const Patch patch{{0.1f, 0, 0}, {0, 0, 0.1f}};
  EXPECT_GT(look(pole(0.002, 8.0), patch, 1.0).error, 0.1f);
  EXPECT_EQ(look(pole(0.002, 8.0), patch, 1.0 / 1024.0).error, 0.0f);
  intensity = 0.05f;
  EXPECT_EQ(look(pole(0.002, 8.0), patch, 1.0).error, 0.0f);
}

}  // namespace
}  // namespace asos::test::penumbra_search_test
