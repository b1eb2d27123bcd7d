#include "renderer/gltf/load.h"
#include "renderer/prepared/render_scene.h"
#include "renderer/shading/sky.h"
#include "tests/support/make_settings.h"
#include "tests/support/render_picture.h"
#include "tests/support/shared_dir.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <string>

// Small files from bug reports about other viewers, with the values that glTF requires
// (reported/INDEX.tsv of the shared folder).

namespace asos::test::reported_files_test {
namespace {

constexpr int width = 160, height = 90;

std::shared_ptr<const RenderScene> reported(const std::string& name) {
  const auto shared = shared_dir();
  if (!shared) return nullptr;
  const auto path = *shared / "reported" / name;
  if (!std::filesystem::exists(path)) return nullptr;
  return prepare(load_scene(path.string()).value()).value();
}

Film film_of(const RenderScene& scene, Method method, glm::vec3 sky, int spp = 16) {
  RenderSettings settings = make_settings(width, height, method, spp);
  settings.sky = std::make_shared<const Sky>(sky);
  const double aspect = static_cast<double>(width) / height;
  return render_picture(scene, first_camera(scene.world(), aspect), settings).film;
}

glm::vec3 at(const Film& film, double u, double v) {
  return glm::vec3(
      film.radiance[film.index(static_cast<int>(u * width), static_cast<int>(v * height))]);
}

constexpr Method methods[] = {Method::asos, Method::sobol};

TEST(ReportedFiles, SmoothLowPolyMetalHasNoBlackRim) {
  const auto scene = reported("black-rim_low-poly-smooth-metal-roughness-0.1.glb");
  if (!scene) GTEST_SKIP() << "the shared folder is missing";
  for (const Method method : methods) {
    const Film film = film_of(*scene, method, glm::vec3(1.0f), 64);
    float least = 1.0f;
    for (const auto& c : film.radiance) least = std::min(least, static_cast<float>(c.y));
    // Seen at a grazing angle the lobe itself returns 0.96 of the light (lobe_norms).
    EXPECT_GT(least, 0.95f);
  }
}

TEST(ReportedFiles, AllOf200BlendedLayersAreSeen) {
  const auto scene = reported("blend-layers-beyond-64-are-black_200-layers.glb");
  if (!scene) GTEST_SKIP() << "the shared folder is missing";
  for (const Method method : methods) {
    const glm::vec3 c = at(film_of(*scene, method, glm::vec3(0.0f), 1), 0.5, 0.5);
    EXPECT_NEAR(c.r, 0.982f, 2e-3f);
    EXPECT_NEAR(c.g, 1.0f, 2e-3f);
    EXPECT_NEAR(c.b, 0.982f, 2e-3f);
  }
}

TEST(ReportedFiles, ABlendedDecalOnAWallIsWhole) {
  const auto scene = reported("coplanar-decal-speckles_blend-on-wall.glb");
  if (!scene) GTEST_SKIP() << "the shared folder is missing";
  for (const Method method : methods) {
    const Film film = film_of(*scene, method, glm::vec3(0.0f));
    const glm::vec3 middle = at(film, 0.5, 0.5);
    for (int y = -8; y <= 8; ++y) {
      for (int x = -8; x <= 8; ++x) {
        const glm::vec3 c = at(film, 0.5 + 0.01 * x, 0.5 + 0.01 * y);
        EXPECT_NEAR(c.r, middle.r, 2e-3f) << x << ' ' << y;
        EXPECT_NEAR(c.b, middle.b, 2e-3f) << x << ' ' << y;
      }
    }
    EXPECT_GT(middle.r, 0.5f) << "the decal lies over the wall";
  }
}

TEST(ReportedFiles, ASmoothSphereUnderASunHasNoStairsOfTriangles) {
  const auto scene = reported("shadow-terminator_smooth-sphere-16x16-under-sun.glb");
  if (!scene) GTEST_SKIP() << "the shared folder is missing";
  for (const Method method : methods) {
    const Film film = film_of(*scene, method, glm::vec3(0.0f));
    // Within the silhouette of the smooth sphere, shading varies smoothly.
    float most = 0.0f;
    for (int y = 0; y < height; ++y) {
      for (int x = 0; x + 1 < width; ++x) {
        if (std::hypot(x - 56.0, y - 37.5) > 14.0) continue;
        most = std::max(most, std::abs(static_cast<float>(film.radiance[film.index(x + 1, y)].x -
                                                          film.radiance[film.index(x, y)].x)));
      }
    }
    EXPECT_LT(most, 0.06f);
  }
}

}  // namespace
}  // namespace asos::test::reported_files_test
