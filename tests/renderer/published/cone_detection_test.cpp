#include "renderer/published/cone_detection.h"

#include "renderer/comparison/method.h"
#include "tests/support/make_settings.h"
#include "tests/support/tiny_scene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

namespace asos::test {
namespace {

/// Random frames over skewed parallelograms, their cells, and segments near those; seeded.
class Draw {
 public:
  explicit Draw(unsigned seed) : random_(seed) {}

  double between(double lo, double hi) {
    return std::uniform_real_distribution<double>(lo, hi)(random_);
  }
  glm::dvec3 direction() {
    glm::dvec3 d;
    do {
      d = {between(-1, 1), between(-1, 1), between(-1, 1)};
    } while (glm::length(d) > 1.0 || glm::length(d) < 0.1);
    return glm::normalize(d);
  }

  /// A base of `width` at distance 1, rotated and skewed.
  Frame frame(double width, bool parallel) {
    const glm::dvec3 axis = direction();
    const glm::dvec3 right = glm::normalize(glm::cross(axis, direction()));
    const glm::dvec3 down = glm::cross(axis, right);
    const double skew = between(-0.8, 0.8);
    const glm::dvec3 a = width * (right + 0.2 * between(-1, 1) * axis);
    const glm::dvec3 b =
        width * between(0.5, 2.0) * (down + skew * right + 0.2 * between(-1, 1) * axis);
    const glm::dvec3 corner = axis + width * (between(-1, 1) * right + between(-1, 1) * down);
    if (parallel) return Frame::prism(10.0 * direction(), axis, a, b);
    return Frame::pyramid(10.0 * direction(), corner, a, b);
  }
  /// Narrow like a pixel, wide as a picture, or a prism.
  Frame any_frame(unsigned seed) {
    const double width = seed % 3 == 0 ? 1e-3 : between(0.05, 0.4);
    return frame(width, seed % 3 == 2);
  }
  Square cell() {
    const int level = static_cast<int>(between(0, 9));
    const auto n = static_cast<float>(1 << level);
    const auto at = [&] { return std::floor(static_cast<float>(between(0, 0.999)) * n) / n; };
    const float u = at();
    return {u, at(), 1.0f / n};
  }
  /// A point in the cell or up to its width away.
  glm::vec2 point(const Square& cell) {
    const double side = static_cast<double>(cell.side);
    const double u = cell.centre_u() + side * between(-1.5, 1.5);
    return {u, cell.centre_v() + side * between(-1.5, 1.5)};
  }
  Segment segment(const Square& cell) {
    const glm::vec2 p = point(cell), q = point(cell);
    return {p.x, p.y, 1, q.x, q.y, 1, 0};
  }

 private:
  std::mt19937 random_;
};

/// Deviation of a point from a cell's axis: the angle, or the distance in a prism.
double off_axis(const Frame& frame, const Square& cell, glm::dvec2 p) {
  const glm::dvec2 centre(cell.centre_u(), cell.centre_v());
  const auto towards = [&](glm::dvec2 q) {
    return frame.base_corner() + q.x * frame.base_u() + q.y * frame.base_v();
  };
  if (frame.parallel()) {
    const glm::dvec2 d = p - centre;
    const glm::dvec3 e = d.x * frame.base_u() + d.y * frame.base_v();
    return glm::length(e - glm::dot(e, frame.direction()) * frame.direction());
  }
  const glm::dvec3 x = towards(centre), y = towards(p);
  return std::atan2(glm::length(glm::cross(x, y)), glm::dot(x, y));
}

/// Half angle of the cone, or radius of the cylinder: that of the cell's farthest corner.
double half_angle(const Frame& frame, const Square& cell) {
  double most = 0.0;
  for (int i = 0; i < 4; ++i) {
    const glm::dvec2 corner(cell.u + (i & 1 ? cell.side : 0.0f),
                            cell.v + (i & 2 ? cell.side : 0.0f));
    most = std::max(most, off_axis(frame, cell, corner));
  }
  return most;
}

constexpr unsigned cases = 1000;

TEST(ConeDetection, NeverMissesWhatMeetsTheSquare) {
  int found = 0, only_cone = 0;
  for (unsigned seed = 0; seed < cases; ++seed) {
    Draw draw(seed);
    const ConeDetection cone(draw.any_frame(seed));
    const Square cell = draw.cell();
    for (int i = 0; i < 100; ++i) {
      const Segment s = draw.segment(cell);
      const bool near = !clip(s, cone.reach(cell)).empty() && cone.near(s, cell);
      if (clip(s, cell).empty()) {
        only_cone += near;
        continue;
      }
      ++found;
      ASSERT_TRUE(near) << "seed " << seed << " segment " << i;
    }
  }
  EXPECT_GT(found, 10000);
  EXPECT_GT(only_cone, 1000);  // the cone is a wider test
}

TEST(ConeDetection, CountsSegmentsWithinTheHalfAngle) {
  int decided = 0;
  for (unsigned seed = 0; seed < cases; ++seed) {
    Draw draw(seed);
    const Frame frame = draw.any_frame(seed);
    const ConeDetection cone(frame);
    const Square cell = draw.cell();
    const double half = half_angle(frame, cell);
    const Segment s = draw.segment(cell);
    // Directions along the segment; between two of them the segment is at most half their angle
    // closer.
    constexpr int n = 2000;
    const glm::dvec2 a(s.u0, s.v0), d = glm::dvec2(s.u1, s.v1) - a;
    double least = 10.0, step = 0.0, last = 0.0;
    for (int i = 0; i <= n; ++i) {
      const double off = off_axis(frame, cell, a + d * (static_cast<double>(i) / n));
      least = std::min(least, off);
      if (i > 0) step = std::max(step, std::abs(off - last));
      last = off;
    }
    if (least < half * (1.0 - 1e-9)) {
      ++decided;
      EXPECT_TRUE(cone.near(s, cell)) << "seed " << seed << " " << least / half;
    } else if (least - step > half) {
      ++decided;
      EXPECT_FALSE(cone.near(s, cell)) << "seed " << seed << " " << least / half;
    }
  }
  EXPECT_GT(decided, 990);
}

TEST(ConeDetection, ReachIsTightAroundTheCone) {
  for (unsigned seed = 0; seed < cases; ++seed) {
    Draw draw(seed);
    const Frame frame = draw.any_frame(seed);
    const ConeDetection cone(frame);
    const Square cell = draw.cell();
    const Square reach = cone.reach(cell);
    const double half = half_angle(frame, cell);
    const double allowed = 0.5 * reach.side * (1.0 + 1e-5);
    // Bisects, along each direction, for the cone's border.
    double widest = 0.0;
    for (int i = 0; i < 360; ++i) {
      const double turn = glm::radians(static_cast<double>(i));
      const glm::dvec2 way(std::cos(turn), std::sin(turn));
      const glm::dvec2 centre(cell.centre_u(), cell.centre_v());
      double in = 0.0, out = 4.0 * cell.side;
      for (int k = 0; k < 40; ++k) {
        const double middle = 0.5 * (in + out);
        (off_axis(frame, cell, centre + middle * way) < half ? in : out) = middle;
      }
      widest = std::max({widest, std::abs(in * way.x), std::abs(in * way.y)});
    }
    EXPECT_LE(widest, allowed) << "seed " << seed;
    EXPECT_GE(widest, 0.999 * 0.5 * reach.side) << "seed " << seed;
  }
}

// CGF'98 section 6.1 passes hit lists down. Cylinders of prisms are nested. Cones of pyramids are
// nested up to the square of their half angle: the picture's plane foreshortens the outer half of
// the parent.
TEST(ConeDetection, ChildrensConesLieWithinTheirParents) {
  for (unsigned seed = 0; seed < cases; ++seed) {
    Draw draw(seed);
    const Frame frame = draw.any_frame(seed);
    const Square cell = draw.cell();
    const double parent = half_angle(frame, cell);
    for (int i = 0; i < 4; ++i) {
      const Square child = cell.quarter(i);
      const double off = off_axis(frame, cell, {child.centre_u(), child.centre_v()});
      const double slack = frame.parallel() ? 1e-6 : 1e-6 + parent;
      EXPECT_LE(off + half_angle(frame, child), parent * (1.0 + slack)) << "seed " << seed;
    }
  }
}

RenderSettings settings_of(Detection detect, LeafKind leaf, double eps) {
  RenderSettings settings = make_settings(32, 32);
  settings.asos.max_level = 6;
  settings.asos.eps = eps;
  settings.asos.detect = detect;
  settings.asos.leaf = leaf;
  return settings;
}

std::vector<glm::vec3> render(const RenderScene& scene, const RenderSettings& settings) {
  const View view(orthographic(4.0), settings.width, settings.height);
  std::vector<glm::vec3> picture;
  for (int y = 0; y < settings.height; y += block_size) {
    for (int x = 0; x < settings.width; x += block_size) {
      const BlockResult block = render_block(scene, view, settings, {x, y, block_size, block_size});
      picture.insert(picture.end(), block.tile.radiance.begin(), block.tile.radiance.end());
    }
  }
  return picture;
}

double greatest_difference(const std::vector<glm::vec3>& a, const std::vector<glm::vec3>& b) {
  float most = 0.0f;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const glm::vec3 d = glm::abs(a[i] - b[i]);
    most = std::max({most, d.x, d.y, d.z});
  }
  return static_cast<double>(most);
}

// White on black, so that a pixel's value is the covered fraction.
World one_triangle() {
  World world;
  add_triangle(world, {-1.7f, -1.1f, 0}, {1.6f, -0.8f, 0}, {0.3f, 1.6f, 0}, unlit({1, 1, 1}));
  return world;
}

TEST(ConeDetection, PicturesKeepEps) {
  const auto scene = make_render_scene(one_triangle());
  RenderSettings exact = settings_of(Detection::square, LeafKind::exact, 0.0);
  exact.method = Method::beam;
  const auto truth = render(*scene, exact);
  for (const double eps : {1.0 / 4.0, 1.0 / 16.0, 1.0 / 32.0}) {
    RenderSettings published = settings_of(Detection::square, LeafKind::point, eps);
    published.asos.rule = StoppingRule::published;
    const auto by_square = render(*scene, published);
    published.asos.detect = Detection::cone;
    const auto by_cone = render(*scene, published);
    published.method = Method::asos_published;
    EXPECT_EQ(greatest_difference(render(*scene, published), by_cone), 0.0);
    EXPECT_LE(greatest_difference(by_square, truth), eps + 1e-5);
    EXPECT_LE(greatest_difference(by_cone, truth), eps + 1e-5);
    EXPECT_LE(greatest_difference(by_cone, by_square), eps + 1e-5);
  }
}

TEST(ConeDetection, ExactLeavesShowTheSamePicture) {
  World world = one_triangle();
  add_quad(world, {-0.9f, -1.6f, 1}, {1.1f, 0.3f, 0}, {-0.2f, 2.9f, 0}, unlit({0.8f, 0.2f, 0.1f}));
  const auto scene = make_render_scene(std::move(world));
  const auto by_square = render(*scene, settings_of(Detection::square, LeafKind::exact, 0.0));
  const auto by_cone = render(*scene, settings_of(Detection::cone, LeafKind::exact, 0.0));
  EXPECT_LE(greatest_difference(by_cone, by_square), 1e-5);
}

}  // namespace
}  // namespace asos::test
