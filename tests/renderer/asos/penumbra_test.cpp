#include "renderer/prepared/render_scene.h"
#include "renderer/scene/builtin.h"
#include "tests/support/render_picture.h"

#include <gtest/gtest.h>

#include <cmath>

namespace asos::test::penumbra_test {
namespace {

/// Root mean square over the pixels of a part of two pictures, and channels.
double off(const Film& a, const Film& b, PixelRect part) {
  double squares = 0.0;
  for (int y = part.y; y < part.y + part.height; ++y) {
    for (int x = part.x; x < part.x + part.width; ++x) {
      const auto pixel = static_cast<std::size_t>(y * a.width + x);
      const glm::dvec3 d = glm::dvec3(a.radiance[pixel]) - glm::dvec3(b.radiance[pixel]);
      squares += glm::dot(d, d) / 3.0;
    }
  }
  return std::sqrt(squares / (part.width * part.height));
}

// Beside a box, where its shadow begins: a few leaves know it better than samples do, which are
// told to be known by chance in a pixel or other. Sampled, they were off by a third of EPS at MAX
// 3, and by an eighth at MAX 2, whose verdicts ask for less.
TEST(Penumbra, IsSplitWhereThatTakesFewLeaves) {
  const auto scene = *prepare(*builtin_scene("boxes"));
  const Camera camera = first_camera(scene->world(), 16.0 / 9.0);
  RenderSettings settings;
  settings.width = 320;
  settings.height = 180;
  settings.crop = {32, 96, 32, 16};
  RenderSettings many = settings;
  many.method = Method::sobol;
  many.sampling.spp = 4096;
  const Film truth = render_picture(*scene, camera, many).film;
  settings.asos.max_level = 3;
  const Film found = render_picture(*scene, camera, settings).film;
  EXPECT_LT(off(found, truth, settings.crop), 0.2 * settings.asos.eps);
}

// The shadows of a fence's palings, half a pixel wide: at MAX 1 they were off by 4 EPS, and single
// pixels by 16, where the shadows' verdicts asked for no more than its other ones.
TEST(Penumbra, IsShownByMaxOne) {
  const auto scene = *prepare(*builtin_scene("turning-fence"));
  const Camera camera = first_camera(scene->world(), 16.0 / 9.0);
  RenderSettings settings;
  settings.width = 320;
  settings.height = 180;
  settings.crop = {40, 112, 160, 4};
  RenderSettings many = settings;
  many.method = Method::sobol;
  many.sampling.spp = 1024;
  const Film truth = render_picture(*scene, camera, many).film;
  settings.asos.max_level = 1;
  const Film found = render_picture(*scene, camera, settings).film;
  EXPECT_LT(off(found, truth, settings.crop), 0.4 * settings.asos.eps);
}

}  // namespace
}  // namespace asos::test::penumbra_test
