#include "renderer/prepared/render_scene.h"
#include "renderer/scene/builtin.h"
#include "tests/support/render_picture.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

// MAX limits the work and EPS may end it sooner (CGF'98 section 3.1): both change picture, split
// map and work.

namespace asos::test::max_and_eps_test {
namespace {

constexpr int width = 48, height = 27;

/// RMSE of linear radiance clipped to 0..1.
double rmse(const Film& a, const Film& b) {
  double squares = 0.0;
  for (std::size_t i = 0; i < a.radiance.size(); ++i) {
    const glm::dvec3 off(glm::clamp(a.radiance[i], 0.0f, 1.0f) -
                         glm::clamp(b.radiance[i], 0.0f, 1.0f));
    squares += glm::dot(off, off) / 3.0;
  }
  return std::sqrt(squares / static_cast<double>(a.radiance.size()));
}

class MaxAndEps : public testing::TestWithParam<const char*> {
 protected:
  [[nodiscard]] Picture picture(int max_level, double eps) const {
    RenderSettings settings = settings_;
    settings.asos.max_level = max_level;
    settings.asos.eps = eps;
    return render_picture(*scene_, camera_, settings);
  }
  [[nodiscard]] Film truth() const {
    RenderSettings settings = settings_;
    settings.method = Method::sobol;
    settings.sampling.spp = 512;
    return render_picture(*scene_, camera_, settings).film;
  }
  void SetUp() override {
    settings_.width = width;
    settings_.height = height;
  }

 private:
  RenderSettings settings_;
  std::shared_ptr<const RenderScene> scene_ = *prepare(*builtin_scene(GetParam()));
  Camera camera_ = first_camera(scene_->world(), 16.0 / 9.0);
};

TEST_P(MaxAndEps, MaxBoundsTheWorkAndTheError) {
  const Film exact = truth();
  double error_at[7] = {};
  std::uint64_t rays_at[7] = {};
  Film last(width, height);
  for (int max_level = 0; max_level <= 6; ++max_level) {
    const Picture found = picture(max_level, 1.0 / 1024.0);
    error_at[max_level] = rmse(found.film, exact);
    rays_at[max_level] = found.statistics.rays();
    RecordProperty("error_at_" + std::to_string(max_level), std::to_string(error_at[max_level]));
    if (max_level > 0) {
      EXPECT_NE(found.film.radiance, last.radiance) << "MAX " << max_level;
      const bool same_map =
          found.film.split_level == last.split_level && found.film.samples == last.samples;
      EXPECT_FALSE(same_map) << "MAX " << max_level;
    }
    last = found.film;
  }
  EXPECT_LT(error_at[1], 0.7 * error_at[0]);
  EXPECT_LT(error_at[2], 0.7 * error_at[1]);
  EXPECT_LT(error_at[3], 0.9 * error_at[2]);
  EXPECT_LT(error_at[4], 1.05 * error_at[3]);
  EXPECT_LT(error_at[6], 1.05 * error_at[4]);
  EXPECT_GT(error_at[1], 1.5 * error_at[4]);
  // Between these levels the number of rays may fall: exact answers replace rays.
  EXPECT_LT(rays_at[0], rays_at[1]);
  EXPECT_LT(rays_at[1], rays_at[4]);
  EXPECT_LT(rays_at[4], rays_at[6]);
}

TEST_P(MaxAndEps, EpsEndsTheWorkSooner) {
  const Film exact = truth();
  double last_error = 1.0;
  std::uint64_t last_rays = 0;
  Film last(width, height);
  for (const double eps : {1.0 / 8.0, 1.0 / 32.0, 1.0 / 128.0, 1.0 / 512.0}) {
    const Picture found = picture(4, eps);
    const double error = rmse(found.film, exact);
    RecordProperty("error_at_" + std::to_string(static_cast<int>(1.0 / eps)),
                   std::to_string(error));
    EXPECT_GT(found.statistics.rays(), last_rays) << "EPS " << eps;
    EXPECT_LT(error, 1.02 * last_error) << "EPS " << eps;
    EXPECT_LT(error, eps) << "EPS " << eps;
    EXPECT_NE(found.film.radiance, last.radiance) << "EPS " << eps;
    last_error = error;
    last_rays = found.statistics.rays();
    last = found.film;
  }
}

INSTANTIATE_TEST_SUITE_P(Scenes, MaxAndEps,
                         testing::Values("boxes", "house", "primitives-ball", "mixed", "dense",
                                         "office-metal"),
                         [](const auto& scene) {
                           std::string name = scene.param;
                           std::erase(name, '-');
                           return name;
                         });

}  // namespace
}  // namespace asos::test::max_and_eps_test
