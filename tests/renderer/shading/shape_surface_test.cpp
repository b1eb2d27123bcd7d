#include "renderer/shading/shade.h"
#include "renderer/shading/surface.h"
#include "renderer/shading/texture.h"
#include "tests/support/random_space.h"
#include "tests/support/shape_world.h"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <utility>
#include <vector>

namespace asos {
namespace {

std::vector<Shape> shapes() {
  return {test::sphere(0.8), test::disk(0.9), test::cylinder(1.4, 0.5, 0.5),
          test::cylinder(1.5, 0.8, 0.0), test::cylinder(1.1, 0.4, 0.9)};
}

glm::dmat4 askew(double scale, glm::dvec3 place) {
  return glm::rotate(glm::translate(glm::dmat4(1.0), place), 0.9,
                     glm::normalize(glm::dvec3(1, 2, 3))) *
         glm::scale(glm::dmat4(1.0), scale * glm::dvec3(1.0, 0.5, 1.7));
}

Hit random_hit(test::RandomSpace& space, const World& world) {
  return {.triangle = static_cast<std::uint32_t>(space.between(0.0, 0.999) *
                                                 static_cast<double>(world.faces.size())),
          .b1 = static_cast<float>(space.between(0.02, 0.98)),
          .b2 = static_cast<float>(space.between(0.02, 0.98))};
}

TEST(ShapeSurface, NormalsTurnAsTheirDerivativesSay) {
  test::RandomSpace space(4);
  for (const Shape& shape : shapes()) {
    World world;
    test::add_shape(world, shape, askew(1.0, {0.3, 0.1, -0.2}), test::matte(glm::vec3(0.5f)));
    for (int i = 0; i < 200; ++i) {
      const Hit hit = random_hit(space, world);
      const ShapeFace& face = world.face(hit.triangle);
      const double u = hit.b1, v = hit.b2, h = 1e-6;
      const FacePoint p = face_point(face, u, v);
      const FacePoint pu = face_point(face, u + h, v), pv = face_point(face, u, v + h);
      EXPECT_NEAR(glm::length(p.normal), 1.0, 1e-12);
      EXPECT_NEAR(glm::dot(p.normal, p.along_u), 0.0, 1e-9);
      EXPECT_NEAR(glm::dot(p.normal, p.along_v), 0.0, 1e-9);
      EXPECT_LT(glm::distance((pu.position - p.position) / h, p.along_u), 1e-4);
      EXPECT_LT(glm::distance((pv.position - p.position) / h, p.along_v), 1e-4);
      const auto across = [&](glm::dvec3 d) { return d - glm::dot(d, p.normal) * p.normal; };
      EXPECT_LT(glm::distance(across((pu.normal - p.normal) / h), across(p.normal_u)), 1e-3);
      EXPECT_LT(glm::distance(across((pv.normal - p.normal) / h), across(p.normal_v)), 1e-3);
    }
  }
}

TEST(ShapeSurface, TextureCoordinatesAreTheFaces) {
  World world;
  test::add_shape(world, test::sphere(1.0), glm::dmat4(1.0), test::matte(glm::vec3(0.5f)));
  EXPECT_EQ(texcoord_at(world, 0, 0, 0.25f, 0.75f), glm::vec2(0.25f, 0.75f));
  // v starts at the apex; coordinates and points are inverse.
  const FacePoint top = face_point(world.faces[0], 0.3, 0.0);
  EXPECT_LT(glm::distance(top.position, glm::dvec3(0, 1, 0)), 1e-12);
  test::RandomSpace space(6);
  for (int i = 0; i < 100; ++i) {
    const glm::dvec2 uv(space.between(0.01, 0.99), space.between(0.01, 0.99));
    const FacePoint p = face_point(world.faces[0], uv.x, uv.y);
    const glm::dvec2 back = face_coordinates(world.faces[0], world.faces[0].unit(p.position));
    EXPECT_LT(glm::distance(back, uv), 1e-9);
  }
}

// A ray leaving a convex shape does not hit it again; a ray to its inside does.
TEST(ShapeSurface, RaysStartClearOfTheSurface) {
  test::RandomSpace space(8);
  for (const double scale : {1e-3, 1.0, 1e4}) {
    for (const Shape& shape : shapes()) {
      World world;
      test::add_shape(world, shape, askew(scale, scale * glm::dvec3(3.0, -5.0, 2.0)),
                      test::matte(glm::vec3(0.5f)));
      const RayScene rays = RayScene::build(world, alpha_at).value();
      for (int i = 0; i < 500; ++i) {
        const Hit hit = random_hit(space, world);
        if (world.face(hit.triangle).kind == ShapeFace::Kind::disk &&
            glm::distance(glm::vec2(hit.b1, hit.b2), glm::vec2(0.5f)) > 0.45f)
          continue;
        const FacePoint at = face_point(world.face(hit.triangle), hit.b1, hit.b2);
        const SurfacePoint point = surface_point(world, {}, hit, glm::vec3(at.normal));
        EXPECT_LT(glm::distance(glm::dvec3(point.shading_normal), at.normal), 1e-5);
        glm::dvec3 away = space.direction();
        if (glm::dot(away, at.normal) < 0.0) away = -away;
        away = glm::normalize(away + 0.01 * at.normal);
        Ray ray;
        ray.direction = glm::vec3(away);
        ray.origin = spawn_origin(point, ray.direction);
        EXPECT_FALSE(rays.closest(ray).valid()) << scale << " " << i;
        ray.direction = glm::vec3(-at.normal);
        ray.origin = glm::vec3(at.position + 0.1 * scale * at.normal);
        const Hit again = rays.closest(ray);
        ASSERT_TRUE(again.valid());
        EXPECT_NEAR(again.t, 0.1 * scale, 2e-6 * scale * 10.0);
      }
    }
  }
}

}  // namespace
}  // namespace asos
