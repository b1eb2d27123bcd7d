#pragma once

#include "renderer/comparison/exact_visibility.h"
#include "tests/support/sanitized.h"
#include "tests/support/subdivide_polygons.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <random>
#include <sstream>
#include <string>

// Seeded random polygons in one pixel, with the exact reference's results.

namespace asos::test {

/// The area that each part of the world covers.
inline std::vector<double> by_oracle(const World& world) {
  std::vector<Facet> facets;
  for (std::uint32_t t = 0; t < world.triangles.size(); ++t) {
    std::array<glm::dvec3, 3> corners;
    for (int k = 0; k < 3; ++k) corners[k] = glm::dvec3(world.positions[world.triangles[t][k]]);
    if (const auto facet = make_facet(unit_frame(), t, corners)) facets.push_back(*facet);
  }
  std::vector<double> areas(world.parts.size());
  ExactVisibility visibility;
  for (const VisiblePart& part : visibility.find(facets, {}))
    if (part.facet != VisiblePart::background)
      areas[world.triangle_part[facets[part.facet].triangle]] += part.area;
  return areas;
}

/// One random case, with a text to reproduce it.
class Case {
 public:
  explicit Case(unsigned seed) : random_(seed) { text_ << "seed " << seed; }

  double unit() { return std::uniform_real_distribution<double>(0.0, 1.0)(random_); }
  double between(double lo, double hi) { return lo + (hi - lo) * unit(); }
  glm::dvec2 point() { return {unit(), unit()}; }
  glm::dvec2 direction() {
    const double angle = 2.0 * std::numbers::pi * unit();
    return {std::cos(angle), std::sin(angle)};
  }

  void add(const Polygon& polygon, double depth) {
    add_polygon(scene_, polygon, depth);
    if (polygon.size() >= 20) return;
    text_ << "; depth " << depth;
    for (const glm::dvec2& c : polygon) text_ << " (" << c.x << ", " << c.y << ")";
  }
  void add_half_plane(double depth) {
    const glm::dvec2 p = point();
    add(half_plane(p, direction()), depth);
  }
  void add_triangle(double size, double depth) {
    const glm::dvec2 p(between(0.1, 0.9), between(0.1, 0.9));
    add({p + size * (point() - 0.5), p + size * (point() - 0.5), p + size * (point() - 0.5)},
        depth);
  }
  void add_wedge(double depth) {
    const glm::dvec2 p = point(), d = direction(), n(-d.y, d.x);
    const double angle = between(0.1, 3.0);
    add({p, p + 4.0 * d, p + 4.0 * (std::cos(angle) * d + std::sin(angle) * n)}, depth);
  }
  void add_sliver(double width, double depth) {
    const glm::dvec2 p(between(0.2, 0.8), between(0.2, 0.8)), d = direction();
    const glm::dvec2 n = 0.5 * width * glm::dvec2(-d.y, d.x);
    add({p - 4.0 * d - n, p + 4.0 * d - n, p + 4.0 * d + n, p - 4.0 * d + n}, depth);
  }
  void add_disk(int segments, double depth) {
    const glm::dvec2 centre = point();
    const double radius = between(0.1, 0.5);
    Polygon disk;
    for (int i = 0; i < segments; ++i) {
      const double angle = 2.0 * std::numbers::pi * i / segments;
      disk.push_back(centre + radius * glm::dvec2(std::cos(angle), std::sin(angle)));
    }
    text_ << "; disk " << centre.x << ", " << centre.y << " radius " << radius;
    add(disk, depth);
  }

  [[nodiscard]] const World& world() const { return scene_.world; }
  [[nodiscard]] std::string text() const { return text_.str(); }

 private:
  std::mt19937 random_;
  PolygonScene scene_;
  std::ostringstream text_;
};

/// The largest error of a part's area.
inline double error_of(const Answer& answer, const std::vector<double>& truth) {
  double greatest = 0.0;
  for (std::size_t i = 0; i < truth.size(); ++i)
    greatest = std::max(greatest, std::abs(answer.coverage[i] - truth[i]));
  return greatest;
}

/// The errors of a class of cases, recorded with the test. Counts those over their bound and prints
/// the first few.
class Errors {
 public:
  ~Errors() {
    std::sort(errors_.begin(), errors_.end());
    const auto record = [&](const char* name, double share) {
      const auto last = static_cast<double>(errors_.size() - 1);
      std::ostringstream value;
      value << errors_[static_cast<std::size_t>(share * last)];
      ::testing::Test::RecordProperty(name, value.str());
    };
    if (errors_.empty()) return;
    record("error_median", 0.5);
    record("error_99", 0.99);
    record("error_greatest", 1.0);
    EXPECT_EQ(over_, 0) << "of " << errors_.size() << " cases; greatest error " << errors_.back();
  }

  void check(const Case& c, double error, double bound, const Answer& answer) {
    errors_.push_back(error);
    ASSERT_NEAR(answer.total, 1.0, 1e-9) << c.text();
    if (error <= bound) return;
    if (++over_ <= 3)
      ADD_FAILURE() << "error " << error << " over " << bound << ", unresolved "
                    << answer.outcome.unresolved_area << ", deepest " << answer.outcome.deepest
                    << ": " << c.text();
  }

 private:
  std::vector<double> errors_;
  int over_ = 0;
};

/// Number of cases per class.
inline constexpr unsigned cases = sanitized ? 200 : 1000;
/// The engine's coordinates are floats.
inline constexpr double rounding = 1e-5;

}  // namespace asos::test
