#include "renderer/geometry/face_crossings.h"
#include "renderer/shading/environment.h"
#include "tests/support/make_light.h"
#include "tests/support/make_settings.h"
#include "tests/support/render_picture.h"
#include "tests/support/shape_world.h"
#include "tests/support/tiny_scene.h"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

// Pictures of analytic shapes: their coverage against closed forms and against many samples.

namespace asos::test::shape_pictures_test {
namespace {

Material white() {
  Material material = unlit(glm::vec3(1.0f));
  material.double_sided = true;
  return material;
}

Camera looking(glm::dvec3 from, glm::dvec3 at) {
  return {.world_from_camera = glm::inverse(glm::lookAt(from, at, glm::dvec3(0, 1, 0))),
          .fov_y_rad = 0.6};
}

/// Fraction of a pixel inside a conic. Along a line of the picture the conic's value is a parabola,
/// whose roots are known in closed form; integrates over lines.
template <typename Value>
double area_inside(double x, double y, Value value) {
  const auto length = [&](double v) {
    // f(x + s) = c + b s + a s^2 on 0 <= s <= 1.
    const double f0 = value(x, v), fm = value(x + 0.5, v), f1 = value(x + 1.0, v);
    const double a = 2.0 * (f0 + f1) - 4.0 * fm, b = f1 - f0 - a;
    const double square = b * b - 4.0 * a * f0;
    if (square <= 0.0) return f0 > 0.0 ? 1.0 : 0.0;
    const double q = -0.5 * (b + std::copysign(std::sqrt(square), b));
    std::array<double, 4> cuts{0.0, q / a, f0 / q, 1.0};
    for (double& c : cuts) c = c > 0.0 ? std::min(c, 1.0) : 0.0;
    std::sort(cuts.begin(), cuts.end());
    double inside = 0.0;
    for (std::size_t i = 0; i < 3; ++i) {
      const double s = 0.5 * (cuts[i] + cuts[i + 1]);
      if (f0 + s * (b + s * a) > 0.0) inside += cuts[i + 1] - cuts[i];
    }
    return inside;
  };
  // Pixels completely inside or outside, with a margin of 1/4 pixel.
  bool all_in = true, all_out = true;
  for (int i = 0; i <= 12; ++i) {
    for (int k = 0; k <= 12; ++k) {
      const bool in = value(x - 0.25 + 0.125 * i, y - 0.25 + 0.125 * k) > 0.0;
      (in ? all_out : all_in) = false;
    }
  }
  if (all_in || all_out) return all_in ? 1.0 : 0.0;
  constexpr int lines = 4000;
  double sum = 0.0;
  for (int i = 0; i < lines; ++i) sum += length(y + (i + 0.5) / lines);
  return sum / lines;
}

/// Positive if the ray through a point of the picture hits the face's quadric or disk.
class Conic {
 public:
  Conic(const ShapeFace& face, const Camera& camera, int size)
      : face_(face), frame_(View(camera, size, size).frame(0, 0, size, size)), size_(size) {}

  double operator()(double x, double y) const {
    const glm::dvec3 at = (x / size_) * frame_.base_u() + (y / size_) * frame_.base_v();
    glm::dvec3 o = frame_.apex(), d = at + frame_.base_corner();
    if (frame_.parallel()) o += at, d = frame_.direction();
    o = face_.unit(o), d = face_.unit_from_world * d;
    if (face_.kind == ShapeFace::Kind::disk) {
      // The point (o + t d) at height 0, multiplied by d.y.
      const glm::dvec3 p = o * d.y - d * o.y;
      return d.y * d.y - p.x * p.x - p.z * p.z;
    }
    const double od = glm::dot(o, d);
    return od * od - glm::dot(d, d) * (glm::dot(o, o) - 1.0);
  }

 private:
  ShapeFace face_;
  Frame frame_;
  double size_;
};

struct Worst {
  double error = 0.0;
  double total = 0.0;  ///< signed error summed over pixels
  int partial = 0;
};

Worst compare(const Shape& shape, const glm::dmat4& place, const Camera& camera, int size) {
  World world;
  add_shape(world, shape, place, white());
  const auto scene = make_render_scene(world);
  RenderSettings settings = make_settings(size, size);
  settings.asos.max_level = 3;
  settings.asos.eps = 0.0;
  const Picture picture = render_picture(*scene, camera, settings);
  EXPECT_EQ(picture.statistics.missed_splits, 0u);
  const Conic conic(world.faces[0], camera, size);
  Worst worst;
  for (int y = 0; y < size; ++y) {
    for (int x = 0; x < size; ++x) {
      const double truth = area_inside(x, y, conic);
      const double radiance = picture.film.radiance[picture.film.index(x, y)].x;
      const double shown = (radiance - sky_radiance) / (1.0 - sky_radiance);
      worst.partial += truth > 0.0 && truth < 1.0;
      worst.total += shown - truth;
      worst.error = std::max(worst.error, std::abs(shown - truth));
    }
  }
  return worst;
}

struct Place {
  std::string name;
  glm::dmat4 matrix;
};

std::vector<Place> places() {
  const glm::dmat4 turned = glm::rotate(glm::dmat4(1.0), 0.8, glm::normalize(glm::dvec3(2, 1, -1)));
  return {{"round", turned},
          {"stretched", turned * glm::scale(glm::dmat4(1.0), glm::dvec3(1.1, 0.3, 0.7))}};
}

glm::dmat4 moved(double x, double y, double z) {
  return glm::translate(glm::dmat4(1.0), glm::dvec3(x, y, z));
}

void add_floor(World& world) {
  add_quad(world, {-6, -1, 6}, {12, 0, 0}, {0, 0, -12}, matte({0.7f, 0.6f, 0.5f}));
}

/// Shapes above a floor.
World floating() {
  World world;
  add_floor(world);
  add_shape(world, sphere(0.6), moved(-1.6, -0.2, 0.4), matte({0.8f, 0.2f, 0.2f}));
  add_shape(world, cylinder(1.2, 0.4, 0.4), moved(-0.3, -0.1, -1.0), matte({0.2f, 0.8f, 0.2f}));
  add_shape(world, cylinder(1.3, 0.5, 0.0), moved(0.8, -0.2, 0.0), matte({0.2f, 0.3f, 0.9f}));
  add_shape(world, cylinder(0.8, 0.5, 0.25), moved(2.0, -0.3, -0.6), matte({0.8f, 0.8f, 0.2f}));
  Material paint = matte({0.9f, 0.5f, 0.1f});
  paint.double_sided = true;
  add_shape(world, disk(0.5),
            glm::rotate(moved(0.2, -0.3, 1.5), 0.5, glm::normalize(glm::dvec3(1, 0, -1))), paint);
  return world;
}

/// Shapes that stand on a floor or intersect it, and a wall through some of them.
World crossing() {
  World world;
  add_floor(world);
  add_quad(world, {-3, -1, -0.8f}, {6, 0, 0}, {0, 1.2f, 0.3f}, matte({0.3f, 0.6f, 0.6f}));
  add_shape(world, sphere(0.7), moved(-1.6, -0.8, 0.6), matte({0.8f, 0.2f, 0.2f}));
  add_shape(world, cylinder(1.2, 0.4, 0.4), moved(-0.4, -0.4, -0.6), matte({0.2f, 0.8f, 0.2f}));
  add_shape(world, cylinder(1.3, 0.6, 0.0),
            glm::rotate(moved(0.9, -0.7, 0.3), 0.8, glm::dvec3(0, 0, 1)),
            matte({0.2f, 0.3f, 0.9f}));
  add_shape(world, cylinder(0.8, 0.5, 0.25), moved(2.0, -0.6, -0.9), matte({0.8f, 0.8f, 0.2f}));
  Material paint = matte({0.9f, 0.5f, 0.1f});
  paint.double_sided = true;
  add_shape(world, disk(0.5), glm::rotate(moved(0.0, -0.9, 1.5), 1.2, glm::dvec3(1, 0.3, 0)),
            paint);
  return world;
}

Light bulb() {
  return make_bulb({-2, 5, 3}, 60.0f);
}

Light panel() {
  return make_panel({-2, 4, 3}, {0, -1, 0}, {0.7, 0, 0}, {0, 0, -0.7}, 40.0f);
}

double rms(const Film& a, const Film& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.radiance.size(); ++i) {
    const glm::dvec3 d = glm::dvec3(a.radiance[i]) - glm::dvec3(b.radiance[i]);
    sum += glm::dot(d, d) / 3.0;
  }
  return std::sqrt(sum / static_cast<double>(a.radiance.size()));
}

struct Compared {
  double rms = 0.0;
  std::uint64_t missed_splits = 0;
};

/// The world rendered by `method` at MAX 4 and by Sobol sampling.
Compared against_samples(FlattenedScene flattened, const Camera& camera, int spp,
                         Method method = Method::asos) {
  const auto scene = make_render_scene(std::move(flattened));
  RenderSettings settings = make_settings(72, 48, method);
  settings.asos.max_level = 4;
  settings.asos.eps = 1.0 / 1024.0;
  const Picture picture = render_picture(*scene, camera, settings);
  settings.method = Method::sobol;
  settings.sampling.spp = spp;
  const Picture samples = render_picture(*scene, camera, settings);
  return {rms(picture.film, samples.film), picture.statistics.missed_splits};
}

FlattenedScene without_shading(World world) {
  for (Material& m : world.materials) m.unlit = true;
  return {std::move(world), {}};
}

FlattenedScene under(World world, const Light& light) {
  return {std::move(world), {light}};
}

Camera in_front() {
  return looking({0.5, 2.0, 7.0}, {0.1, -0.3, 0});
}

void expect_near(const Compared& found, double most) {
  EXPECT_EQ(found.missed_splits, 0u);
  EXPECT_LT(found.rms, most);
}

// Sobol sampling itself has errors of about 1e-4.
TEST(ShapePictures, OutlinesAreThoseOfManySamples) {
  expect_near(against_samples(without_shading(floating()), in_front(), 1024), 3e-4);
}

TEST(ShapePictures, LinesWhereTheyMeetTrianglesAreFound) {
  expect_near(against_samples(without_shading(crossing()), in_front(), 1024), 5e-4);
}

TEST(ShapePictures, LinesWhereShapesMeetAreFound) {
  World world;
  add_shape(world, sphere(1.0), moved(-0.6, 0, 0), matte({0.8f, 0.2f, 0.2f}));
  add_shape(world, sphere(0.8), moved(0.4, 0.2, 0.5), matte({0.2f, 0.8f, 0.2f}));
  add_shape(world, cylinder(3.0, 0.5, 0.3), glm::rotate(moved(0, 0, 0.4), 1.3, glm::dvec3(0, 0, 1)),
            matte({0.2f, 0.3f, 0.9f}));
  expect_near(against_samples(without_shading(world), looking({0.5, 2.0, 5.0}, {0, 0, 0}), 1024),
              5e-4);
}

TEST(ShapePictures, HardShadowsAreThoseOfManySamples) {
  expect_near(against_samples(under(floating(), bulb()), in_front(), 1024), 5e-4);
  expect_near(against_samples(under(crossing(), bulb()), in_front(), 1024), 1e-3);
}

TEST(ShapePictures, SoftShadowsAreThoseOfManySamples) {
  expect_near(against_samples(under(floating(), panel()), in_front(), 1024), 1e-3);
}

// Cones around pyrays, and point leaves: about 256 samples at outlines.
TEST(ShapePictures, ThePublishedMethodSeesThemToo) {
  expect_near(
      against_samples(without_shading(floating()), in_front(), 1024, Method::asos_published), 4e-3);
}

TEST(ShapePictures, FromInsideOnlyRimsAreSeen) {
  World world;
  Material paint = matte({0.2f, 0.8f, 0.2f});
  paint.double_sided = true;
  add_shape(world, cylinder(4.0, 1.5, 0.8), glm::dmat4(1.0), paint);
  Camera camera = looking({0.3, 0.2, 0.4}, {0.5, 1.9, 0.0});
  camera.fov_y_rad = 1.5;
  Light light = bulb();
  light.position = {0.1, -0.5, 0.2};
  light.intensity = 6.0f;
  expect_near(against_samples(under(world, light), camera, 256), 1e-3);
}

// Radii of 20, 3 and 0.4 pixels.
TEST(ShapePictures, SpheresAndDisksCoverWhatTheClosedFormSays) {
  for (const Shape& shape : {sphere(1.0), disk(1.0)}) {
    for (const Place& place : places()) {
      for (const double distance : {5.0, 33.0, 250.0}) {
        const Worst worst = compare(shape, place.matrix,
                                    looking({0.3, 0.4 * distance, distance}, {0.07, 0.02, 0}), 64);
        const std::string what = place.name +
                                 (shape.type == Shape::Type::disk ? " disk" : " ball") + " at " +
                                 std::to_string(distance);
        EXPECT_GT(worst.partial, 0) << what;
        EXPECT_LT(worst.error, 1e-5) << what;
        EXPECT_LT(std::abs(worst.total), 1e-5 * worst.partial) << what;
      }
    }
  }
}

TEST(ShapePictures, ParallelRaysSeeThemToo) {
  Camera camera = looking({1, 2, 5}, {0.05, 0.03, 0});
  camera.type = Camera::Type::orthographic;
  camera.height = 3.0;
  for (const Shape& shape : {sphere(1.0), disk(1.0)}) {
    for (const Place& place : places()) {
      const Worst worst = compare(shape, place.matrix, camera, 48);
      EXPECT_GT(worst.partial, 40);
      EXPECT_LT(worst.error, 1e-5);
    }
  }
}

}  // namespace
}  // namespace asos::test::shape_pictures_test
