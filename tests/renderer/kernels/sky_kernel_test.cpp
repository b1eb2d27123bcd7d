#include "renderer/kernels/sky_kernel.h"

#include "tests/renderer/shading/sky_sums.h"
#include "tests/support/every_target.h"
#include "tests/support/random_space.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>
#include <vector>

// The kernel against the scalar function.

namespace asos::test::sky_kernel_test {
namespace {

struct Subjects {
  std::unique_ptr<ShadingPoints> points = std::make_unique<ShadingPoints>();
  std::unique_ptr<MaterialBatch> materials = std::make_unique<MaterialBatch>();
  std::unique_ptr<SkyBatch> sky = std::make_unique<SkyBatch>();

  explicit Subjects(std::size_t count) {
    RandomSpace space(5);
    points->count = count;
    for (std::size_t i = 0; i < count; ++i) {
      const auto unit = [&] { return static_cast<float>(space.between(0.0, 1.0)); };
      // Axes and the planes between them are where an octahedron is folded.
      glm::vec3 normal(space.direction());
      if (i % 5 == 0) normal[static_cast<int>(i / 5 % 3)] = 0.0f;
      if (i % 7 == 0) normal = glm::vec3(0.0f, i % 2 == 0 ? 1.0f : -1.0f, 0.0f);
      points->normal.set(i, glm::normalize(normal));
      points->to_viewer.set(i, glm::vec3(space.direction()));
      materials->ambient.set(i, {unit(), unit(), unit()});
      materials->specular.set(i, {unit(), unit(), unit()});
      const float least = SkyLobes::least_roughness;
      materials->roughness[i] = i % 9 == 0   ? least
                                : i % 9 == 1 ? 1.0f
                                             : least + (1.0f - least) * unit();
      sky->lobe_reflects[i] = i % 4 == 3 ? 0.0f : 1.0f;
    }
  }

  [[nodiscard]] glm::vec3 scalar(const Sky& of, std::size_t i) const {
    ViewedMaterial seen{};
    seen.ambient = materials->ambient.at(i);
    if (sky->lobe_reflects[i] > 0.0f) seen.specular = materials->specular.at(i);
    seen.lobe.roughness = materials->roughness[i];
    return reflected_sky(&of, seen, points->normal.at(i), points->to_viewer.at(i));
  }
};

TEST(SkyKernel, HasTheBitsOfTheScalarFunction) {
  const Sky sky = Sky(sky_sums::noise_map(64), 33.0, "noise").brightened(1.7);
  for (const std::size_t count : {std::size_t{1}, std::size_t{21}, std::size_t{250}}) {
    Subjects subjects(count);
    for_every_target([&] {
      reflect_sky(sky.picture_lobes(), *subjects.materials, *subjects.points, *subjects.sky);
      for (std::size_t i = 0; i < count; ++i)
        EXPECT_EQ(subjects.sky->diffuse.at(i) + subjects.sky->by_lobe.at(i),
                  subjects.scalar(sky, i))
            << i;
    });
  }
}

TEST(SkyKernel, DirectionThatIsNoNumberStaysAlone) {
  const Sky sky(sky_sums::noise_map(16), 0.0, "noise");
  Subjects subjects(40);
  subjects.points->normal.set(3, glm::vec3(std::numeric_limits<float>::quiet_NaN()));
  subjects.points->normal.set(17, glm::vec3(0.0f));
  for_every_target([&] {
    reflect_sky(sky.picture_lobes(), *subjects.materials, *subjects.points, *subjects.sky);
    for (std::size_t i = 0; i < 40; ++i) {
      const glm::vec3 sum = subjects.sky->diffuse.at(i) + subjects.sky->by_lobe.at(i);
      EXPECT_EQ(std::isfinite(sum.x + sum.y + sum.z), i != 3 && i != 17) << i;
    }
  });
}

}  // namespace
}  // namespace asos::test::sky_kernel_test
