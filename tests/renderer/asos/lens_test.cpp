#include "tests/renderer/asos/lens_scenes.h"
#include "tests/support/make_light.h"
#include "tests/support/textured_scene.h"
#include "tests/support/tiny_image.h"
#include "tests/support/tiny_scene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <memory>
#include <numbers>
#include <utility>
#include <vector>

// Depth of field: pictures of unlit cards against closed forms, and against an independent sampler.

namespace asos::test::lens_test {
namespace {

Material card(glm::vec3 colour) {
  Material material = unlit(colour);
  material.double_sided = true;
  return material;
}

/// A card from x = `from` to `to`, with |y| <= 40, at a depth.
void add_wall(World& world, float depth, float from, float to, glm::vec3 colour) {
  add_quad(world, {from, -40, -depth}, {to - from, 0, 0}, {0, 80, 0}, card(colour));
}

/// Fraction of a disk of radius 1 with x < t.
double disk_left_of(double t) {
  t = std::clamp(t, -1.0, 1.0);
  return 0.5 + (t * std::sqrt(1.0 - t * t) + std::asin(t)) / pi;
}

/// Pixel value of a white half-plane left of column `edge`, blurred by a disk.
double blurred_edge(int x, double edge, double radius) {
  constexpr int steps = 4000;
  double sum = 0.0;
  for (int i = 0; i < steps; ++i) {
    const double s = x + (i + 0.5) / steps;
    sum += radius > 0.0 ? disk_left_of((edge - s) / radius) : (s < edge ? 1.0 : 0.0);
  }
  return sum / steps;
}

/// Independent of the renderer: R2 points in four dimensions (Roberts 2018), the aperture by
/// rejection. `seen`: red along a ray from (x, y, 0) with direction (dx, dy, -1).
double sampled_pixel(int px, int py, double radius,
                     const std::function<bool(glm::dvec2)>& in_aperture,
                     const std::function<double(glm::dvec2 from, glm::dvec2 along)>& seen) {
  constexpr int wanted = 65536;
  // The root of x^5 = x + 1.
  constexpr double phi = 1.1673039782614187;
  double sum = 0.0;
  int taken = 0;
  for (int i = 1; taken < wanted; ++i) {
    double p[4];
    for (int k = 0; k < 4; ++k) {
      const double at = 0.5 + i * std::pow(phi, -(k + 1));
      p[k] = at - std::floor(at);
    }
    const glm::dvec2 lens(2.0 * p[2] - 1.0, 2.0 * p[3] - 1.0);
    if (!in_aperture(lens)) continue;
    const glm::dvec2 from = radius * lens;
    const glm::dvec2 target((px + p[0] - 0.5 * side) * pixel, (0.5 * side - py - p[1]) * pixel);
    sum += seen(from, target - from / focus);
    ++taken;
  }
  return sum / taken;
}

bool in_disk(glm::dvec2 p) {
  return glm::length(p) <= 1.0;
}

TEST(Lens, EdgeOutOfFocusIsIntegralOfDisk) {
  constexpr float depth = 2.0f;
  for (const double confusion : {0.4, 1.0, 2.5}) {
    World world;
    add_wall(world, depth, -40.0f, 0.006f, glm::vec3(1.0f));
    const auto scene = make_render_scene(std::move(world));
    const double edge = 0.5 * side + 0.006 / (depth * pixel);
    std::vector<double> exact;
    for (int i = 0; i < side * side; ++i) exact.push_back(blurred_edge(i % side, edge, confusion));
    const Camera camera = camera_with(radius_for(confusion, depth));
    const Picture picture = render_picture(*scene, camera, settings_of(Method::asos));
    EXPECT_LT(rmse(reds(picture), exact), 1e-3) << confusion;
    const Picture sampled = render_picture(*scene, camera, settings_of(Method::sobol));
    EXPECT_LT(rmse(reds(sampled), exact), 2e-3) << confusion;
    // Pixels without blur take no samples.
    EXPECT_EQ(picture.film.cause[picture.film.index(0, 5)], SplitCause::none);
    EXPECT_EQ(picture.film.cause[picture.film.index(8, 5)], SplitCause::lens);
  }
}

TEST(Lens, PublishedWayWidensPyraysByDepth) {
  // Behind the focus plane, the blur of the background is as wide as that of the wall in front of
  // it.
  constexpr float depth = 2.0f;
  constexpr double confusion = 2.0;
  World world;
  add_wall(world, depth, -40.0f, 0.006f, glm::vec3(1.0f));
  const auto scene = make_render_scene(std::move(world));
  RenderSettings settings = settings_of(Method::asos_published);
  settings.asos.max_level = 4;
  const Picture picture =
      render_picture(*scene, camera_with(radius_for(confusion, depth)), settings);
  const double edge = 0.5 * side + 0.006 / (depth * pixel);
  const double width = std::sqrt(1.0 + 3.0 * confusion * confusion);
  for (int x = 0; x < side; ++x) {
    const double share = std::clamp(0.5 + (edge - x - 0.5) / width, 0.0, 1.0);
    // Cells of side 1/16 are point-sampled at their centres.
    EXPECT_NEAR(picture.film.radiance[picture.film.index(x, 7)].r, share, 1.0 / 32.0) << x;
  }
}

TEST(Lens, EdgesInFocusAreThoseOfAPinhole) {
  World world;
  add_wall(world, 4.0f, -40.0f, 0.024f, {0.9f, 0.0f, 0.0f});
  add_wall(world, 4.0f, 0.024f, 40.0f, {0.1f, 0.0f, 0.0f});
  const auto scene = make_render_scene(std::move(world));
  const RenderSettings settings = settings_of(Method::asos);
  const Picture sharp = render_picture(*scene, camera_with(0.0), settings);
  const Picture picture = render_picture(*scene, camera_with(0.5), settings);
  for (std::size_t i = 0; i < sharp.film.radiance.size(); ++i) {
    EXPECT_NEAR(picture.film.radiance[i].r, sharp.film.radiance[i].r, 1e-4) << i;
    EXPECT_NE(picture.film.cause[i], SplitCause::lens) << i;
  }
}

TEST(Lens, MattePlaneInFocusMatchesAPinhole) {
  World world;
  add_quad(world, {-40, -40, -4}, {80, 0, 0}, {0, 80, 0}, matte({0.8f, 0.5f, 0.2f}));
  const Light light = make_bulb({1, 1, 2}, 30.0f);
  const auto scene = make_render_scene(std::move(world), {light});
  for (const Method method : {Method::asos, Method::sobol}) {
    const RenderSettings settings = settings_of(method, 1.0 / 256.0);
    const Picture sharp = render_picture(*scene, camera_with(0.0), settings);
    const Picture picture = render_picture(*scene, camera_with(0.5), settings);
    for (std::size_t i = 0; i < sharp.film.radiance.size(); ++i)
      for (int c = 0; c < 3; ++c)
        EXPECT_NEAR(picture.film.radiance[i][c], sharp.film.radiance[i][c], 1e-4);
  }
}

TEST(Lens, SmallSphereBecomesDisk) {
  constexpr double depth = 2.0, confusion = 4.0, radius = 0.8 * depth * pixel;
  World world;
  const float brightness = 10.0f;
  add_sphere(world, {0, 0, -depth}, static_cast<float>(radius), 32, card(glm::vec3(brightness)));
  const auto scene = make_render_scene(std::move(world));
  const Camera camera = camera_with(radius_for(confusion, depth));
  RenderSettings settings = settings_of(Method::asos, 1e-3);
  const Picture picture = render_picture(*scene, camera, settings);
  // From a point of the aperture the sphere is a disk of this radius in pixels.
  const double seen = radius / std::sqrt(depth * depth - radius * radius) / pixel;
  const double plateau = brightness * seen * seen / (confusion * confusion);
  double sum = 0.0, inner = 0.0, outside = 0.0;
  int inside = 0;
  for (int i = 0; i < side * side; ++i) {
    const double value = picture.film.radiance[static_cast<std::size_t>(i)].r;
    const double distance = glm::length(glm::dvec2(i % side + 0.5, i / side + 0.5) - 0.5 * side);
    sum += value;
    if (distance < confusion - 1.6) inner += value, ++inside;
    outside += distance > confusion + 1.6 ? value : 0.0;
  }
  EXPECT_NEAR(sum / (brightness * pi * seen * seen), 1.0, 1e-2);
  EXPECT_NEAR(inner / inside / plateau, 1.0, 1e-2);
  EXPECT_EQ(outside, 0.0);
}

TEST(Lens, NearOccluderIsSeenThroughAtItsRim) {
  // Black up to x = 0.008 at depth 1; behind it an edge between white and grey, in focus.
  World world;
  add_wall(world, 1.0f, -40.0f, 0.008f, glm::vec3(0.0f));
  add_wall(world, 4.0f, -40.0f, 0.016f, glm::vec3(1.0f));
  add_wall(world, 4.0f, 0.016f, 40.0f, glm::vec3(0.25f));
  const auto scene = make_render_scene(std::move(world));
  const auto seen = [](glm::dvec2 from, glm::dvec2 along) {
    if (from.x + along.x < 0.008) return 0.0;
    return from.x + 4.0 * along.x < 0.016 ? 1.0 : 0.25;
  };
  for (const int blades : {0, 3, 6}) {
    const double radius = radius_for(2.0, 1.0);
    const auto in_polygon = [&](glm::dvec2 p) {
      for (int k = 0; k < blades; ++k) {
        const double a = 0.25 + 2.0 * pi * k / blades, b = 0.25 + 2.0 * pi * (k + 1) / blades;
        const glm::dvec2 from(std::cos(a), std::sin(a)), to(std::cos(b), std::sin(b));
        if ((to.x - from.x) * (p.y - from.y) < (to.y - from.y) * (p.x - from.x)) return false;
      }
      return true;
    };
    const Camera camera = camera_with(radius, blades);
    const Picture picture = render_picture(*scene, camera, settings_of(Method::asos));
    std::vector<double> row, expected;
    for (int x = 4; x < 13; ++x) {
      row.push_back(picture.film.radiance[picture.film.index(x, 3)].r);
      expected.push_back(blades == 0 ? sampled_pixel(x, 3, radius, in_disk, seen)
                                     : sampled_pixel(x, 3, radius, in_polygon, seen));
    }
    EXPECT_LT(rmse(row, expected), 2e-3) << blades;
  }
}

TEST(Lens, MaxDividesTheLensAsThePixel) {
  World world;
  add_wall(world, 2.0f, -40.0f, 0.006f, glm::vec3(1.0f));
  const auto scene = make_render_scene(std::move(world));
  RenderSettings settings = settings_of(Method::asos, 1e-5);
  for (const auto& [max_level, most] : {std::pair{1, 64.0f}, std::pair{2, 1024.0f}}) {
    settings.asos.max_level = max_level;
    const Picture picture = render_picture(*scene, camera_with(radius_for(2.5, 2.0)), settings);
    float rays = 0.0f;
    for (std::size_t i = 0; i < picture.film.rays.size(); ++i)
      if (picture.film.cause[i] == SplitCause::lens) rays = std::max(rays, picture.film.rays[i]);
    // Besides the samples, a few rays that choose the way.
    EXPECT_GE(rays, most) << max_level;
    EXPECT_LT(rays, most + 16.0f) << max_level;
  }
}

TEST(Lens, SmallLampsAreMetAtALargeEps) {
  // The lamp fills 1/200 of the blur, so that 16 samples miss it in nine pixels of ten.
  constexpr double depth = 2.0, confusion = 4.0, brightness = 100.0;
  const auto half = static_cast<float>(0.25 * depth * pixel);
  World world;
  add_quad(world, {-half, -half, -depth}, {2 * half, 0, 0}, {0, 2 * half, 0},
           card(glm::vec3(brightness)));
  Light lamp = make_panel({0, 0, -depth}, {0, 0, 1}, {half, 0, 0}, {0, half, 0}, brightness);
  lamp.own_part = 0;
  const auto scene = make_render_scene(std::move(world), {lamp});
  RenderSettings settings = settings_of(Method::asos, 1.0 / 64.0);
  settings.asos.max_level = 4;
  const Picture picture =
      render_picture(*scene, camera_with(radius_for(confusion, depth)), settings);
  std::vector<double> inside;
  for (int i = 0; i < side * side; ++i)
    if (glm::length(glm::dvec2(i % side + 0.5, i / side + 0.5) - 0.5 * side) < confusion - 1.2)
      inside.push_back(picture.film.radiance[static_cast<std::size_t>(i)].r);
  const double plateau = brightness * 0.25 / (pi * confusion * confusion);
  EXPECT_LT(rmse(inside, std::vector<double>(inside.size(), plateau)) / plateau, 0.1);
}

TEST(Lens, SmoothMeshesMayBendOutOfReach) {
  // Flat at depth 8 up to column 8.8, then smoothly away to depth 24 at column 11.6. The blur of 4
  // pixels at depth 8 does not reach the mesh's end, but that of 6.7 pixels at its end does.
  const std::vector<glm::dvec2> columns{{-400.0, 8.0}, {7.0, 8.0}, {8.8, 8.0}, {11.6, 24.0}};
  const auto x_of = [](glm::dvec2 column) { return (column.x - 0.5 * side) * pixel * column.y; };
  std::vector<TinyVertex> vertices;
  std::vector<glm::uvec3> triangles;
  for (const glm::dvec2 column : columns)
    for (const double y : {-40.0, 40.0})
      vertices.push_back({glm::vec3(x_of(column), y, -column.y), {0, 0, 1}, {0, 0}});
  for (std::uint32_t k = 0; k + 2 < vertices.size(); k += 2) {
    triangles.emplace_back(k, k + 2, k + 3);
    triangles.emplace_back(k, k + 3, k + 1);
  }
  World world;
  add_part(world, vertices, triangles, card(glm::vec3(1.0f)));
  const auto scene = make_render_scene(std::move(world));
  const auto seen = [&](glm::dvec2 from, glm::dvec2 along) {
    const auto at = [&](double depth) { return from.x + depth * along.x; };
    return at(8.0) < x_of(columns[2]) || at(24.0) < x_of(columns[3]) ? 1.0 : 0.0;
  };
  const double radius = radius_for(4.0, 8.0);
  const Picture picture =
      render_picture(*scene, camera_with(radius), settings_of(Method::asos, 1e-3));
  std::vector<double> row, expected;
  for (int x = 3; x < 9; ++x) {
    row.push_back(picture.film.radiance[picture.film.index(x, 7)].r);
    expected.push_back(sampled_pixel(x, 7, radius, in_disk, seen));
  }
  EXPECT_LT(rmse(row, expected), 2e-3);
  EXPECT_GT(1.0 - expected[2], 0.01) << "the mesh ends within the blur of pixel 5";
}

TEST(Lens, TexturesAreFilteredOverTheBlur) {
  // A fine checkerboard far out of focus is grey even with four samples per pixel.
  World world;
  Material material = card(glm::vec3(1.0f));
  const Image image = make_image(64, 64, [](int x, int y) {
    const std::uint8_t c = (x / 8 + y / 8) % 2 == 0 ? 255 : 0;
    return Texel{c, c, c, 255};
  });
  material.base_color_texture.texture = add_texture(world, image, Wrap::repeat, Filter::linear);
  add_quad(world, {-4, -4, -8}, {8, 0, 0}, {0, 8, 0}, material);
  // A square is 0.8 pixels wide.
  for (glm::vec2& uv : world.texcoords[0]) uv *= 8.0f / (8.0f * 0.064f);
  const auto scene = make_textured_scene(std::move(world));
  const Camera camera = camera_with(radius_for(3.0, 8.0));
  const auto noise = [&](TextureFilter filter) {
    RenderSettings settings = settings_of(Method::sobol);
    settings.sampling.spp = 4;
    settings.texture.filter = filter;
    std::vector<double> values = reds(render_picture(*scene, camera, settings));
    const std::vector<double> reference =
        reds(render_picture(*scene, camera, settings_of(Method::sobol)));
    return rmse(values, reference);
  };
  EXPECT_LT(noise(TextureFilter::footprint), 0.5 * noise(TextureFilter::point));
}

}  // namespace
}  // namespace asos::test::lens_test
