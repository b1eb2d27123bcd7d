#include "renderer/published/published_shadows.h"

#include "tests/support/make_light.h"
#include "tests/support/random_space.h"
#include "tests/support/shadow_fixture.h"
#include "tests/support/shadow_oracle.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

// The paper's shadow qualities (CGF'98 sections 4.2 to 4.3.4) against their definitions: the floor
// z = 0 seen from above, under a rectangular light partly hidden by a half-plane.

namespace asos::test::shadow_qualities_test {
namespace {

Light panel() {
  return make_panel({0.4, -0.2, 3}, {0, 0, -1}, {0.5, 0, 0}, {0, 0.3, 0});
}

/// A square pixel of an orthographic view of the floor.
struct Pixel {
  glm::dvec2 corner;
  double side;

  [[nodiscard]] Frame frame() const {
    return Frame::prism({corner, 10.0}, {0, 0, -1}, {side, 0, 0}, {0, side, 0});
  }
  [[nodiscard]] glm::dvec3 at(double u, double v) const {
    return {corner + side * glm::dvec2(u, v), 0.0};
  }
  /// Part i of n x n.
  [[nodiscard]] Pixel part(int n, int i) const {
    const double s = side / n;
    return {corner + s * glm::dvec2(i % n, i / n), s};
  }
};

/// A half-plane that hides some of the light from some points of the pixel.
struct Scene {
  World world;
  Polygon3 screen;
  Pixel pixel;
};

Scene random_scene(RandomSpace& random, double side) {
  Scene scene;
  scene.pixel = {{random.between(-1, 1), random.between(-1, 1)}, side};
  add_quad(scene.world, {-9, -9, 0}, {18, 0, 0}, {0, 18, 0}, matte({0.5f, 0.5f, 0.5f}));
  const Light light = panel();
  const glm::dvec3 on_light =
      light.position + random.between(-1, 1) * light.half_u + random.between(-1, 1) * light.half_v;
  const glm::dvec3 on_floor = scene.pixel.at(random.between(0, 1), random.between(0, 1));
  const glm::dvec3 through = on_floor + random.between(0.1, 0.8) * (on_light - on_floor);
  const glm::dvec3 along = glm::normalize(
      glm::dvec3(random.between(-1, 1), random.between(-1, 1), random.between(-0.05, 0.05)));
  const glm::dvec3 away = glm::cross(glm::dvec3(0, 0, 1), along);
  scene.screen = add_occluder(scene.world, through - 30.0 * along, 60.0 * along, 60.0 * away);
  return scene;
}

Receiver receiver_on_floor(glm::dvec3 position) {
  Receiver receiver{.position = position};
  receiver.normal = receiver.geometric = {0, 0, 1};
  return receiver;
}

/// Visible fraction of the light from a point of the floor.
double share_at(const Scene& scene, glm::dvec3 p) {
  const Receiver receiver = receiver_on_floor(p);
  const Polygon3 light = corners_of(panel());
  return seen_form(light, {scene.screen}, receiver) / form_of(light, receiver);
}

/// Mean of share_at over the centres of n x n parts of the pixel.
double mean_share(const Scene& scene, int n) {
  double sum = 0.0;
  for (int i = 0; i < n * n; ++i) sum += share_at(scene, scene.pixel.part(n, i).at(0.5, 0.5));
  return sum / (n * n);
}

double area_of(const Polygon3& polygon) {
  glm::dvec3 sum(0.0);
  for (std::size_t i = 2; i < polygon.size(); ++i)
    sum += glm::cross(polygon[i - 1] - polygon[0], polygon[i] - polygon[0]);
  return 0.5 * glm::length(sum);
}

/// Apex, behind the floor, of the pyray through the light's corners if it is `width` times as wide
/// at the floor as at the light. Its axis goes from the patch's centre to the light's.
glm::dvec3 source_behind(const Pixel& patch, double width) {
  const glm::dvec3 middle = patch.at(0.5, 0.5);
  return middle - width / (1.0 - width) * (panel().position - middle);
}

/// 4.3.2: the light's projection is the largest one inside the patch, at most 0.99 of the light's
/// width at the floor. Returns the fraction of the light that its source sees.
double extended_share(const Scene& scene, const Pixel& patch) {
  const Light light = panel();
  const double width =
      std::min(0.99, patch.side / (2.0 * std::max(light.half_u.x, light.half_v.y)));
  const Polygon3 corners = corners_of(light);
  return 1.0 - area_of(hidden_part(corners, scene.screen, source_behind(patch, width))) /
                   area_of(corners);
}

/// 4.3.4: patches are divided until they are inside the light's projection onto the floor along the
/// line between their centres. The projection is then the smallest one around the patch. Returns
/// the fraction of the patch that the light reaches through it.
double adaptive_share(const Scene& scene, const Pixel& patch) {
  const Light light = panel();
  const double width = patch.side / (2.0 * std::min(light.half_u.x, light.half_v.y));
  if (width > 0.99) {
    double sum = 0.0;
    for (int i = 0; i < 4; ++i) sum += 0.25 * adaptive_share(scene, patch.part(2, i));
    return sum;
  }
  const glm::dvec3 source = source_behind(patch, width);
  Polygon3 shaded{patch.at(0, 0), patch.at(1, 0), patch.at(1, 1), patch.at(0, 1)};
  const Polygon3& screen = scene.screen;
  const glm::dvec3 face = glm::cross(screen[1] - screen[0], screen[2] - screen[0]);
  const double side = glm::dot(face, source - screen[0]) > 0.0 ? 1.0 : -1.0;
  for (std::size_t i = 0; i < screen.size(); ++i)
    shaded = clip(shaded,
                  -side * glm::cross(screen[i] - source, screen[(i + 1) % screen.size()] - source),
                  source);
  return 1.0 - area_of(shaded) / (patch.side * patch.side);
}

double found_share(const Scene& scene, ShadowQuality quality, int divisions,
                   std::uint64_t seed = 1) {
  ShadowRules settings;
  const PublishedShadows published(quality, divisions);
  settings.area_shadows = &published;
  settings.error_budget.max_level = 4;
  settings.see_through = false;
  ShadowFixture fixture(scene.world, panel(), settings);
  SurfacePoint point{.position = glm::vec3(scene.pixel.at(0.5, 0.5)),
                     .error = glm::vec3(1e-6f, 1e-6f, 0.0f)};
  point.geometric_normal = point.shading_normal = {0, 0, 1};
  point.extent = 0.1f;
  point.triangle = 0;
  return fixture.visibility(point, scene.pixel.frame(),
                            leaf_of({{0.0f, 0.0f, 1.0f}, {}}, 1.0f, seed));
}

/// Compares the method with the definition, `exact`, over random scenes and several pixel sizes.
template <typename Exact>
void expect_definition(ShadowQuality quality, int divisions, const Exact& exact) {
  RandomSpace random(static_cast<std::uint64_t>(divisions) + 3);
  // Pixel sides from much smaller than the light's projection to larger.
  constexpr double sides[] = {0.03, 0.3, 0.55, 1.3};
  double worst = 0.0;
  int partly = 0;
  for (int i = 0; i < 150; ++i) {
    const Scene scene = random_scene(random, sides[i % 4]);
    const double expected = exact(scene);
    const double found = found_share(scene, quality, divisions);
    EXPECT_NEAR(found, expected, 1e-5) << i;
    worst = std::max(worst, std::abs(found - expected));
    partly += expected > 0.01 && expected < 0.99;
  }
  EXPECT_GT(partly, 60);
  testing::Test::RecordProperty("worst_error_" + std::to_string(divisions),
                                testing::PrintToString(worst));
}

TEST(ShadowQualities, CentreIsTheShareFromTheMiddle) {
  expect_definition(ShadowQuality::centre, 1,
                    [](const Scene& scene) { return share_at(scene, scene.pixel.at(0.5, 0.5)); });
}

TEST(ShadowQualities, ForcedIsTheMeanOverPartsMiddles) {
  for (const int n : {1, 2, 3})
    expect_definition(ShadowQuality::forced, n,
                      [n](const Scene& scene) { return mean_share(scene, n); });
}

TEST(ShadowQualities, ExtendedIsWhatItsSourceBehindTheSurfaceSees) {
  expect_definition(ShadowQuality::extended, 1,
                    [](const Scene& scene) { return extended_share(scene, scene.pixel); });
}

TEST(ShadowQualities, ExtendedDividedIsTheMeanOfItsParts) {
  for (const int n : {1, 2, 3})
    expect_definition(ShadowQuality::extended_divided, n, [n](const Scene& scene) {
      double sum = 0.0;
      for (int i = 0; i < n * n; ++i) sum += extended_share(scene, scene.pixel.part(n, i));
      return sum / (n * n);
    });
}

TEST(ShadowQualities, ExtendedAdaptiveIsTheLitPartOfThePatch) {
  expect_definition(ShadowQuality::extended_adaptive, 1,
                    [](const Scene& scene) { return adaptive_share(scene, scene.pixel); });
}

// The points differ between seeds, and their mean is that of the patch within five standard errors;
// the scenes are the same in every run.
TEST(ShadowQualities, SupersamplingIsUnbiased) {
  RandomSpace random(8);
  double spread = 0.0;
  for (int i = 0; i < 20; ++i) {
    const Scene scene = random_scene(random, 0.5);
    constexpr int count = 100;
    double sum = 0.0, sum2 = 0.0;
    for (int seed = 0; seed < count; ++seed) {
      const double share = found_share(scene, ShadowQuality::supersampling, 2,
                                       static_cast<std::uint64_t>(1000 * i + seed));
      sum += share;
      sum2 += share * share;
    }
    const double mean = sum / count;
    const double error = std::sqrt(std::max(0.0, sum2 / count - mean * mean) / (count - 1));
    EXPECT_NEAR(mean, mean_share(scene, 32), 5.0 * error + 1e-4) << i;
    spread += error;
  }
  EXPECT_GT(spread, 1e-3);
}

/// The mean visibility over the light's area, as measured by pyrays from behind the surface: they
/// see the light from no single point.
double mean_area_share(const Scene& scene, int n) {
  const Polygon3 light = corners_of(panel());
  double sum = 0.0;
  for (int i = 0; i < n * n; ++i)
    sum += 1.0 - area_of(hidden_part(light, scene.screen, scene.pixel.part(n, i).at(0.5, 0.5))) /
                     area_of(light);
  return sum / (n * n);
}

/// RMS error over random scenes, the same for all qualities.
double rms_error(ShadowQuality quality, int divisions, double side) {
  RandomSpace random(9);
  double sum2 = 0.0;
  constexpr int count = 60;
  for (int i = 0; i < count; ++i) {
    const Scene scene = random_scene(random, side);
    const double truth = quality == ShadowQuality::extended_divided ? mean_area_share(scene, 32)
                                                                    : mean_share(scene, 32);
    const double off =
        found_share(scene, quality, divisions, static_cast<std::uint64_t>(i)) - truth;
    sum2 += off * off / count;
  }
  return std::sqrt(sum2);
}

// With parts a quarter as wide, the error falls to a sixteenth for the centres of parts, even where
// the visibility is curved, and for jittered points, which are independent. Requires half of that.
// Pyrays from behind the surface pair each point of a part with one point of the light: their error
// only falls with the parts' width.
TEST(ShadowQualities, ConvergeToTheMeanOfThePatch) {
  const std::pair<ShadowQuality, double> cases[] = {{ShadowQuality::supersampling, 8.0},
                                                    {ShadowQuality::forced, 8.0},
                                                    {ShadowQuality::extended_divided, 3.0}};
  for (const auto& [quality, times] : cases) {
    for (const double side : {0.2, 0.5}) {
      const double coarse = rms_error(quality, 2, side), fine = rms_error(quality, 8, side);
      EXPECT_LT(fine, coarse / times) << static_cast<int>(quality) << ' ' << side;
      RecordProperty(
          "error_" + std::to_string(static_cast<int>(quality)) + "_" + std::to_string(side),
          testing::PrintToString(coarse) + " " + testing::PrintToString(fine));
    }
  }
}

}  // namespace
}  // namespace asos::test::shadow_qualities_test
