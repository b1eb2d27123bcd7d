#include "renderer/kernels/sobol_kernel.h"

#include "tests/support/every_target.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace asos::test::sobol_kernel_test {
namespace {

constexpr double scale = 1.0 / 4294967296.0;

TEST(SobolKernel, PlacesOnLightsAreTheOnesOfThePixelsOneByOne) {
  for_every_target([] {
    SobolBatch batch;
    std::vector<std::pair<SobolPixel, std::uint32_t>> samples;
    // Runs of all lengths, and indices beyond the precomputed table.
    for (int run = 1; samples.size() + static_cast<std::size_t>(run) <= ShadingPoints::size;
         ++run) {
      const SobolPixel pixel(run, 3 * run, 7);
      for (int i = 0; i < run; ++i) {
        const std::uint32_t index = static_cast<std::uint32_t>(i) * (run % 3 == 0 ? 977u : 1u);
        if (i == 0) {
          batch.add(pixel, index);
        } else {
          batch.add(index);
        }
        samples.emplace_back(pixel, index);
      }
    }
    ASSERT_GT(samples.size(), 200u);
    for (const std::uint32_t light : {0u, 1u, 1000u}) {
      LightPointBatch places;
      batch.on_light(light, places);
      for (std::size_t i = 0; i < samples.size(); ++i) {
        const glm::dvec2 expected = samples[i].first.light(samples[i].second, light);
        ASSERT_EQ(scale * places.u[i], expected.x) << "sample " << i << ", light " << light;
        ASSERT_EQ(scale * places.v[i], expected.y) << "sample " << i << ", light " << light;
      }
      for (const std::uint32_t step : {1u, 3u, 40u}) {
        std::vector<std::uint32_t> some;
        for (std::uint32_t i = step - 1; i < samples.size(); i += step) some.push_back(i);
        LightPointBatch of_some;
        batch.on_light(light, some, of_some);
        for (std::size_t k = 0; k < some.size(); ++k) {
          ASSERT_EQ(of_some.u[k], places.u[some[k]]) << "every " << step << ", sample " << some[k];
          ASSERT_EQ(of_some.v[k], places.v[some[k]]) << "every " << step << ", sample " << some[k];
        }
      }
    }
  });
}

TEST(SobolKernel, PlacesInThePixelAreTheOnesOfThePixelOneByOne) {
  for_every_target([] {
    SobolPixelSampler places;
    for (int x = 0; x < 3; ++x) {
      const SobolPixel pixel(x, 5, 1);
      places.forget();
      for (const std::uint32_t index : {0u, 1u, 15u, 16u, 3u, 255u, 256u, 70'000u, 2u})
        ASSERT_EQ(places.at(pixel, index), pixel.pixel(index)) << "pixel " << x << ", " << index;
    }
  });
}

}  // namespace
}  // namespace asos::test::sobol_kernel_test
