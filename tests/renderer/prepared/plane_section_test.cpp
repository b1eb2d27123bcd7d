#include "renderer/prepared/plane_section.h"

#include "tests/support/tiny_scene.h"

#include <gtest/gtest.h>

// Lines along which a plane cuts the triangles of a world.

namespace asos::test::plane_section_test {
namespace {

/// A floor of two triangles from -1 to 1, which rises with x.
World slope() {
  World world;
  add_quad(world, {-1, -1, -1}, {2, 0, 2}, {0, 2, 0}, matte(glm::vec3(0.5f)));
  return world;
}

double length_of(const PlaneSection& section) {
  double sum = 0.0;
  for (const SectionLine& line : section) sum += glm::distance(line.from, line.to);
  return sum;
}

TEST(PlaneSection, OfASlopeLiesInThePlane) {
  const HalfSpace plane{{0, 0, 1}, 0.25};
  const PlaneSection section = plane_section(slope(), plane);
  ASSERT_EQ(section.size(), 2u) << "one line per triangle";
  for (const SectionLine& line : section) {
    for (const glm::dvec3 p : {line.from, line.to}) {
      EXPECT_NEAR(plane.height(p), 0.0, 1e-12);
      EXPECT_NEAR(p.x, 0.25, 1e-12);
    }
  }
  EXPECT_NEAR(length_of(section), 2.0, 1e-12) << "from border to border, without a gap";
}

TEST(PlaneSection, IsNoneOfWhatIsWhollyAheadOrBehind) {
  EXPECT_TRUE(plane_section(slope(), {{0, 0, 1}, 1.5}).empty());
  EXPECT_TRUE(plane_section(slope(), {{0, 0, -1}, 1.5}).empty());
  EXPECT_TRUE(plane_section(slope(), {{0, 0, 1}, -1.0}).empty()) << "its lowest edge touches";
}

TEST(PlaneSection, ThatIsKeptIsThatOfThePlaneAskedFor) {
  const World world = slope();
  const PlaneSections sections;
  const auto first = sections.of(world, {{0, 0, 1}, 0.25});
  EXPECT_EQ(sections.of(world, {{0, 0, 1}, 0.25}), first) << "made once";
  const auto second = sections.of(world, {{0, 0, 1}, 0.5});
  ASSERT_EQ(second->size(), 2u);
  EXPECT_NEAR(second->front().from.x, 0.5, 1e-12);
  EXPECT_NEAR(first->front().from.x, 0.25, 1e-12) << "existing owners keep it";
  EXPECT_EQ(sections.of(world, {{0, 0, 1}, 0.25}), first) << "a near and a far plane are both kept";
  EXPECT_EQ(sections.of(world, {{0, 0, 1}, 0.5}), second);
}

}  // namespace
}  // namespace asos::test::plane_section_test
