#include "renderer/study/primitive_costs.h"

#include "renderer/features/feature_set.h"
#include "renderer/geometry/face_crossings.h"
#include "renderer/pyray/hit_list.h"
#include "renderer/study/cone_tests.h"
#include "renderer/world/world.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <random>
#include <utility>

namespace asos {
namespace {

constexpr std::size_t pyray_count = 20'000;
constexpr double pyray_width = 0.002;  // at unit distance

std::vector<PyrayCone> random_cones() {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  std::vector<PyrayCone> all(pyray_count);
  for (PyrayCone& cone : all) {
    cone.apex =
        glm::normalize(glm::dvec3(unit(random), 0.6 + 0.3 * unit(random), unit(random))) * 5.0;
    cone.axis =
        glm::normalize(0.8 * glm::dvec3(unit(random), unit(random), unit(random)) - cone.apex);
    const double tangent = std::sqrt(0.5) * pyray_width;
    cone.cosine = 1.0 / std::sqrt(1.0 + tangent * tangent);
    cone.sine = tangent * cone.cosine;
  }
  return all;
}

/// Returns nanoseconds per call; `sum` keeps the compiler from removing the work.
template <typename Test>
double nanoseconds_each(const std::vector<PyrayCone>& pyrays, Test& test, long& sum) {
  const auto start = std::chrono::steady_clock::now();
  for (const PyrayCone& cone : pyrays) sum += test(cone);
  const std::chrono::duration<double, std::nano> spent = std::chrono::steady_clock::now() - start;
  return spent.count() / static_cast<double>(pyrays.size());
}

World world_of(const Shape& shape) {
  Scene scene;
  scene.shapes.push_back(shape);
  scene.meshes.emplace_back();
  Instance instance;
  instance.mesh = 0;
  instance.shape = 0;
  scene.instances.push_back(instance);
  auto flattened = flatten(scene);
  return flattened ? std::move(flattened->world) : World{};
}

/// Opens the outlines of a shape in a pyray's square, as detection does.
class SquareTest {
 public:
  explicit SquareTest(const Shape& shape) : features_(world_of(shape)) {}

  int operator()(const PyrayCone& cone) {
    const glm::dvec3 up = std::abs(cone.axis.y) < 0.9 ? glm::dvec3(0, 1, 0) : glm::dvec3(1, 0, 0);
    const glm::dvec3 right = pyray_width * glm::normalize(glm::cross(cone.axis, up));
    const glm::dvec3 down = glm::cross(cone.axis, right);
    lists_.reset(features_,
                 Frame::pyramid(cone.apex, cone.axis - 0.5 * (right + down), right, down), 0.125f);
    lists_.refine({}, {}, lists_.root(), list_);
    return static_cast<int>(list_.size());
  }

 private:
  FeatureSet features_;
  HitLists lists_;
  HitLists::List list_;
};

template <typename RayTest, typename ConeTest>
void take_least(PrimitiveCost& cost, int rounds, RayTest ray, ConeTest cone, SquareTest* square) {
  constexpr double unknown = 1e30;
  static const std::vector<PyrayCone> pyrays = random_cones();
  cost.ray_ns = cost.cone_ns = unknown;
  cost.square_ns = square ? unknown : 0.0;
  long sum = 0;
  for (int i = 0; i < rounds; ++i) {
    cost.ray_ns = std::min(cost.ray_ns, nanoseconds_each(pyrays, ray, sum));
    cost.cone_ns = std::min(cost.cone_ns, nanoseconds_each(pyrays, cone, sum));
    if (square) cost.square_ns = std::min(cost.square_ns, nanoseconds_each(pyrays, *square, sum));
  }
  volatile long kept = sum;
  (void)kept;
}

PrimitiveCost round_cost(PrimitiveCost cost, const Shape& shape, int rounds) {
  const std::vector<ShapeFace> faces = place_shape(shape, glm::dmat4(1.0));
  SquareTest square(shape);
  const auto ray = [&](const PyrayCone& cone) {
    int met = 0;
    for (const ShapeFace& face : faces) met += cross(face, cone.apex, cone.axis).count;
    return met;
  };
  const auto meet = [&](const PyrayCone& cone) {
    switch (shape.type) {
      case Shape::Type::sphere:
        return static_cast<int>(meet_sphere(cone, glm::dvec3(0.0), shape.radius));
      case Shape::Type::disk:
        return static_cast<int>(meet_disk(cone, faces[0]));
      default:
        return static_cast<int>(meet_cylinder(cone, faces[0]));
    }
  };
  take_least(cost, rounds, ray, meet, &square);
  return cost;
}

PrimitiveCost polygon_cost(PrimitiveCost cost, int rounds) {
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
  const auto meet = [&](const PyrayCone& cone) {
    return static_cast<int>(meet_polygon(cone, quad));
  };
  take_least(cost, rounds, ray, meet, nullptr);
  return cost;
}

PrimitiveCost box_cost(PrimitiveCost cost, int rounds) {
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
  const auto meet = [&](const PyrayCone& cone) { return static_cast<int>(meet_box(cone, lo, hi)); };
  take_least(cost, rounds, ray, meet, nullptr);
  return cost;
}

/// Returns a row of table 3, with its wording and factor.
PrimitiveCost table_row(const char* name, double published) {
  PrimitiveCost cost;
  cost.name = name;
  cost.published = published;
  return cost;
}

Shape round_shape(Shape::Type type, double radius) {
  Shape shape;
  shape.type = type;
  shape.radius = radius;
  return shape;
}

Shape cylinder_shape(double bottom, double top) {
  Shape shape = round_shape(Shape::Type::cylinder, 0.0);
  shape.height = 1.2;
  shape.radius_bottom = bottom;
  shape.radius_top = top;
  return shape;
}

}  // namespace

std::vector<PrimitiveCost> primitive_costs(int rounds) {
  return {round_cost(table_row("sphere", 1.01), round_shape(Shape::Type::sphere, 0.7), rounds),
          polygon_cost(table_row("polygon", 1.42), rounds),
          round_cost(table_row("disk", 1.01), round_shape(Shape::Type::disk, 0.7), rounds),
          box_cost(table_row("box", 1.19), rounds),
          round_cost(table_row("cone", 2.40), cylinder_shape(0.6, 0.0), rounds),
          round_cost(table_row("cylinder", 5.40), cylinder_shape(0.5, 0.5), rounds)};
}

}  // namespace asos
