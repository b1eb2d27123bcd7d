#include "renderer/world/hit_plane.h"
#include "tests/renderer/rays/ray_worlds.h"
#include "tests/support/random_space.h"
#include "tests/support/shape_world.h"

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

namespace asos::shape_rays_test {
namespace {

using Real = long double;

/// Intersections of a line with a shape in its own space, by textbook formulas in long double. Also
/// the margin of the closest decision (relative, 0: undecidable).
struct Crossings {
  std::vector<Real> t;
  Real margin = 1.0L;
};

struct Line {
  Real o[3], d[3];
};

void add_quadratic(Crossings& out, Real a, Real b, Real c, auto&& keeps) {
  const Real square = b * b - 4 * a * c;
  const Real size = b * b + std::abs(4 * a * c);
  if (size > 0) out.margin = std::min(out.margin, std::abs(square) / size);
  if (!(square > 0) || a == 0) return;
  for (const Real sign : {-1.0L, 1.0L}) {
    const Real t = (-b + sign * std::sqrt(square)) / (2 * a);
    if (keeps(t)) out.t.push_back(t);
  }
}

void add_disk(Crossings& out, const Line& l, Real y, Real radius) {
  if (l.d[1] == 0) return;
  const Real t = (y - l.o[1]) / l.d[1];
  const Real x = l.o[0] + t * l.d[0], z = l.o[2] + t * l.d[2];
  const Real r = std::sqrt(x * x + z * z);
  out.margin = std::min(out.margin, std::abs(r - radius) / radius);
  if (r < radius) out.t.push_back(t);
}

Crossings crossings(const Shape& shape, const Line& l) {
  Crossings out;
  const Real *o = l.o, *d = l.d;
  const Real radius = shape.radius;
  if (shape.type == Shape::Type::disk) add_disk(out, l, 0, radius);
  if (shape.type == Shape::Type::sphere) {
    add_quadratic(
        out, d[0] * d[0] + d[1] * d[1] + d[2] * d[2], 2 * (o[0] * d[0] + o[1] * d[1] + o[2] * d[2]),
        o[0] * o[0] + o[1] * o[1] + o[2] * o[2] - radius * radius, [](Real) { return true; });
  }
  if (shape.type == Shape::Type::cylinder) {
    const Real h = shape.height, rb = shape.radius_bottom, rt = shape.radius_top;
    const Real k = (rt - rb) / h, r0 = rb + k * (o[1] + h / 2);
    add_quadratic(out, d[0] * d[0] + d[2] * d[2] - k * k * d[1] * d[1],
                  2 * (o[0] * d[0] + o[2] * d[2] - r0 * k * d[1]),
                  o[0] * o[0] + o[2] * o[2] - r0 * r0, [&](Real t) {
                    const Real y = o[1] + t * d[1];
                    out.margin = std::min(out.margin, std::abs(std::abs(y) - h / 2) / h);
                    return std::abs(y) <= h / 2;
                  });
    if (rb > 0) add_disk(out, l, -h / 2, rb);
    if (rt > 0) add_disk(out, l, h / 2, rt);
  }
  std::sort(out.t.begin(), out.t.end());
  return out;
}

Line in_shape(const glm::dmat4& world_from_shape, const Ray& ray) {
  const glm::dmat4 inverse = glm::inverse(world_from_shape);
  const glm::dvec4 o = inverse * glm::dvec4(glm::dvec3(ray.origin), 1.0);
  const glm::dvec4 d = inverse * glm::dvec4(glm::dvec3(ray.direction), 0.0);
  return {{o.x, o.y, o.z}, {d.x, d.y, d.z}};
}

struct Case {
  std::string name;
  Shape shape;
  glm::dmat4 place{1.0};
};

std::vector<Case> cases() {
  const glm::dmat4 turned = glm::rotate(glm::translate(glm::dmat4(1.0), glm::dvec3(0.2, -0.1, 0.3)),
                                        0.7, glm::normalize(glm::dvec3(1, 2, -1)));
  const glm::dmat4 stretched = turned * glm::scale(glm::dmat4(1.0), glm::dvec3(1.0, 0.4, 2.5));
  std::vector<Case> all;
  const std::vector<std::pair<std::string, Shape>> shapes{
      {"sphere", test::sphere(0.8)},
      {"disk", test::disk(0.9)},
      {"cylinder", test::cylinder(1.4, 0.5, 0.5)},
      {"cone", test::cylinder(1.5, 0.8, 0.0)},
      {"hanging cone", test::cylinder(1.5, 0.0, 0.8)},
      {"truncated cone", test::cylinder(1.1, 0.9, 0.4)}};
  for (const auto& [name, shape] : shapes) {
    all.push_back({name, shape, turned});
    all.push_back({"stretched " + name, shape, stretched});
    all.push_back({"mirrored " + name, shape,
                   turned * glm::scale(glm::dmat4(1.0), glm::dvec3(-1.0, 1.0, 1.0))});
  }
  return all;
}

Ray some_ray(test::RandomSpace& space, const Case& c, int i, double scale) {
  const auto point = [&](double size) {
    return glm::dvec3(c.place *
                      glm::dvec4(size * space.between(0.0, 1.0) * space.direction(), 1.0));
  };
  Ray ray;
  glm::dvec3 origin, direction;
  switch (i % 4) {
    case 0:  // from outside, towards it
      origin = point(6.0);
      direction = point(1.0) - origin;
      break;
    case 1:  // from inside or nearby
      origin = point(0.5);
      direction = space.direction();
      break;
    case 2: {  // grazing: past a point of the surface, nearly along it
      const std::vector<ShapeFace> faces = place_shape(c.shape, c.place);
      const FacePoint at = face_point(faces[static_cast<std::size_t>(i) % faces.size()],
                                      space.between(0, 1), space.between(0, 1));
      const glm::dvec3 along = space.perpendicular(at.normal);
      direction = along + 1e-3 * space.between(-1, 1) * at.normal;
      origin = at.position - space.between(0.5, 3.0) * direction;
      break;
    }
    default:  // anywhere
      origin = point(4.0);
      direction = space.direction();
      break;
  }
  ray.origin = glm::vec3(scale * origin);
  ray.direction = glm::vec3(glm::normalize(direction));
  return ray;
}

void compare(const Case& c, double scale) {
  World world;
  const glm::dmat4 place = glm::scale(glm::dmat4(1.0), glm::dvec3(scale)) * c.place;
  test::add_shape(world, c.shape, place, test::double_sided(test::matte(glm::vec3(0.5f))));
  const RayScene rays = test::build(world);
  test::RandomSpace space(7);
  std::vector<Ray> sent;
  for (int i = 0; i < 10'000; ++i) sent.push_back(some_ray(space, c, i, scale));
  std::vector<Hit> hits(sent.size());
  rays.closest(sent, hits);
  std::vector<glm::vec3> shares(sent.size());
  rays.transmittance(sent, shares);

  int met = 0, missed = 0, decided = 0;
  double worst_t = 0.0, worst_off = 0.0;
  for (std::size_t i = 0; i < sent.size(); ++i) {
    const Crossings exact = crossings(c.shape, in_shape(place, sent[i]));
    const auto first = std::find_if(exact.t.begin(), exact.t.end(), [](Real t) { return t > 0; });
    const bool hit = first != exact.t.end();
    const bool on_surface = std::any_of(exact.t.begin(), exact.t.end(), [&](Real t) {
      return std::abs(t) < 1e-9L * static_cast<Real>(scale);
    });
    // Double precision cannot decide extreme grazing.
    if (exact.margin < 1e-11L || on_surface) continue;
    ++decided;
    ASSERT_EQ(hits[i].valid(), hit) << c.name << " ray " << i << " scale " << scale;
    ASSERT_EQ(shares[i] == glm::vec3(0.0f), hit) << c.name << " ray " << i;
    (hit ? met : missed) += 1;
    if (!hit) continue;
    const auto t = static_cast<double>(*first);
    worst_t = std::max(worst_t, std::abs(static_cast<double>(hits[i].t) - t) / (t + scale));
    // The point from the hit's coordinates is on the surface and near the ray's point.
    const glm::dvec3 p = hit_plane(world, hits[i]).point(hits[i].b1, hits[i].b2);
    const glm::dvec3 q = glm::dvec3(sent[i].origin) + t * glm::dvec3(sent[i].direction);
    worst_off = std::max(worst_off, glm::distance(p, q) / scale);
  }
  EXPECT_GT(decided, 9'900) << c.name;
  EXPECT_GT(met, 2'500) << c.name;
  EXPECT_GT(missed, 500) << c.name;
  EXPECT_LT(worst_t, 1.2e-7) << c.name;  // a float's last digit
  EXPECT_LT(worst_off, 2e-6) << c.name;  // a float's last digit of a coordinate around a face
}

TEST(ShapeRays, MeetWhatTheTextbookSays) {
  for (const Case& c : cases()) compare(c, 1.0);
}

TEST(ShapeRays, MeetTinyAndHugeShapesAlike) {
  for (const Case& c : cases()) {
    compare(c, 1e-6);
    compare(c, 1e6);
  }
}

TEST(ShapeRays, GoThroughBacksOfSingleSidedShapes) {
  World world;
  test::add_shape(world, test::sphere(1.0), glm::dmat4(1.0), test::matte(glm::vec3(0.5f)));
  const RayScene rays = test::build(world);
  const Ray inside = test::down(0.3f, 0.2f, 0.0f);
  EXPECT_TRUE(rays.closest(inside).valid());
  EXPECT_FALSE(rays.closest(inside, Culling::as_material_says).valid());
  const Ray outside = test::down(0.3f, 0.2f, 5.0f);
  EXPECT_TRUE(rays.closest(outside, Culling::as_material_says).valid());
  EXPECT_EQ(rays.closest(outside).t, rays.closest(outside, Culling::as_material_says).t);
}

TEST(ShapeRays, ABlendedShapeTakesItsShareTwice) {
  World world;
  test::add_shape(world, test::sphere(1.0), glm::dmat4(1.0), test::blended(0.25f));
  const RayScene rays = test::build(world);
  EXPECT_FLOAT_EQ(rays.transmittance(test::down(0.3f, 0.2f, 5.0f)).x, 0.75f * 0.75f);
  EXPECT_FLOAT_EQ(rays.transmittance(test::down(0.3f, 0.2f, 0.0f)).x, 0.75f);
  EXPECT_FLOAT_EQ(rays.transmittance(test::down(1.3f, 0.2f, 5.0f)).x, 1.0f);
}

TEST(ShapeRays, AShapeAmongTrianglesIsMetInItsPlace) {
  World world;
  test::add_square(world, -2.0f, test::matte(glm::vec3(0.5f)));
  test::add_shape(world, test::sphere(0.5), glm::dmat4(1.0), test::matte(glm::vec3(0.5f)));
  const RayScene rays = test::build(world);
  const Hit ball = rays.closest(test::down(0.0f, 0.1f, 3.0f));
  ASSERT_TRUE(world.is_face(ball.triangle));
  EXPECT_NEAR(ball.t, 3.0 - std::sqrt(0.25 - 0.01), 1e-6);
  const Hit ground = rays.closest(test::down(0.7f, 0.1f, 3.0f));
  EXPECT_FALSE(world.is_face(ground.triangle));
  EXPECT_FLOAT_EQ(ground.t, 5.0f);
  Ray from_between = test::down(0.0f, 0.0f, -1.0f);
  EXPECT_FALSE(world.is_face(rays.closest(from_between).triangle));
}

TEST(ShapeRays, RaysAloneAndInPacketsAgree) {
  const std::vector<Case> all = cases();
  World world;
  // Stretched shapes intersect each other, but no two coincide.
  for (std::size_t i = 1; i < all.size(); i += 3)
    test::add_shape(world, all[i].shape, all[i].place, test::blended(1.0f));
  RayScene rays = test::build(world);
  test::RandomSpace space(11);
  std::vector<Ray> sent;
  for (int i = 0; i < 500; ++i) sent.push_back(some_ray(space, all[1], i, 1.0));
  std::vector<Hit> packed(sent.size());
  rays.closest(sent, packed);
  for (std::size_t i = 0; i < sent.size(); ++i) {
    const Hit alone = rays.closest(sent[i]);
    EXPECT_EQ(alone.triangle, packed[i].triangle) << i;
    EXPECT_EQ(alone.t, packed[i].t) << i;
  }
}

}  // namespace
}  // namespace asos::shape_rays_test
