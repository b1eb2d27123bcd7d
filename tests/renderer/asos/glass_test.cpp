#include "tests/renderer/asos/glass_world.h"
#include "tests/support/shape_world.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

// Volumes of glass against closed forms of Snell's law.

namespace asos::test::glass {
namespace {

TEST(Glass, APlateShiftsWhatLiesBehindIt) {
  constexpr double n = 1.5, thickness = 0.4;
  for (const double degrees : {0.0, 30.0, 60.0}) {
    const double i = degrees * std::numbers::pi / 180.0;
    const double r = std::asin(std::sin(i) / n);
    const double shift = thickness * std::sin(i) * (1.0 - std::cos(i) / (n * std::cos(r)));
    World world;
    add_plate(world, i, thickness, clear(static_cast<float>(n)));
    add_edge(world, 0.0123, -6.0);
    const auto scene = make_render_scene(std::move(world));
    for (const Method method : methods) {
      const double seen = edge_in(picture(*scene, orthographic(1.0), method), 1.0);
      EXPECT_NEAR(seen, 0.0123 + shift, 1e-3)
          << degrees << " degrees, method " << static_cast<int>(method);
    }
  }
}

TEST(Glass, ABallTurnsRoundWhatLiesBeyondItsFocus) {
  constexpr double n = 1.5, radius = 1.0, width = 0.02, edge = 0.002;
  constexpr double focus = n * radius / (2.0 * (n - 1.0));
  for (const double distance : {1.2, 3.0, 6.0}) {
    World world;
    add_edge(world, edge, -distance);
    add_shape(world, sphere(radius), glm::dmat4(1.0), clear(static_cast<float>(n)));
    const auto scene = make_render_scene(std::move(world));
    // Paraxial rays at height h leave at h (1 - distance / focus).
    const double scale = 1.0 - distance / focus;
    for (const Method method : methods) {
      const std::vector<glm::vec3> seen = picture(*scene, orthographic(width), method);
      const double white = mean(seen).y * width;
      const double expected = scale > 0.0 ? 0.5 * width + edge / scale : 0.5 * width - edge / scale;
      EXPECT_NEAR(white / width, std::clamp(expected / width, 0.0, 1.0), 1e-3)
          << distance << ", method " << static_cast<int>(method);
    }
  }
}

/// Deviation of a ray by a prism of angle `a` at incidence `i` (closed form of Snell's law at both
/// faces).
double deviation(double n, double i, double a) {
  const double s = std::sin(i);
  return i + std::asin(std::sqrt(n * n - s * s) * std::sin(a) - s * std::cos(a)) - a;
}

/// A prism whose faces lean by half of its angle. Rays along -z hit one at that angle and are bent
/// towards its base, along -x.
void add_prism(World& world, double angle, const Material& material) {
  const double half = 0.5 * angle;
  add_bar(world, {{1.0, 0.0}, {-3.0, 4.0 * std::tan(half)}, {-3.0, -4.0 * std::tan(half)}}, 3.0f,
          material);
}

TEST(Glass, APrismTurnsRaysByItsAngleOfDeviation) {
  constexpr double far = 1e4;
  const double angle = 0.7;
  for (const double n : {1.33, 1.5, 1.7}) {
    const double turned = deviation(n, 0.5 * angle, angle);
    for (const double off : {-1e-3, 1e-3}) {
      World world;
      add_prism(world, angle, clear(static_cast<float>(n)));
      add_edge(world, -far * std::tan(turned + off), -far, 1e5);
      const auto scene = make_render_scene(std::move(world));
      for (const Method method : methods) {
        const glm::dvec3 seen = mean(picture(*scene, orthographic(0.5), method));
        EXPECT_NEAR(seen.y, off < 0.0 ? 1.0 : 0.0, 1e-3)
            << n << ", method " << static_cast<int>(method);
      }
    }
  }
}

TEST(Glass, DispersionSeparatesColours) {
  // The indices of red and blue are n -+ (n - 1) / (2 V); the dispersion is 20 / V.
  constexpr double n = 1.6, abbe = 25.0, far = 1e4;
  const double angle = 0.7;
  Material flint = clear(static_cast<float>(n));
  flint.volume.dispersion = static_cast<float>(20.0 / abbe);
  const double half = (n - 1.0) / (2.0 * abbe);
  const std::array<double, 3> indices{n - half, n, n + half};
  for (int c = 0; c < 3; ++c) {
    const double turned = deviation(indices[static_cast<std::size_t>(c)], 0.5 * angle, angle);
    for (const double off : {-1e-3, 1e-3}) {
      World world;
      add_prism(world, angle, flint);
      add_edge(world, -far * std::tan(turned + off), -far, 1e5);
      const auto scene = make_render_scene(std::move(world));
      for (const Method method : methods) {
        const glm::dvec3 seen = mean(picture(*scene, orthographic(0.5), method));
        for (int k = 0; k < 3; ++k) {
          // Blue is deviated most and red least; white is beyond the edge.
          const bool white = k > c || (k == c && off < 0.0);
          EXPECT_NEAR(seen[k], white ? 1.0 : 0.0, 1e-3)
              << "colour " << c << " " << k << ", method " << static_cast<int>(method);
        }
      }
    }
  }
}

// Half a cube: rays along -z hit its long face from inside at 45 degrees.
TEST(Glass, ReflectsAllBeyondTheCriticalAngle) {
  for (const double n : {1.35, 1.5}) {
    World world;
    add_bar(world, {{-1.0, 1.0}, {1.0, 1.0}, {1.0, -1.0}}, 1.0f, clear(static_cast<float>(n)));
    // Straight ahead is red; to the right, where rays are reflected, green.
    add_quad(world, {-50, -50, -20}, {100, 0, 0}, {0, 100, 0}, wall({1, 0, 0}));
    add_quad(world, {20, -20, -10}, {0, 40, 0}, {0, 0, 20}, wall({0, 1, 0}));
    const auto scene = make_render_scene(std::move(world));
    const bool total = n * std::sin(std::numbers::pi / 4.0) > 1.0;
    for (const Method method : methods) {
      const glm::dvec3 seen = mean(picture(*scene, orthographic(0.5), method));
      EXPECT_NEAR(seen.x, total ? 0.0 : 1.0, 1e-3) << n << ", " << static_cast<int>(method);
      EXPECT_NEAR(seen.y, total ? 1.0 : 0.0, 1e-3) << n << ", " << static_cast<int>(method);
    }
  }
}

/// The point of the plane at `z` that a ray along -z, off the axis, hits after passing a sphere of
/// radius 1.
std::optional<glm::dvec2> through_ball(glm::dvec2 at, double n, double z) {
  const double h2 = glm::dot(at, at);
  if (!(h2 < 1.0)) return std::nullopt;
  const auto bend = [](glm::dvec3 d, glm::dvec3 normal, double ratio) {
    const double c = -glm::dot(d, normal);
    return ratio * d + (ratio * c - std::sqrt(1.0 - ratio * ratio * (1.0 - c * c))) * normal;
  };
  const glm::dvec3 in(at, std::sqrt(1.0 - h2));
  glm::dvec3 d = bend({0, 0, -1}, in, 1.0 / n);
  const glm::dvec3 out = in - 2.0 * glm::dot(in, d) * d;
  d = bend(d, -out, n);
  const glm::dvec3 p = out + (z - out.z) / d.z * d;
  if (!(d.z < 0.0)) return std::nullopt;
  return glm::dvec2(p);
}

TEST(Glass, ABallShowsTheWholeOfAChequeredWall) {
  constexpr double n = 1.5, z = -3.0, width = 1.6;
  constexpr int cells = 40;
  const auto white = [](glm::dvec2 p) {
    return (static_cast<long>(std::floor(2.0 * p.x)) + static_cast<long>(std::floor(2.0 * p.y))) %
               2 ==
           0;
  };
  for (const bool mesh : {false, true}) {
    World world;
    for (int x = -cells; x < cells; ++x) {
      for (int y = -cells; y < cells; ++y) {
        const glm::dvec2 middle(0.5 * x + 0.25, 0.5 * y + 0.25);
        add_quad(world, {0.5f * static_cast<float>(x), 0.5f * static_cast<float>(y), z},
                 {0.5f, 0, 0}, {0, 0.5f, 0}, wall(glm::vec3(white(middle) ? 1.0f : 0.0f)));
      }
    }
    const Material glass = clear(static_cast<float>(n));
    if (mesh) {
      add_sphere(world, glm::vec3(0.0f), 1.0f, 400, glass);
    } else {
      add_shape(world, sphere(1.0), glm::dmat4(1.0), glass);
    }
    const auto scene = make_render_scene(std::move(world));
    const std::vector<glm::vec3> asos = picture(*scene, orthographic(width), Method::asos);
    constexpr int dense = 32;
    double squares = 0.0;
    int compared = 0;
    for (int y = 0; y < picture_side; ++y) {
      for (int x = 0; x < picture_side; ++x) {
        double sum = 0.0;
        bool all = true;
        for (int k = 0; k < dense * dense; ++k) {
          const glm::dvec2 in_pixel((k % dense + 0.5) / dense, (k / dense + 0.5) / dense);
          const glm::dvec2 at((x + in_pixel.x) / picture_side - 0.5,
                              0.5 - (y + in_pixel.y) / picture_side);
          const auto met = through_ball(width * at, n, z);
          all = all && met && std::max(std::abs(met->x), std::abs(met->y)) < 0.5 * cells;
          if (met) sum += white(*met);
        }
        if (!all) continue;
        const double off =
            static_cast<double>(asos[static_cast<std::size_t>(y * picture_side + x)].y) -
            sum / (dense * dense);
        squares += off * off;
        ++compared;
      }
    }
    EXPECT_GT(compared, 100);
    EXPECT_LT(std::sqrt(squares / compared), 0.02) << (mesh ? "a mesh" : "a shape");
  }
}

}  // namespace
}  // namespace asos::test::glass
