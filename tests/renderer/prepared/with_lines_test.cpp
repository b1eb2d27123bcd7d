#include "renderer/prepared/with_lines.h"

#include "tests/renderer/prepared/line_scenes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <utility>
#include <vector>

namespace asos::test::line_scenes {
namespace {

/// Position in the picture, in pixels from its centre, of a point in the author's coordinates.
glm::dvec2 projected(glm::dvec3 p, const Camera& camera, int height) {
  const bool perspective = camera.type == Camera::Type::perspective;
  const double tall =
      perspective ? 2.0 * std::tan(0.5 * camera.fov_y_rad) * (5.0 - p.z) : camera.height;
  return glm::dvec2(p) * (height / tall);
}

/// Number of red pixels, in front of the grey neutral sky.
double red_area(const Film& film) {
  double area = 0.0;
  const glm::vec3 sky = at(film, 0, 0);
  for (int y = 0; y < film.height; ++y) {
    for (int x = 0; x < film.width; ++x) {
      // Green measures how much of the sky is hidden.
      area += 1.0 - static_cast<double>(at(film, x, y).g) / static_cast<double>(sky.g);
      EXPECT_NEAR(at(film, x, y).r - at(film, x, y).g, red * (1.0f - at(film, x, y).g / sky.g),
                  2e-5f);
    }
  }
  return area;
}

double largest_difference(const Film& a, const Film& b) {
  double largest = 0.0;
  for (int y = 0; y < a.height; ++y) {
    for (int x = 0; x < a.width; ++x) {
      const glm::vec3 d = glm::abs(at(a, x, y) - at(b, x, y));
      largest = std::max<double>(largest, std::max({d.r, d.g, d.b}));
    }
  }
  return largest;
}

TEST(WithLines, ALineCoversItsRectangle) {
  for (const bool perspective : {true, false}) {
    for (const double width : {1.0, 2.5, 6.0}) {
      for (const double angle : {0.0, 0.3, 0.7853981, 1.2, 1.5707963}) {
        SCOPED_TRACE(testing::Message() << "perspective " << perspective << ", width " << width
                                        << ", angle " << angle);
        // One end is nearer than the other.
        const glm::dvec3 a(0.9 * std::cos(angle), 0.9 * std::sin(angle), 0.8);
        const glm::dvec3 b(-1.1 * std::cos(angle), -1.1 * std::sin(angle), -0.6);
        const auto scene = prepared(scene_of({lines({glm::vec3(a), glm::vec3(b)})}));
        const Camera camera = camera_for(*scene, perspective);
        const RenderSettings settings = settings_of(width);
        const double length = glm::length(projected(a, camera, settings.height) -
                                          projected(b, camera, settings.height));
        EXPECT_NEAR(red_area(picture_of(scene, camera, settings)) / (width * length), 1.0, 1e-3);
      }
    }
  }
}

TEST(WithLines, APointCoversItsDisk) {
  for (const double width : {1.0, 2.0, 5.0, 16.0}) {
    SCOPED_TRACE(testing::Message() << "width " << width);
    const auto scene = prepared(scene_of({points({{0.31f, 0.17f, 0.5f}, {-1.2f, -0.4f, -0.7f}})}));
    const Camera camera = camera_for(*scene);
    RenderSettings settings = settings_of(width);
    settings.asos.max_level = 7;
    const double disk = 0.25 * std::numbers::pi * width * width;
    EXPECT_NEAR(red_area(picture_of(scene, camera, settings)) / (2.0 * disk), 1.0, 1e-3);
  }
}

TEST(WithLines, OtherMethodsSeeTheSame) {
  const auto scene = prepared(scene_of({lines({{-0.7f, -0.6f, 0.0f}, {0.9f, 0.8f, 0.4f}})}));
  const Camera camera = camera_for(*scene);
  RenderSettings settings = settings_of(3.0);
  const double exact = red_area(picture_of(scene, camera, settings));
  settings.method = Method::sobol;
  settings.sampling.spp = 64;
  EXPECT_NEAR(red_area(picture_of(scene, camera, settings)) / exact, 1.0, 0.01);
}

TEST(WithLines, SurfacesHideLinesAndLinesHideSurfaces) {
  const Mesh wall = square(1.0f, 0.0f);
  const std::vector<glm::vec3> behind{{-0.8f, -0.7f, -0.5f}, {0.6f, 0.7f, -0.5f}};
  const std::vector<glm::vec3> before{{-0.8f, -0.7f, 0.5f}, {0.6f, 0.7f, 0.5f}};
  const auto hidden = prepared(scene_of({wall, lines(behind)}));
  const auto seen = prepared(scene_of({wall, lines(before)}));
  const Camera camera = camera_for(*hidden);
  const Film bare = picture_of(hidden, camera, settings_of(0.0));
  EXPECT_LT(largest_difference(picture_of(hidden, camera, settings_of(3.0)), bare), 1e-5);
  EXPECT_GT(largest_difference(picture_of(seen, camera, settings_of(3.0)), bare), 0.1);
}

TEST(WithLines, ALineUponASurfaceIsNotBuriedInIt) {
  // A line along the wall's diagonal: the whole ribbon is visible.
  const auto scene =
      prepared(scene_of({square(1.0f, 0.0f), lines({{-0.8f, -0.8f, 0.0f}, {0.8f, 0.8f, 0.0f}})}));
  const Camera camera = camera_for(*scene);
  const RenderSettings settings = settings_of(2.0);
  const Film film = picture_of(scene, camera, settings);
  double blackened = 0.0;
  const Film bare = picture_of(scene, camera, settings_of(0.0));
  for (int y = 0; y < film.height; ++y)
    for (int x = 0; x < film.width; ++x)
      if (at(bare, x, y).b > 0.0f) blackened += 1.0 - at(film, x, y).b / at(bare, x, y).b;
  const double length = 2.0 * glm::length(projected({0.8, 0.8, 0.0}, camera, settings.height));
  EXPECT_NEAR(blackened / (2.0 * length), 1.0, 0.01);
}

TEST(WithLines, ALineIsCutWhereItEntersASurface) {
  const auto scene =
      prepared(scene_of({square(1.0f, 0.0f), lines({{-0.8f, -0.3f, -0.9f}, {0.7f, 0.4f, 0.8f}})}));
  const Camera camera = camera_for(*scene);
  RenderSettings settings = settings_of(6.0);
  const auto drawn = with_lines(scene, line_picture(camera, settings)).value();
  EXPECT_GT(drawn->features().counts().intersection, 0u);
  const Picture exact = render_picture(*drawn, camera, settings);
  EXPECT_EQ(exact.statistics.missed_splits, 0u);
  settings.method = Method::sobol;
  settings.sampling.spp = 4096;
  EXPECT_LT(largest_difference(exact.film, render_picture(*drawn, camera, settings).film), 4e-3);
}

TEST(WithLines, LinesAndPointsCastNoShadows) {
  // Lines and points between the wall and its light, but outside the picture.
  std::vector<glm::vec3> near;
  for (int i = 0; i < 40; ++i) {
    const float x = -0.9f + 0.045f * static_cast<float>(i);
    near.insert(near.end(), {{x, -0.9f, 0.05f}, {x, 0.9f, 0.05f}});
  }
  Scene scene = scene_of({square(1.0f, 0.0f), lines(near), points(near)});
  for (Method method : {Method::asos, Method::sobol}) {
    for (const bool area_light : {false, true}) {
      SCOPED_TRACE(testing::Message() << static_cast<int>(method) << ", area " << area_light);
      if (area_light) {
        Light& lamp = scene.lights[0];
        lamp.type = Light::Type::rectangle;
        lamp.position = {0.2, 0.3, 3.0};
        lamp.direction = {0, 0, -1};
        lamp.half_u = {0.5, 0, 0};
        lamp.half_v = {0, 0.5, 0};
        lamp.intensity = 10.0f;
      }
      const auto ready = prepared(scene);
      // From behind the lines only the wall is visible.
      Camera camera = camera_for(*ready);
      camera.world_from_camera[3].z -= 4.98;
      camera.fov_y_rad = 2.5;
      RenderSettings settings = settings_of(2.0);
      settings.method = method;
      settings.asos.max_level = 3;
      settings.shadow.sky = true;
      const auto drawn = with_lines(ready, line_picture(camera, settings)).value();
      ASSERT_GT(drawn->world().lines_and_points.triangle_count, 0u);
      const Film bare = render_picture(*ready, camera, settings).film;
      EXPECT_LT(largest_difference(render_picture(*drawn, camera, settings).film, bare), 2e-5);
      EXPECT_GT(at(bare, 32, 24).g, 0.01f);
    }
  }
}

TEST(WithLines, NoneAreDrawnWithoutWidth) {
  const Mesh wall = square(1.0f, 0.0f);
  const auto with = prepared(scene_of({wall, lines({{-9, 0, 0}, {9, 3, 7}}), points({{5, 5, 5}})}));
  const auto without = prepared(scene_of({wall}));
  const Camera camera = camera_for(*without);
  const RenderSettings settings = settings_of(0.0);
  EXPECT_EQ(with_lines(with, line_picture(camera, settings)).value(), with);
  EXPECT_EQ(with_lines(without, line_picture(camera, settings_of(1.0))).value(), without);
  EXPECT_EQ(
      largest_difference(picture_of(with, camera, settings), picture_of(without, camera, settings)),
      0.0);
  // The same holds after the lines were drawn with a width.
  const auto drawn = with_lines(with, line_picture(camera, settings_of(1.0))).value();
  EXPECT_EQ(largest_difference(picture_of(drawn, camera, settings),
                               picture_of(without, camera, settings)),
            0.0);
}

TEST(WithLines, AnotherPictureReplacesTheFirstOnes) {
  const auto scene = prepared(
      scene_of({square(1.0f, 0.0f), lines({{-1, 0, 0}, {1, 1, 0.5f}}), points({{0, 1, 1}})}));
  const Camera first = camera_for(*scene);
  Camera second = first;
  second.world_from_camera[3] += glm::dvec4(0.3, 0.2, -1.0, 0.0);
  const auto picture = [](const Camera& camera, double width) {
    return line_picture(camera, settings_of(width));
  };
  const auto once = with_lines(scene, picture(first, 1.0)).value();
  const auto other = with_lines(once, picture(second, 4.0)).value();
  const auto again = with_lines(other, picture(first, 1.0)).value();
  EXPECT_NE(other->world().positions, once->world().positions);
  EXPECT_EQ(again->world().positions, once->world().positions);
  EXPECT_EQ(again->world().triangles, once->world().triangles);
  EXPECT_EQ(again->world().triangle_part, once->world().triangle_part);
  EXPECT_EQ(again->world().colors, once->world().colors);
  const auto none = with_lines(again, picture(first, 0.0)).value();
  EXPECT_EQ(none->world().positions, scene->world().positions);
  EXPECT_EQ(none->world().bounds.lo, scene->world().bounds.lo);
  EXPECT_EQ(none->world().bounds.hi, scene->world().bounds.hi);
}

TEST(WithLines, LinesThroughTheCameraAndWithoutLengthAreHarmless) {
  const auto scene = prepared(scene_of({square(1.0f, 0.0f),
                                        lines({{0, 0, 20},
                                               {0, 0, -20},  // along the view
                                               {0.1f, 0, 20},
                                               {0, 0.1f, -20},  // past the eye
                                               {0, 0, 5},
                                               {0, 1, 5},  // at the eye
                                               {0.5f, 0.5f, 1},
                                               {0.5f, 0.5f, 1}}),
                                        points({{0, 0, 5}, {0, 0, 9}})}));
  const Camera camera = camera_for(*scene);
  const auto drawn = with_lines(scene, line_picture(camera, settings_of(2.0))).value();
  for (const glm::vec3 p : drawn->world().positions)
    EXPECT_TRUE(std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z));
  const Film film = render_picture(*drawn, camera, settings_of(2.0)).film;
  for (int y = 0; y < film.height; ++y)
    for (int x = 0; x < film.width; ++x) EXPECT_TRUE(std::isfinite(at(film, x, y).r));
}

TEST(WithLines, WhatIsNotFiniteIsRefused) {
  Scene scene = scene_of({lines({{0, 0, 0}, {1, 0, 0}})});
  scene.instances[0].world_from_mesh[3].x = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(prepare(scene));
  scene.instances[0].world_from_mesh[3].x = 1e300;
  scene.meshes.push_back(square(1.0f, 0.0f));
  scene.instances.push_back({"wall", 1, glm::dmat4(1.0)});
  EXPECT_FALSE(prepare(scene));
}

TEST(WithLines, ASceneOfLinesAloneIsFramed) {
  const auto scene = prepared(scene_of({lines({{100, 7, 3}, {104, 9, 3}})}));
  const Camera camera = first_camera(scene->world(), 4.0 / 3.0);
  EXPECT_GT(red_area(picture_of(scene, camera, settings_of(2.0))), 2.0 * 40.0);
}

}  // namespace
}  // namespace asos::test::line_scenes
