#include "renderer/reflections/mirrored_pyray.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace asos {
namespace {

/// A flat mirror in z = 0, and a pyray from above that hits it at the origin, at `tilt` radians to
/// its normal, with edges of these lengths at the mirror.
struct Meeting {
  IncidentPyray pyray;
  MirrorSurface surface;
};

Meeting meeting(double tilt, double right, double down) {
  constexpr double distance = 10.0;
  Meeting m;
  m.pyray.axis = {std::sin(tilt), 0.0, -std::cos(tilt)};
  m.pyray.right = right / distance * glm::dvec3(std::cos(tilt), 0.0, std::sin(tilt));
  m.pyray.down = down / distance * glm::dvec3(0.0, 1.0, 0.0);
  m.pyray.distance = distance;
  return m;
}

MirroredPyray blurred(const Meeting& m, double width) {
  const MirrorLobe lobe =
      lobe_around(m.surface, mirrored_direction(m.surface, m.pyray.axis), m.pyray.right, width);
  const auto found = mirrored(m.pyray, m.surface, lobe);
  EXPECT_TRUE(found);
  return found.value_or(MirroredPyray{});
}

/// The point of the mirror plane where a corner's ray leaves it.
glm::dvec2 on_mirror(const PyrayPicture& picture, double u, double v) {
  const glm::dvec3 along = picture.corner + u * picture.right + v * picture.down;
  const glm::dvec3 p = picture.apex - picture.apex.z / along.z * along;
  return {p.x, p.y};
}

TEST(MirroredPyray, StartsAtTheMirroredApex) {
  const Meeting m = meeting(0.7, 0.1, 0.1);
  const MirroredPyray sharp = blurred(m, 0.0);
  const glm::dvec3 apex = -10.0 * m.pyray.axis;
  EXPECT_NEAR(sharp.picture.apex.x, apex.x, 1e-12);
  EXPECT_NEAR(sharp.picture.apex.z, -apex.z, 1e-12);
  EXPECT_EQ(sharp.sharp_share, glm::dvec2(1.0));
}

TEST(MirroredPyray, BlurredStartsFromItsPatch) {
  // The patch is small relative to its distance, so the corners' directions do not matter.
  const MirroredPyray wide = blurred(meeting(0.5, 1e-3, 1e-3), 1e-3);
  const glm::dvec2 a = on_mirror(wide.picture, 0.0, 0.5), b = on_mirror(wide.picture, 1.0, 0.5);
  EXPECT_NEAR(glm::distance(a, b), 1e-3 / std::cos(0.5), 2e-6);
  const glm::dvec2 c = on_mirror(wide.picture, 0.5, 0.0), d = on_mirror(wide.picture, 0.5, 1.0);
  EXPECT_NEAR(glm::distance(c, d), 1e-3, 2e-6);
}

// A surface adjacent to a strip of mirror, such as a frame around a pane, must not be part of the
// reflected pyray's start.
TEST(MirroredPyray, BlurredStaysWithinANarrowStrip) {
  for (const double tilt : {0.0, 0.6, 1.2}) {
    for (const auto& [right, down] : {std::pair{1e-3, 8e-3}, {8e-3, 1e-3}, {2e-3, 2e-3}}) {
      for (const double width : {1e-4, 1e-2, 0.05}) {
        const MirroredPyray wide = blurred(meeting(tilt, right, down), width);
        // The corners of a wide lobe diverge, so they leave a little farther out.
        const double lean = 1.0 + width * std::tan(tilt);
        for (const double u : {0.0, 1.0}) {
          for (const double v : {0.0, 1.0}) {
            const glm::dvec2 at = on_mirror(wide.picture, u, v);
            EXPECT_LE(std::abs(at.x), lean * 0.5 * right / std::cos(tilt) * 1.001)
                << tilt << " " << right << " " << width;
            EXPECT_LE(std::abs(at.y), lean * 0.5 * down * 1.001)
                << tilt << " " << down << " " << width;
          }
        }
      }
    }
  }
}

// A reflected pyray exists down to 1e-4 radian above the mirror, for any lobe.
TEST(MirroredPyray, IsFoundAtGrazingAngles) {
  for (const double above : {0.1, 1e-2, 2.4e-3, 1e-4}) {
    for (const double width : {1e-9, 1e-6, 1e-3, 0.1}) {
      for (const double aside : {0.0, 0.6}) {
        Meeting m = meeting(std::numbers::pi / 2.0 - above, 2e-2, 2e-2);
        // Skews the pyray as at the side of a wide picture, where pixels are seen at an angle.
        m.pyray.down = std::cos(aside) * m.pyray.down + std::sin(aside) * 2e-3 * m.pyray.axis;
        const MirrorLobe lobe = lobe_around(m.surface, mirrored_direction(m.surface, m.pyray.axis),
                                            m.pyray.right, width);
        const auto found = mirrored(m.pyray, m.surface, lobe);
        ASSERT_TRUE(found) << above << " " << width;
        EXPECT_GT(found->apex_distance, 0.0);
        EXPECT_LE(found->apex_distance, 10.0 * 1.001);
      }
    }
  }
}

}  // namespace
}  // namespace asos
