// What a pyray's in-out test costs beside a ray's, for each of the primitives of GI'93, table 3:
// `bench_primitives`. Both kinds of test run over the same pyrays in turn, several times; the least
// time of each counts. The cone is the published one, around the pyray; the last column is what
// this program does instead for curved faces, which is to find their outline in the pyray's square.

#include "renderer/geometry/face_crossings.h"
#include "renderer/pyray/cone_tests.h"
#include "renderer/pyray/hit_list.h"
#include "tests/support/shape_world.h"

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <functional>
#include <random>
#include <vector>

namespace asos {
namespace {

constexpr int rounds = 15;
constexpr double pixel = 0.002;  // of a pyray's width, one unit ahead

std::vector<PyrayCone> cones() {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  std::vector<PyrayCone> all(20'000);
  for (PyrayCone& cone : all) {
    cone.apex =
        glm::normalize(glm::dvec3(unit(random), 0.6 + 0.3 * unit(random), unit(random))) * 5.0;
    cone.axis =
        glm::normalize(0.8 * glm::dvec3(unit(random), unit(random), unit(random)) - cone.apex);
    const double tangent = std::sqrt(0.5) * pixel;
    cone.cosine = 1.0 / std::sqrt(1.0 + tangent * tangent);
    cone.sine = tangent * cone.cosine;
  }
  return all;
}

/// Nanoseconds a call, the least of all rounds; `sum` keeps the work from being left out.
double nanoseconds(const std::vector<PyrayCone>& pyrays, auto&& test, long& sum) {
  const auto start = std::chrono::steady_clock::now();
  for (const PyrayCone& cone : pyrays) sum += test(cone);
  const std::chrono::duration<double, std::nano> spent = std::chrono::steady_clock::now() - start;
  return spent.count() / static_cast<double>(pyrays.size());
}

struct Costs {
  double ray = 1e30, cone = 1e30, square = 1e30;
};

/// Opens the outlines of a shape in a pyray's square, as detection does.
class SquareTest {
 public:
  explicit SquareTest(const Shape& shape) {
    test::add_shape(world_, shape, glm::dmat4(1.0), test::matte(glm::vec3(0.5f)));
    features_ = FeatureSet(world_);
  }

  int operator()(const PyrayCone& cone) {
    const glm::dvec3 up = std::abs(cone.axis.y) < 0.9 ? glm::dvec3(0, 1, 0) : glm::dvec3(1, 0, 0);
    const glm::dvec3 right = pixel * glm::normalize(glm::cross(cone.axis, up));
    const glm::dvec3 down = glm::cross(cone.axis, right);
    lists_.reset(features_,
                 Frame::pyramid(cone.apex, cone.axis - 0.5 * (right + down), right, down), 0.125f);
    lists_.refine({}, {}, lists_.root(), list_);
    return static_cast<int>(list_.size());
  }

 private:
  World world_;
  FeatureSet features_;
  HitLists lists_;
  HitLists::List list_;
};

template <typename RayTest, typename ConeTest>
Costs measure(const std::vector<PyrayCone>& pyrays, RayTest ray, ConeTest cone,
              SquareTest* square) {
  Costs least;
  static long sum = 0;
  for (int i = 0; i < rounds; ++i) {
    least.ray = std::min(least.ray, nanoseconds(pyrays, ray, sum));
    least.cone = std::min(least.cone, nanoseconds(pyrays, cone, sum));
    if (square) least.square = std::min(least.square, nanoseconds(pyrays, *square, sum));
  }
  volatile long keep = sum;
  (void)keep;
  return least;
}

void print(const char* name, const Costs& costs, double published, bool square) {
  std::printf("%-9s %8.1f %8.1f %8.2f %10.2f", name, costs.ray, costs.cone, costs.cone / costs.ray,
              published);
  if (square) std::printf(" %10.1f", costs.square);
  std::printf("\n");
}

int ray_meets(const std::vector<ShapeFace>& faces, const PyrayCone& cone) {
  int met = 0;
  for (const ShapeFace& face : faces) met += cross(face, cone.apex, cone.axis).count;
  return met;
}

void round_shape(const char* name, const Shape& shape, double published,
                 const std::vector<PyrayCone>& pyrays) {
  const std::vector<ShapeFace> faces = place_shape(shape, glm::dmat4(1.0));
  SquareTest square(shape);
  const Costs costs = measure(
      pyrays, [&](const PyrayCone& cone) { return ray_meets(faces, cone); },
      [&](const PyrayCone& cone) {
        switch (shape.type) {
          case Shape::Type::sphere:
            return static_cast<int>(meet_sphere(cone, glm::dvec3(0.0), shape.radius));
          case Shape::Type::disk:
            return static_cast<int>(meet_disk(cone, faces[0]));
          default:
            return static_cast<int>(meet_cylinder(cone, faces[0]));
        }
      },
      &square);
  print(name, costs, published, true);
}

void polygon(const std::vector<PyrayCone>& pyrays) {
  const std::array<glm::dvec3, 4> quad{
      glm::dvec3{-0.6, 0, 0.7}, {0.7, 0, 0.5}, {0.5, 0, -0.6}, {-0.4, 0, -0.5}};
  const auto ray = [&](const PyrayCone& cone) {
    const glm::dvec3 n = glm::cross(quad[1] - quad[0], quad[2] - quad[0]);
    const double t = glm::dot(n, quad[0] - cone.apex) / glm::dot(n, cone.axis);
    if (!(t > 0.0)) return 0;
    const glm::dvec3 p = cone.apex + t * cone.axis;
    for (std::size_t i = 0; i < 4; ++i)
      if (glm::dot(n, glm::cross(quad[(i + 1) % 4] - quad[i], p - quad[i])) < 0.0) return 0;
    return 1;
  };
  print("polygon",
        measure(
            pyrays, ray,
            [&](const PyrayCone& cone) { return static_cast<int>(meet_polygon(cone, quad)); },
            nullptr),
        1.42, false);
}

void box(const std::vector<PyrayCone>& pyrays) {
  const glm::dvec3 hi(0.6, 0.4, 0.5), lo = -hi;
  const auto ray = [&](const PyrayCone& cone) {
    double t0 = 0.0, t1 = 1e300;
    for (int k = 0; k < 3; ++k) {
      const double a = (lo[k] - cone.apex[k]) / cone.axis[k];
      const double b = (hi[k] - cone.apex[k]) / cone.axis[k];
      t0 = std::max(t0, std::min(a, b)), t1 = std::min(t1, std::max(a, b));
    }
    return t0 < t1 ? 1 : 0;
  };
  print(
      "box",
      measure(
          pyrays, ray,
          [&](const PyrayCone& cone) { return static_cast<int>(meet_box(cone, lo, hi)); }, nullptr),
      1.19, false);
}

}  // namespace
}  // namespace asos

int main() {
  using namespace asos;
  const std::vector<PyrayCone> pyrays = cones();
  std::printf("nanoseconds      ray     cone   factor  published  in square\n");
  round_shape("sphere", test::sphere(0.7), 1.01, pyrays);
  polygon(pyrays);
  round_shape("disk", test::disk(0.7), 1.01, pyrays);
  box(pyrays);
  round_shape("cone", test::cylinder(1.2, 0.6, 0.0), 2.40, pyrays);
  round_shape("cylinder", test::cylinder(1.2, 0.5, 0.5), 5.40, pyrays);
  return 0;
}
