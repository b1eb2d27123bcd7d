#include "renderer/reflections/ray_bundle.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

// Bundles against single rays, traced through a sphere by Snell's law.

namespace asos {
namespace {

constexpr double index = 1.5, radius = 2.0;

struct Line {
  glm::dvec3 origin, direction;
};

/// The refracted line at the near or the far side of a sphere around the origin.
Line through(const Line& in, double ratio, bool far) {
  const double along = -glm::dot(in.origin, in.direction);
  const double half = std::sqrt(radius * radius - glm::dot(in.origin, in.origin) + along * along);
  const glm::dvec3 p = in.origin + (far ? along + half : along - half) * in.direction;
  const glm::dvec3 n = (far ? -1.0 : 1.0) / radius * p;
  const double c = -glm::dot(in.direction, n);
  const double behind = std::sqrt(1.0 - ratio * ratio * (1.0 - c * c));
  return {p, ratio * in.direction + (ratio * c - behind) * n};
}

/// The sphere's surface at the point that a bundle hits.
MirrorSurface surface_at(const RayBundle& bundle, glm::dvec3 p, bool far, double ratio) {
  MirrorSurface surface{.position = p};
  surface.normal = surface.geometric = (far ? -1.0 : 1.0) / radius * p;
  const double t = glm::dot(p - bundle.origin, bundle.direction);
  const auto moved = [&](glm::dvec3 edge) {
    const glm::dvec3 n = surface.normal;
    return edge - bundle.direction * (glm::dot(n, edge) / glm::dot(n, bundle.direction));
  };
  surface.turn_right = (far ? -1.0 : 1.0) / radius * moved(bundle.section(t).right);
  surface.turn_down = (far ? -1.0 : 1.0) / radius * moved(bundle.section(t).down);
  return refracting(surface, ratio);
}

RayBundle from_eye(double beside, double width) {
  RayBundle bundle{.origin = {beside, 0.4, 9.0},
                   .direction = glm::normalize(glm::dvec3(-0.1 * beside, 0.02, -1.0))};
  bundle.right = width * glm::normalize(across({1, 0, 0}, bundle.direction));
  bundle.down = width * glm::normalize(across({0, -1, 0}, bundle.direction));
  return bundle;
}

/// The bundle after both sides of the sphere.
RayBundle bundle_through(const RayBundle& eye, Line* middle = nullptr) {
  const Line first = through({eye.origin, eye.direction}, 1.0 / index, false);
  const RayBundle inside = mirrored(eye, surface_at(eye, first.origin, false, 1.0 / index));
  const Line second = through(first, index, true);
  if (middle) *middle = second;
  return mirrored(inside, surface_at(inside, second.origin, true, index));
}

TEST(RayBundle, ChangesAsItsRaysDo) {
  constexpr double width = 1e-5;
  for (const double beside : {0.0, 0.7, 1.4}) {
    const RayBundle eye = from_eye(beside, width);
    Line middle;
    const RayBundle out = bundle_through(eye, &middle);
    EXPECT_NEAR(glm::distance(out.origin, middle.origin), 0.0, 1e-9);
    EXPECT_NEAR(glm::distance(out.direction, middle.direction), 0.0, 1e-9);
    for (const glm::dvec2 at : {glm::dvec2(0.5, 0.0), {0.0, 0.5}, {-0.5, 0.5}}) {
      const glm::dvec3 turned = eye.direction + at.x * eye.right + at.y * eye.down;
      const Line ray =
          through(through({eye.origin, glm::normalize(turned)}, 1.0 / index, false), index, true);
      const glm::dvec3 moved = at.x * out.right_at + at.y * out.down_at;
      const glm::dvec3 direction = at.x * out.right + at.y * out.down;
      // Equal to first order; the rest is of second order.
      EXPECT_NEAR(glm::distance(ray.origin - middle.origin, moved), 0.0, 1e-3 * glm::length(moved));
      EXPECT_NEAR(glm::distance(ray.direction - middle.direction, direction), 0.0,
                  1e-3 * glm::length(direction));
    }
  }
}

TEST(RayBundle, PartsAreBundlesOfTheirOwn) {
  const RayBundle eye = from_eye(0.7, 1e-3);
  const Bounds2 corner{{0.5f, 0.0f}, {1.0f, 0.5f}};
  const RayBundle part = bundle_through(eye).part(corner);
  const RayBundle own = bundle_through(eye.part(corner));
  EXPECT_NEAR(glm::distance(part.origin, own.origin), 0.0, 1e-5);
  EXPECT_NEAR(glm::distance(part.direction, own.direction), 0.0, 1e-5);
  EXPECT_NEAR(glm::distance(part.right, own.right), 0.0, 1e-2 * glm::length(own.right));
}

// At distances in front of the sphere's focus, at it, and behind it, where the image is reversed.
TEST(RayBundle, PyramidsPassThroughItsCorners) {
  const RayBundle eye = from_eye(0.3, 1e-3);
  const RayBundle out = bundle_through(eye);
  MirrorSurface surface = surface_at(eye, out.origin, true, index);
  surface.geometric = out.direction;
  for (const double t : {0.2, 2.0, 5.0, 50.0}) {
    const auto pyramid = pyramid_around(out, surface, t);
    ASSERT_TRUE(pyramid) << t;
    const PyrayPicture& p = pyramid->picture;
    EXPECT_GT(pyramid->apex_distance, 0.0);
    const MirrorPatch section = out.section(t);
    const double ahead = pyramid->apex_distance + t;
    const glm::dvec3 middle = out.origin + t * out.direction;
    const double size = glm::length(section.right) + glm::length(section.down);
    for (const glm::dvec2 at : {glm::dvec2(0, 0), {1, 0}, {0, 1}, {1, 1}}) {
      const glm::dvec3 corner = p.apex + ahead * (p.corner + at.x * p.right + at.y * p.down);
      const glm::dvec3 expected =
          middle +
          across((at.x - 0.5) * section.right + (at.y - 0.5) * section.down, out.direction);
      EXPECT_NEAR(glm::distance(corner, expected), 0.0, 1e-3 * size) << t;
    }
  }
}

/// Second moments along x at distance t, computed from the bundle's edges: of the position, of
/// position and direction, and of the direction.
glm::dvec3 moments(const RayBundle& bundle, double t) {
  const double place = bundle.section(t).right.x, blurred = t * bundle.lobe_right.x;
  const double turn = bundle.right.x, lobe = bundle.lobe_right.x;
  return glm::dvec3(place * place + blurred * blurred, place * turn + blurred * lobe,
                    turn * turn + lobe * lobe) /
         12.0;
}

// At the section, the blurred part has the rays' width and spread.
TEST(RayBundle, ABlurredOneKeepsItsMomentsAtASection) {
  for (const double lobe : {0.01, 0.1, 0.5}) {
    for (const double turn : {0.04, 0.0, -0.2}) {
      RayBundle bundle{.right_at = {0.1, 0, 0},
                       .down_at = {0, -0.1, 0},
                       .right = {turn, 0, 0},
                       .down = {0, -turn, 0},
                       .lobe_right = {lobe, 0, 0},
                       .lobe_down = {0, -lobe, 0}};
      for (const double t : {0.01, 0.3, 4.0}) {
        // The box of the combined width is spread within the section's frame.
        const double own = std::abs(0.1 + t * turn), blur = t * lobe;
        const double share = std::hypot(own, blur) / (own + blur);
        const auto lo = static_cast<float>(0.5 - 0.5 * share);
        const auto hi = static_cast<float>(0.5 + 0.5 * share);
        const RayBundle found = bundle.blurred_part({{lo, lo}, {hi, hi}}, t);
        EXPECT_NEAR(found.section(t).right.x,
                    (0.1 + t * turn < 0.0 ? -1 : 1) * std::hypot(own, blur), 1e-6);
        for (const double beyond : {0.0, 0.5, 7.0}) {
          // The remaining blur starts at the section.
          RayBundle from_section = found;
          from_section.right_at = found.section(t).right;
          const glm::dvec3 expected = moments(bundle, t + beyond);
          const glm::dvec3 seen = moments(from_section, beyond);
          for (int k = 0; k < 3; ++k)
            EXPECT_NEAR(seen[k], expected[k], 1e-6 * std::abs(expected[k]) + 1e-9)
                << lobe << ' ' << turn << ' ' << t << ' ' << beyond << ' ' << k;
        }
      }
    }
  }
}

/// Second moments of positions and directions along x, at distance t from a bundle's origin.
glm::dvec3 all_moments(const RayBundle& bundle, double t) {
  const double place = bundle.section(t).right.x, blur = bundle.blur_of_section(t).right.x;
  const double turn = bundle.right.x, lobe = bundle.lobe_right.x;
  return {place * place + blur * blur, place * turn + blur * lobe, turn * turn + lobe * lobe};
}

double fourth_powers(const RayBundle& bundle, double t) {
  return std::pow(bundle.section(t).right.x, 4.0) +
         std::pow(bundle.blur_of_section(t).right.x, 4.0);
}

// The moments of several lobes add up at every distance. At the section the shape is right, too, as
// far as two boxes can represent three.
TEST(RayBundle, LobesAddUpTheirMoments) {
  for (const double second : {0.05, 0.3, 1.0}) {
    RayBundle bundle{.right_at = {0.1, 0, 0},
                     .down_at = {0, -0.1, 0},
                     .right = {0.02, 0, 0},
                     .down = {0, -0.02, 0}};
    constexpr double first = 0.2;
    bundle.add_lobe({{1, 0, 0}, {0, -1, 0}, first}, 3.0);
    EXPECT_NEAR(bundle.right.x, 0.02, 1e-12) << "two boxes are represented exactly";
    EXPECT_NEAR(std::abs(bundle.lobe_right.x), first, 1e-12);
    EXPECT_NEAR(bundle.lobe_right_at.x, 0.0, 1e-12);
    // Moves the bundle to a surface half a unit away.
    bundle.right_at = bundle.section(0.5).right, bundle.down_at = bundle.section(0.5).down;
    bundle.lobe_right_at = bundle.blur_of_section(0.5).right;
    bundle.lobe_down_at = bundle.blur_of_section(0.5).down;
    const RayBundle before = bundle;
    constexpr double depth = 4.0;
    bundle.add_lobe({{1, 0, 0}, {0, -1, 0}, second}, depth);
    for (const double t : {0.0, 1.0, depth, 20.0}) {
      const double width = second * t;
      const glm::dvec3 expected =
          all_moments(before, t) + glm::dvec3(width * width, width * second, second * second);
      const glm::dvec3 found = all_moments(bundle, t);
      for (int k = 0; k < 3; ++k) EXPECT_NEAR(found[k], expected[k], 1e-9) << second << ' ' << t;
    }
    const double fourth = fourth_powers(before, depth) + std::pow(second * depth, 4.0);
    const double variance = all_moments(bundle, depth).x;
    EXPECT_NEAR(fourth_powers(bundle, depth), std::max(fourth, 0.5 * variance * variance), 1e-9);
    EXPECT_NEAR(glm::length(bundle.down), glm::length(bundle.right), 1e-12);
  }
}

}  // namespace
}  // namespace asos
