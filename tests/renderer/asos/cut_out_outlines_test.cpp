#include "tests/support/make_settings.h"
#include "tests/support/render_picture.h"
#include "tests/support/tiny_image.h"
#include "tests/support/tiny_scene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <numbers>
#include <utility>
#include <vector>

// The covered fraction of pixels for shapes in a texture's alpha, from many texels per pixel to
// fractions of one, against the area of the curve alpha = cutoff.

namespace asos::test::cut_out_outlines_test {
namespace {

constexpr int texels = 64;
constexpr glm::dvec2 middle(32.3, 31.6);
constexpr double radius = 20.7;

using Alpha = double (*)(glm::dvec2 texel);

/// Alpha of a disk, from the distance to its rim; the transition is one texel wide.
double disk(glm::dvec2 p) {
  return 0.5 + radius - glm::distance(p, middle);
}
double hard_disk(glm::dvec2 p) {
  return glm::distance(p, middle) < radius ? 1.0 : 0.0;
}
double half_plane(glm::dvec2 p) {
  return 0.5 + 0.031 * (0.8 * (p.x - middle.x) + 0.6 * (p.y - middle.y));
}

std::uint8_t byte_of(double alpha) {
  return static_cast<std::uint8_t>(std::lround(255.0 * std::clamp(alpha, 0.0, 1.0)));
}

/// Texels begin at integers: the image's corner is the origin, y points down.
class Painting {
 public:
  explicit Painting(Alpha alpha) {
    for (int y = 0; y < texels; ++y)
      for (int x = 0; x < texels; ++x) bytes_.push_back(byte_of(alpha(glm::dvec2(x, y) + 0.5)));
  }

  [[nodiscard]] std::uint8_t at(int x, int y) const {
    const auto inside = [](int i) { return std::clamp(i, 0, texels - 1); };
    return bytes_[static_cast<std::size_t>(inside(y) * texels + inside(x))];
  }

  /// The area of a rectangle where bilinear alpha is at least `cutoff`, integrated over lines, on
  /// which alpha is linear between texel centres.
  [[nodiscard]] double kept(glm::dvec2 lo, glm::dvec2 hi, double cutoff) const {
    const int lines = static_cast<int>(std::ceil(std::max(2048.0, 512.0 * (hi.y - lo.y))));
    double sum = 0.0;
    for (int i = 0; i < lines; ++i) sum += kept_of_line(lo, hi, cutoff, (i + 0.5) / lines);
    return sum * (hi.y - lo.y) / lines;
  }

 private:
  [[nodiscard]] double kept_of_line(glm::dvec2 lo, glm::dvec2 hi, double cutoff, double at) const {
    const double y = lo.y + at * (hi.y - lo.y) - 0.5, row = std::floor(y), fy = y - row;
    const auto alpha = [&](int x) {
      return ((1.0 - fy) * this->at(x, static_cast<int>(row)) +
              fy * this->at(x, static_cast<int>(row) + 1)) /
             255.0;
    };
    double sum = 0.0;
    for (double x = lo.x; x < hi.x;) {
      const double cell = std::floor(x - 0.5), end = std::min(hi.x, cell + 1.5);
      const double a = alpha(static_cast<int>(cell)), b = alpha(static_cast<int>(cell) + 1);
      const double from = a + (x - 0.5 - cell) * (b - a) - cutoff;
      const double to = a + (end - 0.5 - cell) * (b - a) - cutoff;
      if (from >= 0.0 && to >= 0.0) {
        sum += end - x;
      } else if (from >= 0.0 || to >= 0.0) {
        sum += std::max(from, to) / std::abs(from - to) * (end - x);
      }
      x = end;
    }
    return sum;
  }

  std::vector<std::uint8_t> bytes_;
};

/// A card of `texels` units in front of a black wall. The picture shows a window around `at` (in
/// texels) with `texels_a_pixel`.
struct Shot {
  Alpha alpha;
  double texels_a_pixel;
  glm::dvec2 at;
  int pixels = 24;

  [[nodiscard]] Picture taken() const {
    const Painting painting(alpha);
    World world;
    add_quad(world, {-1e4f, -1e4f, -5}, {2e4f, 0, 0}, {0, 2e4f, 0}, unlit({0, 0, 0}));
    Material card = unlit({1, 1, 1});
    card.alpha_mode = AlphaMode::mask;
    card.base_color_texture.texture =
        add_texture(world,
                    make_image(texels, texels,
                               [&](int x, int y) -> Texel {
                                 return {255, 255, 255, painting.at(x, y)};
                               }),
                    Wrap::clamp_to_edge, Filter::linear);
    // v goes down.
    add_quad(world, {-at.x, at.y, 0}, {texels, 0, 0}, {0, -texels, 0}, card);
    RenderSettings settings = make_settings(pixels, pixels);
    settings.cull = false;
    settings.asos.max_level = 3;
    return render_picture(*make_render_scene(std::move(world)),
                          orthographic(texels_a_pixel * pixels), settings);
  }

  /// The corner of the card's area that a pixel shows.
  [[nodiscard]] glm::dvec2 corner(int x, int y) const {
    return at + texels_a_pixel * (glm::dvec2(x, y) - 0.5 * pixels);
  }
};

struct Errors {
  double worst = 0.0;
  double shown = 0.0;  ///< area in texels
  int partly = 0;
};

Errors errors_of(const Shot& shot) {
  const Painting painting(shot.alpha);
  const Picture picture = shot.taken();
  EXPECT_EQ(picture.statistics.missed_splits, 0u);
  Errors errors;
  for (int y = 0; y < shot.pixels; ++y) {
    for (int x = 0; x < shot.pixels; ++x) {
      const glm::dvec2 all(0.0), image(texels);
      const glm::dvec2 lo = glm::clamp(shot.corner(x, y), all, image);
      const glm::dvec2 hi = glm::clamp(shot.corner(x + 1, y + 1), all, image);
      const double pixel = shot.texels_a_pixel * shot.texels_a_pixel;
      const double exact = painting.kept(lo, hi, 0.5) / pixel;
      const double found = static_cast<double>(
          picture.film.radiance[static_cast<std::size_t>(y * shot.pixels + x)].x);
      errors.worst = std::max(errors.worst, std::abs(found - exact));
      errors.shown += found * pixel;
      errors.partly += exact > 0.01 && exact < 0.99;
    }
  }
  return errors;
}

constexpr double scales[] = {0.125, 0.25, 0.5, 1.0, 2.0, 4.0, 8.0};

TEST(CutOutOutlines, CoverPixelsByTheAreaOfTheirCurve) {
  for (const double scale : scales) {
    const double angle = 0.7;
    const glm::dvec2 rim = middle + radius * glm::dvec2(std::cos(angle), std::sin(angle));
    for (const Alpha alpha : {&disk, &hard_disk}) {
      const Errors errors = errors_of({alpha, scale, scale > 1.0 ? middle : rim});
      EXPECT_LT(errors.worst, 1e-3) << scale << (alpha == &disk ? " soft" : " hard");
      EXPECT_GT(errors.partly, 10) << scale;
    }
    const Errors straight = errors_of({&half_plane, scale, middle});
    EXPECT_LT(straight.worst, 1e-3) << scale << " straight";
    EXPECT_GT(straight.partly, 5) << scale;
  }
}

// Accuracy that 8-bit alpha and the texel size allow for a disk's rim: a hundredth of a texel if it
// is soft, a quarter if it is hard.
TEST(CutOutOutlines, ShowTheDiskThatWasPainted) {
  const double area = std::numbers::pi * radius * radius;
  const double rim = 2.0 * std::numbers::pi * radius;
  for (const double scale : {2.0, 4.0, 8.0}) {
    EXPECT_NEAR(errors_of({&disk, scale, middle, 32}).shown, area, 0.01 * rim) << scale;
    EXPECT_NEAR(errors_of({&hard_disk, scale, middle, 32}).shown, area, 0.25 * rim) << scale;
  }
}

}  // namespace
}  // namespace asos::test::cut_out_outlines_test
