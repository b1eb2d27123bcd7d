#include "renderer/scene/builtin.h"
#include "renderer/session/render_session.h"
#include "tests/support/render_picture.h"

#include <gtest/gtest.h>

#include <array>
#include <vector>

namespace asos::test::coarse_passes_test {
namespace {

// Multiples of quarters of blocks, but not of blocks.
constexpr int width = 44;
constexpr int height = 28;

/// The pictures after each pass: of blocks, of their quarters, of pixels.
std::array<Film, 3> passes(const Snapshot& snapshot) {
  RenderSession session;
  session.restart(snapshot);
  session.wait();
  std::array<Film, 3> shown{Film(width, height), Film(width, height), Film(width, height)};
  std::size_t pixels = 0;
  for (const FinishedTile& tile : session.take_finished()) {
    const std::size_t pass = pixels / (std::size_t{width} * height);
    if (pass >= shown.size()) break;
    EXPECT_TRUE(tile.coarse);
    shown[pass].put(tile);
    pixels += tile.radiance.size();
  }
  return shown;
}

/// Whether each square of this side, counted from the picture's corner, has a single colour.
bool flat_in_squares(const Film& film, int side) {
  bool flat = true;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      flat &= film.radiance[film.index(x, y)] ==
              film.radiance[film.index(x / side * side, y / side * side)];
  return flat;
}

TEST(CoarsePasses, EachHasAQuarterOfThePixelsForASample) {
  Snapshot snapshot;
  snapshot.scene = *prepare(*builtin_scene("boxes"));
  snapshot.camera = first_camera(snapshot.scene->world(), double{width} / height);
  snapshot.settings.width = width;
  snapshot.settings.height = height;
  snapshot.settings.shadow.cast = false;  // shadows would make sampling depend on the pixels
  snapshot.settings.threads = 1;          // passes follow each other
  const auto [blocks, quarters, centres] = passes(snapshot);
  EXPECT_TRUE(flat_in_squares(blocks, 8));
  EXPECT_FALSE(flat_in_squares(blocks, 16));
  EXPECT_TRUE(flat_in_squares(quarters, 4));
  EXPECT_FALSE(flat_in_squares(quarters, 8));
  EXPECT_FALSE(flat_in_squares(centres, 4));

  Snapshot one_sample = snapshot;
  one_sample.settings.method = Method::sobol;
  one_sample.settings.sampling.spp = 1;
  EXPECT_EQ(centres.radiance, render_to_end(one_sample).film.radiance);
  one_sample.settings.method = Method::uniform;  // through pixels' centres
  // A quarter has the colour at its centre, which is a pixel's centre in a smaller picture, except
  // for positions that are rounded in pixels.
  one_sample.settings.width = width / 4;
  one_sample.settings.height = height / 4;
  const Film small = render_to_end(one_sample).film;
  for (int y = 0; y < small.height; ++y)
    for (int x = 0; x < small.width; ++x)
      EXPECT_LT(glm::distance(small.radiance[small.index(x, y)],
                              quarters.radiance[quarters.index(4 * x, 4 * y)]),
                1e-3f)
          << x << " " << y;
}

}  // namespace
}  // namespace asos::test::coarse_passes_test
