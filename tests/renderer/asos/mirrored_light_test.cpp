#include "renderer/prepared/render_scene.h"
#include "renderer/scene/builtin.h"
#include "tests/support/make_settings.h"
#include "tests/support/render_picture.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

// Small images of a bright light in a curved mirror that another mirror shows.

namespace asos::test {
namespace {

// A column of pixels with four images of lights, reflected by a sphere and then by a cylinder. An
// image displaced by a fraction of a pixel would be in another pixel.
TEST(MirroredLight, HasTheRightPlaceAfterTwoCurvedMirrors) {
  const auto scene = *prepare(*builtin_scene("solids"));
  RenderSettings settings = make_settings(160, 90);
  settings.crop = {76, 16, 4, 14};
  const Camera camera = first_camera(scene->world(), 160.0 / 90.0);
  const Film found = render_picture(*scene, camera, settings).film;
  settings.method = Method::sobol;
  settings.sampling.spp = 1024;
  const Film truth = render_picture(*scene, camera, settings).film;
  int shown = 0;
  for (int y = settings.crop.y; y < settings.crop.y + settings.crop.height; ++y) {
    for (int x = settings.crop.x; x < settings.crop.x + settings.crop.width; ++x) {
      const std::size_t i = static_cast<std::size_t>(y) * 160 + static_cast<std::size_t>(x);
      const auto displayed = [i](const Film& film) {
        return std::min(1.0f, std::max(film.radiance[i].x, film.radiance[i].y));
      };
      EXPECT_NEAR(displayed(found), displayed(truth), 0.15f) << x << ", " << y;
      shown += displayed(truth) > 0.9f;
    }
  }
  EXPECT_GE(shown, 4);
}

// The light's image covers a hundredth of the pixel, but makes all of it white; 16 or 64 samples
// miss it.
TEST(MirroredLight, IsFoundWhereFewSamplesMissIt) {
  const auto scene = *prepare(*builtin_scene("solids"));
  const Camera camera = first_camera(scene->world(), 320.0 / 180.0);
  for (const int x : {140, 162}) {
    RenderSettings settings = make_settings(320, 180);
    settings.crop = {x, 64, 1, 1};
    settings.sampling.spp = 1024;
    const auto red = [&](Method method, int seed) {
      settings.method = method;
      settings.seed = seed;
      const Film film = render_picture(*scene, camera, settings).film;
      return film.radiance[film.index(x, 64)].x;
    };
    // Clipped, because values above white are displayed as white.
    const float truth = std::min(1.0f, red(Method::sobol, 0));
    for (const int seed : {0, 1, 2, 3})
      EXPECT_NEAR(std::min(1.0f, red(Method::asos, seed)), truth, 0.1f) << x << ", seed " << seed;
  }
}

}  // namespace
}  // namespace asos::test
