#include "renderer/study/cone_tests.h"

#include "renderer/geometry/face_crossings.h"
#include "tests/support/random_space.h"
#include "tests/support/shape_world.h"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <vector>

namespace asos {
namespace {

using Meets = std::function<bool(glm::dvec3 origin, glm::dvec3 direction)>;

/// How many of the rays in a cone, with a dense border, hit an object.
struct Share {
  int met = 0;
  int all = 0;
};

Share share_of(const PyrayCone& cone, const Meets& meets) {
  const glm::dvec3 other = std::abs(cone.axis.x) < 0.6 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
  const glm::dvec3 x = glm::normalize(glm::cross(cone.axis, other)), y = glm::cross(cone.axis, x);
  Share share;
  for (int ring = 0; ring <= 12; ++ring) {
    const double r = 0.999 * cone.sine / cone.cosine * ring / 12;
    for (int i = 0; i < 48; ++i) {
      const double t = 2.0 * 3.14159265358979 * i / 48;
      share.met += meets(cone.apex, cone.axis + r * (std::cos(t) * x + std::sin(t) * y));
      ++share.all;
    }
  }
  return share;
}

struct Tally {
  int none = 0, covered = 0, marginal = 0, marginal_in_vain = 0;
};

/// Narrow cones around an object of size 1 near the origin, against rays.
Tally compare(const std::function<ConeMeeting(const PyrayCone&)>& test, const Meets& meets) {
  test::RandomSpace space(3);
  Tally tally;
  for (int i = 0; i < 3000; ++i) {
    PyrayCone cone;
    cone.apex = space.between(3.0, 8.0) * space.direction();
    cone.axis = glm::normalize(1.3 * space.between(0.0, 1.0) * space.direction() - cone.apex);
    cone.sine = space.between(0.002, 0.1);
    cone.cosine = std::sqrt(1.0 - cone.sine * cone.sine);
    const Share share = share_of(cone, meets);
    switch (test(cone)) {
      case ConeMeeting::none:
        ++tally.none;
        EXPECT_EQ(share.met, 0) << i;
        break;
      case ConeMeeting::covered:
        ++tally.covered;
        EXPECT_EQ(share.met, share.all) << i;
        break;
      case ConeMeeting::marginal:
        ++tally.marginal;
        tally.marginal_in_vain += share.met == 0 || share.met == share.all;
        break;
    }
  }
  EXPECT_GT(tally.none, 200);
  EXPECT_GT(tally.marginal, 200);
  return tally;
}

Meets meets_any(const std::vector<ShapeFace>& faces) {
  return [faces](glm::dvec3 o, glm::dvec3 d) {
    for (const ShapeFace& face : faces) {
      const FaceCrossings met = cross(face, o, d);
      for (int i = 0; i < met.count; ++i)
        if (met.t[i] > 0.0) return true;
    }
    return false;
  };
}

glm::dmat4 askew() {
  return glm::rotate(glm::translate(glm::dmat4(1.0), glm::dvec3(0.1, -0.2, 0.05)), 0.9,
                     glm::normalize(glm::dvec3(1, 2, 3)));
}

TEST(ConeTests, SphereAsRaysSeeIt) {
  const auto faces = place_shape(test::sphere(0.7), glm::dmat4(1.0));
  const Tally tally =
      compare([](const PyrayCone& cone) { return meet_sphere(cone, glm::dvec3(0.0), 0.7); },
              meets_any(faces));
  EXPECT_GT(tally.covered, 200);
  // The border's rays are a thousandth inside.
  EXPECT_LT(tally.marginal_in_vain, 20);
}

TEST(ConeTests, DiskAsRaysSeeIt) {
  const auto faces = place_shape(test::disk(0.8), askew());
  const Tally tally =
      compare([&](const PyrayCone& cone) { return meet_disk(cone, faces[0]); }, meets_any(faces));
  EXPECT_GT(tally.covered, 200);
  EXPECT_LT(tally.marginal_in_vain, 40);
}

TEST(ConeTests, CylinderAndConeAsRaysSeeThem) {
  for (const double top : {0.5, 0.2, 0.0}) {
    const auto faces = place_shape(test::cylinder(1.2, 0.5, top), askew());
    const Tally tally = compare(
        [&](const PyrayCone& cone) { return meet_cylinder(cone, faces[0]); }, meets_any(faces));
    EXPECT_GT(tally.covered, 200) << top;
  }
}

TEST(ConeTests, BoxAndPolygonAsRaysSeeThem) {
  const glm::dvec3 hi(0.6, 0.4, 0.5), lo = -hi;
  const auto in_box = [&](glm::dvec3 o, glm::dvec3 d) {
    double t0 = 0.0, t1 = 1e300;
    for (int k = 0; k < 3; ++k) {
      const double a = (lo[k] - o[k]) / d[k], b = (hi[k] - o[k]) / d[k];
      t0 = std::max(t0, std::min(a, b)), t1 = std::min(t1, std::max(a, b));
    }
    return t0 < t1;
  };
  const Tally box = compare([&](const PyrayCone& cone) { return meet_box(cone, lo, hi); }, in_box);
  EXPECT_GT(box.covered, 200);
  EXPECT_LT(box.marginal_in_vain, 40);

  const std::array<glm::dvec3, 4> quad{
      glm::dvec3{-0.6, 0, -0.7}, {0.7, 0, -0.5}, {0.5, 0, 0.6}, {-0.4, 0, 0.5}};
  const auto in_quad = [&](glm::dvec3 o, glm::dvec3 d) {
    const double t = -o.y / d.y;
    if (!(t > 0.0)) return false;
    const glm::dvec3 p = o + t * d;
    for (std::size_t i = 0; i < 4; ++i) {
      const glm::dvec3 e = quad[(i + 1) % 4] - quad[i], q = p - quad[i];
      if (e.x * q.z - e.z * q.x < 0.0) return false;
    }
    return true;
  };
  const Tally polygon =
      compare([&](const PyrayCone& cone) { return meet_polygon(cone, quad); }, in_quad);
  EXPECT_GT(polygon.covered, 100);
  EXPECT_LT(polygon.marginal_in_vain, 40);
}

}  // namespace
}  // namespace asos
