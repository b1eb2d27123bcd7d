#include "renderer/asos/asos.h"

#include "renderer/comparison/method.h"
#include "renderer/shading/environment.h"
#include "tests/support/polygon_scene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <stop_token>

// The whole method against closed forms: unshaded white polygons on the grey background, so that a
// pixel's colour gives the covered area.

namespace asos::test::asos_test {
namespace {

constexpr int size = 16;  // pixels; pixel (x, y) is at (x / size - 0.5, 0.5 - y / size), depth 1

Camera camera() {
  // Looks down -Z; the picture is the unit square at distance 1, with its top left at (0, 0).
  return {.fov_y_rad = 2.0 * std::atan(0.5)};
}

glm::vec3 point(glm::dvec2 pixels, double depth) {
  return glm::vec3(glm::dvec3(pixels.x / size - 0.5, 0.5 - pixels.y / size, -1.0) * depth);
}

class Picture {
 public:
  /// A flat polygon at a depth, with corners in pixels.
  void add(const std::vector<glm::dvec2>& corners, double depth, glm::vec4 color) {
    std::vector<glm::vec3> points;
    for (const glm::dvec2& c : corners) points.push_back(point(c, depth));
    add(points, color);
  }

  void add(const std::vector<glm::vec3>& corners, glm::vec4 color) {
    Mesh mesh{.material = static_cast<int>(scene_.materials.size())};
    Material material{.base_color = color, .double_sided = true, .unlit = true};
    scene_.materials.push_back(material);
    mesh.positions = corners;
    mesh.normals.assign(corners.size(), glm::vec3(0, 0, 1));
    for (std::uint32_t i = 1; i + 1 < corners.size(); ++i) mesh.triangles.emplace_back(0, i, i + 1);
    Instance instance{.mesh = static_cast<int>(scene_.meshes.size())};
    scene_.meshes.push_back(mesh);
    scene_.instances.push_back(instance);
  }

  /// Renders the picture; sets `film` and `statistics`.
  void render(const RenderSettings& wanted) {
    Scene placed = scene_;
    const auto prepared = prepare(placed);
    ASSERT_TRUE(prepared.has_value()) << prepared.error().message();
    RenderSettings settings = wanted;
    settings.width = settings.height = size;
    Camera c = camera();
    c.world_from_camera[3] -= glm::dvec4((*prepared)->world().origin, 0.0);
    const View view(c, size, size);
    film = Film(size, size);
    for (int y = 0; y < size; y += block_size) {
      for (int x = 0; x < size; x += block_size) {
        const BlockResult block =
            render_block(**prepared, view, settings, {x, y, block_size, block_size});
        film.put(block.tile);
        statistics += block.statistics;
      }
    }
  }

  /// Fraction of a pixel that is white.
  [[nodiscard]] double white(int x, int y) const {
    return (static_cast<double>(film.radiance[film.index(x, y)].x) - sky_radiance) /
           (1.0 - sky_radiance);
  }

  Film film;
  RenderStatistics statistics;

 private:
  Scene scene_;
};

double covered(std::vector<glm::dvec2> polygon, int x, int y) {
  for (glm::dvec2& p : polygon) p -= glm::dvec2(x, y);
  return area(clip_to_unit_square(polygon));
}

RenderSettings asos_at(int max_level) {
  return {.asos = {.max_level = max_level, .eps = 0.0}};
}

TEST(Asos, StraightEdgesAreExactInEveryPixel) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  for (int i = 0; i < 30; ++i) {
    const glm::dvec2 p(size * unit(random), size * unit(random));
    const double angle = unit(random) * 2.0 * std::numbers::pi;
    const glm::dvec2 d(std::cos(angle), std::sin(angle)), n(-d.y, d.x);
    const std::vector<glm::dvec2> polygon{p - 99.0 * d, p + 99.0 * d, p + 99.0 * (d + n),
                                          p + 99.0 * (n - d)};
    Picture picture;
    picture.add(polygon, 3.0, glm::vec4(1.0f));
    picture.render(asos_at(4));
    for (int y = 0; y < size; ++y) {
      for (int x = 0; x < size; ++x) {
        // Vertices are floats: an error of 1e-7 relative to a polygon 200 pixels long.
        ASSERT_NEAR(picture.white(x, y), covered(polygon, x, y), 1e-4)
            << "case " << i << " pixel " << x << ", " << y;
      }
    }
    EXPECT_EQ(picture.statistics.missed_splits, 0u);
    EXPECT_EQ(picture.statistics.unresolved_area, 0.0);
  }
}

TEST(Asos, ASliverOfAFiftiethOfAPixelKeepsItsAreaAtMaxFour) {
  std::mt19937 random(12);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  for (int i = 0; i < 30; ++i) {
    const glm::dvec2 p(2.0 + (size - 4.0) * unit(random), 2.0 + (size - 4.0) * unit(random));
    const double angle = unit(random) * 2.0 * std::numbers::pi;
    const glm::dvec2 d(std::cos(angle), std::sin(angle)), n = 0.01 * glm::dvec2(-d.y, d.x);
    const std::vector<glm::dvec2> polygon{p - 40.0 * d - n, p + 40.0 * d - n, p + 40.0 * d + n,
                                          p - 40.0 * d + n};
    Picture picture;
    picture.add(polygon, 2.0, glm::vec4(1.0f));
    picture.render(asos_at(4));
    double white = 0.0;
    double truth = 0.0;
    for (int y = 0; y < size; ++y) {
      for (int x = 0; x < size; ++x) {
        white += picture.white(x, y);
        truth += covered(polygon, x, y);
      }
    }
    EXPECT_NEAR(white, truth, 0.01 * truth) << "case " << i;
  }
}

TEST(Asos, PixelsWithoutBoundariesAreOneSample) {
  Picture picture;
  picture.add({{-9, -9}, {40, -9}, {40, 40}, {-9, 40}}, 1.0, glm::vec4(1.0f));
  // Hidden geometry, which must not add cost.
  std::mt19937 random(13);
  std::uniform_real_distribution<double> unit(0.0, 16.0);
  for (int i = 0; i < 100; ++i) {
    const glm::dvec2 c(unit(random), unit(random));
    picture.add({c, c + glm::dvec2(0.5, 0.1), c + glm::dvec2(0.2, 0.7)}, 4.0 + i, glm::vec4(0.5f));
  }
  picture.render(asos_at(4));
  EXPECT_EQ(picture.statistics.eye_rays, static_cast<std::uint64_t>(size * size));
  EXPECT_EQ(picture.statistics.split_pixels, 0u);
  for (const glm::vec3& c : picture.film.radiance) EXPECT_EQ(c, glm::vec3(1.0f));
}

// Two walls that intersect: no mesh edge marks their line of intersection.
TEST(Asos, WallsThatPassThroughEachOtherMeetInAnExactLine) {
  // The wall z = -3, and one that intersects it along the line x = 7.3 pixels.
  const double x = 7.3;
  Picture picture;
  picture.add({{-9, -9}, {40, -9}, {40, 40}, {-9, 40}}, 3.0,
              glm::vec4(glm::vec3(sky_radiance), 1.0f));
  picture.add({point({-90, -90}, 3.0 + 1.0), point({x, -90}, 3.0), point({x, 90}, 3.0),
               point({-90, 90}, 3.0 + 1.0)},
              glm::vec4(1.0f));
  picture.add({point({x, -90}, 3.0), point({90, -90}, 3.0 - 1.0), point({90, 90}, 3.0 - 1.0),
               point({x, 90}, 3.0)},
              glm::vec4(1.0f));
  picture.render(asos_at(3));
  EXPECT_EQ(picture.statistics.missed_splits, 0u);
  for (int y = 0; y < size; ++y) {
    for (int column = 0; column < size; ++column) {
      const double truth = std::clamp(column + 1 - x, 0.0, 1.0);
      ASSERT_NEAR(picture.white(column, y), truth, 1e-4) << column << ", " << y;
    }
  }
}

TEST(Asos, KeepsUniformGreyAtEveryLevel) {
  Picture picture;
  std::mt19937 random(14);
  std::uniform_real_distribution<double> unit(0.0, 16.0);
  for (int i = 0; i < 60; ++i) {
    const glm::dvec2 c(unit(random), unit(random));
    picture.add({c, c + glm::dvec2(3, 1) * unit(random) / 16.0, c + glm::dvec2(1, 3)},
                2.0 + 0.1 * i, glm::vec4(0.5f, 0.5f, 0.5f, 1.0f));
  }
  picture.add({{-9, -9}, {40, -9}, {40, 40}, {-9, 40}}, 30.0, glm::vec4(0.5f, 0.5f, 0.5f, 1.0f));
  // All surfaces have the same grey, so every pixel must have it, however it is split.
  for (const LeafKind leaf : {LeafKind::exact, LeafKind::point}) {
    for (int k = 0; k <= 8; k += 2) {
      Picture one = picture;
      RenderSettings settings = asos_at(k);
      settings.asos.leaf = leaf;
      settings.asos.jitter = k == 4;
      one.render(settings);
      for (const glm::vec3& c : one.film.radiance) ASSERT_NEAR(c.x, 0.5f, 1e-6f) << "MAX " << k;
    }
  }
}

TEST(Asos, OnceStoppedItCastsNoMoreRays) {
  Scene scene;
  Mesh mesh{.positions = {point({1, 1}, 2.0), point({7, 2}, 2.0), point({2, 7}, 2.0)}};
  mesh.normals.assign(3, glm::vec3(0, 0, 1));
  mesh.triangles = {{0, 1, 2}};
  scene.meshes.push_back(mesh);
  Instance instance{.mesh = 0};
  scene.instances.push_back(instance);
  const auto prepared = prepare(scene);
  ASSERT_TRUE(prepared.has_value());
  const View view(default_camera((*prepared)->world(), 1.0), size, size);
  std::stop_source source;
  const PixelRect block{0, 0, block_size, block_size};
  const BlockResult whole =
      render_block_asos({**prepared, view, asos_at(8), block, source.get_token()});
  source.request_stop();
  const BlockResult stopped =
      render_block_asos({**prepared, view, asos_at(8), block, source.get_token()});
  EXPECT_GT(whole.statistics.shadow_rays + whole.statistics.eye_rays, 64u);
  EXPECT_EQ(stopped.statistics.shadow_rays, 0u);
  EXPECT_LE(stopped.statistics.eye_rays, 64u);
}

// Errors against the exact areas decrease with MAX.
TEST(Asos, ConvergesToTheExactPicture) {
  Picture picture;
  std::mt19937 random(15);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  for (int i = 0; i < 80; ++i) {
    const glm::dvec2 c(16.0 * unit(random), 16.0 * unit(random));
    const auto side = [&] {
      return glm::dvec2(4.0 * unit(random) - 2.0, 4.0 * unit(random) - 2.0);
    };
    const float grey = static_cast<float>(unit(random));
    picture.add({c, c + side(), c + side()}, 2.0 + 0.1 * i, glm::vec4(grey, grey, grey, 1.0f));
  }
  Picture truth = picture;
  RenderSettings settings{.method = Method::beam};
  truth.render(settings);
  const auto rmse = [&](int max_level) {
    Picture one = picture;
    one.render(asos_at(max_level));
    double sum = 0.0;
    for (std::size_t i = 0; i < one.film.radiance.size(); ++i) {
      const double d = one.film.radiance[i].x - truth.film.radiance[i].x;
      sum += d * d;
    }
    return std::sqrt(sum / static_cast<double>(one.film.radiance.size()));
  };
  const double coarse = rmse(0), middle = rmse(1), fine = rmse(3);
  EXPECT_LT(middle, 0.5 * coarse);
  EXPECT_LT(fine, 0.5 * middle);
  EXPECT_LT(fine, 1e-4);
}

}  // namespace
}  // namespace asos::test::asos_test
