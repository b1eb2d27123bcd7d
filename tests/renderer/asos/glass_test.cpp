#include "renderer/shading/sky.h"
#include "tests/support/render_picture.h"
#include "tests/support/shape_world.h"
#include "tests/support/tiny_scene.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <optional>
#include <vector>

// Volumes of glass against closed forms: Snell's law, and Beer's and Lambert's.

namespace asos::test::glass_test {
namespace {

constexpr int picture_side = 12;  // of a picture, in pixels
constexpr std::array methods{Method::asos, Method::sobol};

/// Glass that reflects nothing, unless it has to reflect all.
Material clear(float index) {
  Material m = matte(glm::vec3(1.0f));
  m.roughness = 0.0f;
  m.specular = 0.0f;
  m.transmission = 1.0f;
  m.volume.thickness = 1.0f;
  m.ior = index;
  return m;
}

Material wall(glm::vec3 colour) {
  Material m = unlit(colour);
  m.double_sided = true;
  return m;
}

/// A convex solid around a point within it, one part: its faces by their corners.
void add_solid(World& world, const std::vector<std::vector<glm::vec3>>& faces, glm::vec3 within,
               const Material& material) {
  std::vector<TinyVertex> vertices;
  std::vector<glm::uvec3> triangles;
  for (std::vector<glm::vec3> face : faces) {
    glm::vec3 n = glm::normalize(glm::cross(face[1] - face[0], face[2] - face[0]));
    if (glm::dot(n, face[0] - within) < 0.0f) {
      std::reverse(face.begin(), face.end());
      n = -n;
    }
    const auto first = static_cast<std::uint32_t>(vertices.size());
    for (const glm::vec3 p : face) vertices.push_back({p, n, {0, 0}});
    for (std::uint32_t k = 2; k < face.size(); ++k)
      triangles.emplace_back(first, first + k - 1, first + k);
  }
  add_part(world, vertices, triangles, material);
}

/// An outline in the xz plane, drawn out along y.
void add_bar(World& world, const std::vector<glm::dvec2>& outline, float half_height,
             const Material& material) {
  std::vector<glm::vec3> low, high;
  glm::vec3 middle(0.0f);
  for (const glm::dvec2 p : outline) {
    low.emplace_back(p.x, -half_height, p.y);
    high.emplace_back(p.x, half_height, p.y);
    middle += low.back() + high.back();
  }
  std::vector<std::vector<glm::vec3>> faces{low, high};
  for (std::size_t i = 0; i < low.size(); ++i) {
    const std::size_t k = (i + 1) % low.size();
    faces.push_back({low[i], low[k], high[k], high[i]});
  }
  add_solid(world, faces, middle / static_cast<float>(2 * low.size()), material);
}

/// A plate through the origin, turned about y so that rays along -z meet it at this angle.
void add_plate(World& world, double angle, double thickness, const Material& material) {
  const glm::dvec2 out(std::sin(angle), std::cos(angle)), along(std::cos(angle), -std::sin(angle));
  const glm::dvec2 half = 0.5 * thickness * out;
  add_bar(world, {half - 5.0 * along, half + 5.0 * along, -half + 5.0 * along, -half - 5.0 * along},
          5.0f, material);
}

/// White where x is below an edge, black beyond.
void add_edge(World& world, double x, double z, double reach = 10.0) {
  const auto at = static_cast<float>(x), far = static_cast<float>(reach);
  const auto depth = static_cast<float>(z);
  add_quad(world, {at - far, -far, depth}, {far, 0, 0}, {0, 2 * far, 0}, wall(glm::vec3(1.0f)));
  add_quad(world, {at, -far, depth}, {far, 0, 0}, {0, 2 * far, 0}, wall(glm::vec3(0.0f)));
}

std::vector<glm::vec3> picture(const RenderScene& scene, const Camera& camera, Method method,
                               std::shared_ptr<const Sky> sky = nullptr) {
  RenderSettings settings;
  settings.width = settings.height = picture_side;
  settings.method = method;
  settings.sampling.spp = method == Method::asos ? 1 : 256;
  settings.sky = std::move(sky);
  return render_picture(scene, camera, settings).film.radiance;
}

glm::dvec3 mean(const std::vector<glm::vec3>& pixels) {
  glm::dvec3 sum(0.0);
  for (const glm::vec3 p : pixels) sum += glm::dvec3(p);
  return sum / static_cast<double>(pixels.size());
}

/// Where the edge between white on the left and black appears in a picture this wide.
double edge_in(const std::vector<glm::vec3>& pixels, double width) {
  return (mean(pixels).y - 0.5) * width;
}

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
    // Paraxial rays at h leave for h (1 - distance / focus).
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

/// By how much a prism of angle `a` turns a ray that meets it at `i` (closed form of Snell's law at
/// both faces).
double deviation(double n, double i, double a) {
  const double s = std::sin(i);
  return i + std::asin(std::sqrt(n * n - s * s) * std::sin(a) - s * std::cos(a)) - a;
}

/// A prism whose faces lean by half of its angle to either side: rays along -z meet one at that
/// angle and are turned towards its base, along -x.
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

TEST(Glass, DispersionPartsTheColours) {
  // n -+ (n - 1) / (2 V), of red and blue, and the dispersion is 20 / V.
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
          // Blue is turned most, red least; white lies beyond the edge.
          const bool white = k > c || (k == c && off < 0.0);
          EXPECT_NEAR(seen[k], white ? 1.0 : 0.0, 1e-3)
              << "colour " << c << " " << k << ", method " << static_cast<int>(method);
        }
      }
    }
  }
}

// Half a cube, whose long face rays along -z meet at 45 degrees from within.
TEST(Glass, ReflectsAllBeyondTheCriticalAngle) {
  for (const double n : {1.35, 1.5}) {
    World world;
    add_bar(world, {{-1.0, 1.0}, {1.0, 1.0}, {1.0, -1.0}}, 1.0f, clear(static_cast<float>(n)));
    // Straight on is red, to the right, where they are reflected, green.
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

TEST(Glass, AttenuatesByTheWayThroughIt) {
  constexpr double n = 1.5, thickness = 0.4;
  Material green = clear(static_cast<float>(n));
  green.volume.attenuation_color = {0.25f, 0.9f, 0.0f};
  green.volume.attenuation_distance = 0.5f;
  for (const double i : {0.0, 0.8}) {
    const double way = thickness / std::cos(std::asin(std::sin(i) / n));
    World world;
    add_plate(world, i, thickness, green);
    add_quad(world, {-50, -50, -20}, {100, 0, 0}, {0, 100, 0}, wall(glm::vec3(1.0f)));
    const auto scene = make_render_scene(std::move(world));
    for (const Method method : methods) {
      const glm::dvec3 seen = mean(picture(*scene, orthographic(0.5), method));
      EXPECT_NEAR(seen.x, std::pow(0.25, way / 0.5), 1e-3);
      EXPECT_NEAR(seen.y, std::pow(0.9, way / 0.5), 1e-3);
      EXPECT_NEAR(seen.z, 0.0, 1e-3);
    }
  }
}

TEST(Glass, AddsNoLight) {
  Material glass = clear(1.5f);
  glass.specular = 1.0f;
  const auto white = std::make_shared<const Sky>(glm::vec3(1.0f));
  for (const float roughness : {0.0f, 0.3f, 0.8f}) {
    glass.roughness = roughness;
    World world;
    add_shape(world, sphere(1.0), glm::dmat4(1.0), glass);
    const auto scene = make_render_scene(std::move(world));
    for (const Method method : methods) {
      const std::vector<glm::vec3> seen = picture(*scene, orthographic(2.2), method, white);
      EXPECT_LE(mean(seen).y, 1.001) << roughness << ", method " << static_cast<int>(method);
      if (roughness > 0.0f) continue;
      for (const glm::vec3 p : seen) {
        EXPECT_LE(p.y, 1.001f) << "method " << static_cast<int>(method);
        EXPECT_GE(p.y, 0.98f) << "method " << static_cast<int>(method);
      }
    }
  }
}

/// What a ray along -z beside the axis sees through a ball of radius 1: where it meets a plane.
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
}  // namespace asos::test::glass_test
