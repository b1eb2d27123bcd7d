#include "renderer/prepared/render_scene.h"
#include "renderer/scene/builtin.h"
#include "tests/support/make_settings.h"
#include "tests/support/render_picture.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace asos::test {
namespace {

// Twigs in front of a lamp thirty times as bright as white. It is visible in about 0.005 of each
// pixel, which few samples hit.
TEST(Glare, ShowsLampThroughNarrowGaps) {
  const auto scene = *prepare(*builtin_scene("park"));
  RenderSettings settings = make_settings(160, 90);
  const Camera camera = first_camera(scene->world(), 160.0 / 90.0);
  for (const PixelRect& pixel : {PixelRect{75, 45, 1, 1}, PixelRect{41, 25, 1, 1}}) {
    settings.crop = pixel;
    const auto red = [&](Method method) {
      settings.method = method;
      settings.sampling.spp = 16384;
      const Film film = render_picture(*scene, camera, settings).film;
      return std::min(1.0f, film.radiance[static_cast<std::size_t>(pixel.y * 160 + pixel.x)].x);
    };
    const float truth = red(Method::sobol);
    ASSERT_GT(truth, 0.45f) << "the lamp is visible: its surroundings are at 0.33";
    EXPECT_NEAR(red(Method::asos), truth, 0.1f) << pixel.x;
  }
}

}  // namespace
}  // namespace asos::test
