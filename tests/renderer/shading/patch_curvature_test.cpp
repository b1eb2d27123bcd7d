#include "renderer/shading/patch_curvature.h"

#include "tests/support/white_lobe.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

namespace asos::test::patch_bend_test {
namespace {

// A sphere around the origin, seen from above by oblique parallel rays.
constexpr double radius = 2.0;
const glm::dvec3 to_viewer = glm::normalize(glm::dvec3(0.3, -0.2, 1.0));

/// The point of the sphere on the ray through a point of the tangent plane.
glm::dvec3 met(glm::dvec3 on_plane) {
  const double b = glm::dot(on_plane, to_viewer);
  const double c = glm::dot(on_plane, on_plane) - radius * radius;
  return on_plane + (-b + std::sqrt(b * b - c)) * to_viewer;
}

std::vector<PatchCurvature::Point> points_of(const PatchCurvature& bend, const ViewedPoint& view,
                                             const ViewedMaterial& material,
                                             PatchCurvature::Parts parts = {}) {
  std::vector<PatchCurvature::Point> points;
  bend.for_each_point(view, material, parts,
                      [&](const PatchCurvature::Point& at) { points.push_back(at); });
  return points;
}

struct Found {
  double place = 0.0, normal = 0.0;  ///< largest deviation from the true sphere
};

/// The largest errors of the points of a patch. Its edges are about `size` long; its centre is
/// the point of the sphere that has this normal.
Found errors(double size, glm::dvec3 normal) {
  SurfacePoint middle;
  middle.position = glm::vec3(radius * normal);
  middle.geometric_normal = middle.shading_normal = glm::vec3(normal);
  ViewedPoint view = viewed_point(middle, glm::vec3(to_viewer));
  const glm::dvec3 right = size * glm::normalize(glm::cross(normal, glm::dvec3(0.0, 1.0, 0.3)));
  const glm::dvec3 down = 0.7 * size * glm::normalize(glm::cross(normal, right) + 0.4 * right);
  view.patch = {glm::vec3(right), glm::vec3(down)};
  PatchCurvature bend{{glm::vec3(right / radius), glm::vec3(down / radius)}};
  bend.rounded = true;
  Found found;
  const std::vector<PatchCurvature::Point> points = points_of(bend, view, {});
  const double node = 0.5 / std::sqrt(3.0);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double u = i % 2 == 0 ? -node : node, v = i < 2 ? -node : node;
    const glm::dvec3 exact = met(radius * normal + u * right + v * down);
    const SurfacePoint& at = points[i].surface;
    found.place = std::max(found.place, glm::distance(glm::dvec3(at.position), exact));
    found.normal =
        std::max(found.normal, glm::distance(glm::dvec3(at.shading_normal), exact / radius));
    EXPECT_EQ(at.geometric_normal, at.shading_normal);
  }
  return found;
}

// The points are those on the viewer's rays, up to third order.
TEST(PatchCurvature, FindsThePointsOfABall) {
  for (const glm::dvec3 n : {glm::dvec3(0, 0, 1), {0.3, 0.5, 1.0}, {-0.9, 0.2, 0.8}}) {
    const glm::dvec3 normal = glm::normalize(n);
    const Found wide = errors(0.4, normal), narrow = errors(0.2, normal);
    EXPECT_LT(wide.place, 5e-3);
    EXPECT_LT(wide.normal, 2.5e-3);
    EXPECT_LT(narrow.place, wide.place / 6.0) << "third order";
    EXPECT_LT(narrow.normal, wide.normal / 6.0);
  }
}

/// A horizontal square, seen from above.
struct FlatPatch {
  FlatPatch() {
    middle.geometric_normal = middle.shading_normal = {0, 0, 1};
    view.patch = {{0.1f, 0, 0}, {0, 0.1f, 0}};
  }
  SurfacePoint middle;
  ViewedPoint view{middle, {0, 0, 1}, 1.0f};
};

// A flat patch under a distant light is uniform. One with varying normals is not, the more so the
// narrower its lobe; a variation narrower than the highlight needs no parts.
TEST(PatchCurvature, DependsOnTheLobe) {
  const FlatPatch flat;
  PreparedLight sun;
  sun.shape = LightShape::sun;
  std::optional<PatchCurvature::Parts> parts;
  const auto error = [&](float turn, float roughness, float half_angle_tangent,
                         glm::vec3 direction = {0, 0, 1}) {
    PatchCurvature bend;
    bend.turn.right = {turn, 0, 0};
    const Highlight highlight{direction, half_angle_tangent};
    const PatchCurvature::CentreEstimate found =
        bend.of_middle(flat.view, white_lobe(roughness), sun, highlight);
    parts = found.parts;
    return found.error;
  };
  EXPECT_EQ(error(0.0f, 0.3f, 0.1f), 0.0f);
  // turn^2 / (6 alpha^2), because the half vector equals the nearest of its normals.
  EXPECT_FLOAT_EQ(error(0.02f, 0.3f, 0.1f), 0.02f * 0.02f / (6.0f * 0.09f * 0.09f));
  EXPECT_GT(error(0.02f, 0.2f, 0.1f), 4.0f * error(0.02f, 0.3f, 0.1f));
  ASSERT_TRUE(parts);
  EXPECT_EQ(parts->right * parts->down, 1);
  EXPECT_EQ(error(0.3f, 0.3f, 0.1f), 1.0f);
  ASSERT_TRUE(parts);
  EXPECT_EQ(parts->right, 2);
  EXPECT_EQ(parts->down, 1) << "the normals vary along one edge only";
  (void)error(0.3f, 0.3f, 0.4f);
  EXPECT_EQ(parts->right, 1) << "the highlight is wider than the variation";
  (void)error(0.9f, 0.3f, 0.1f);
  EXPECT_FALSE(parts);
  const glm::vec3 low = glm::normalize(glm::vec3(1.0f, 0.0f, 0.01f));
  EXPECT_EQ(error(0.02f, 1.0f, 0.1f, low), 1.0f) << "the light sets within the patch";
  EXPECT_LT(error(0.005f, 1.0f, 0.1f, low), 1e-4f);
}

// A rotation about the normal rotates the lobe.
TEST(PatchCurvature, TurnsTheStretch) {
  const FlatPatch flat;
  PatchCurvature bend;
  bend.stretch_turn = {0.6f, 0.0f};
  ViewedMaterial material{};
  material.lobe.stretch.along = {0.5f, 0, 0};
  const std::vector<PatchCurvature::Point> points = points_of(bend, flat.view, material);
  const float angle = 0.6f * 0.5f / std::sqrt(3.0f);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const glm::vec3 along = points[i].material.lobe.stretch.along;
    EXPECT_NEAR(along.x, 0.5f * std::cos(angle), 1e-6f);
    EXPECT_NEAR(along.y, (i % 2 == 0 ? -0.5f : 0.5f) * std::sin(angle), 1e-6f);
  }
}

// With three by two parts, each has two points along each edge, with the same mean.
TEST(PatchCurvature, DividesWidePatches) {
  const FlatPatch flat;
  const auto points = points_of(PatchCurvature{}, flat.view, {}, {3, 2});
  ASSERT_EQ(points.size(), 24u);
  double mean = 0.0, square = 0.0, fourth = 0.0;
  for (const PatchCurvature::Point& at : points) {
    const double x = 10.0 * static_cast<double>(at.surface.position.x);  // -1/2 to 1/2
    mean += x / 24.0;
    square += x * x / 24.0;
    fourth += x * x * x * x / 24.0;
  }
  EXPECT_NEAR(mean, 0.0, 1e-6);
  EXPECT_NEAR(square, 1.0 / 12.0, 1e-6) << "exact to the third degree";
  EXPECT_NEAR(fourth, 1.0 / 80.0 - 1.0 / (180.0 * 81.0), 1e-6)
      << "the error of parts a third as wide";
}

}  // namespace
}  // namespace asos::test::patch_bend_test
