#include "renderer/sampling/sample_streams.h"

#include "renderer/samples/sobol_sampler.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <memory>
#include <vector>

namespace asos::test::sample_streams_test {
namespace {

TEST(SampleStreams, DisjointFindsASharedNumber) {
  using Ranges = std::array<StreamRange, 2>;
  EXPECT_TRUE(disjoint(Ranges{{{3, 2}, {5, 1}}}));
  EXPECT_FALSE(disjoint(Ranges{{{3, 3}, {5, 1}}}));
  EXPECT_FALSE(disjoint(Ranges{{{5, 1}, {5, 1}}}));
  EXPECT_FALSE(disjoint(Ranges{{{5, 1}, {3, 1}}}));
}

/// Returns the first coordinate that each use of random numbers has in one sample.
std::vector<double> coordinates(PixelSampler& places, int index) {
  places.start_pixel(3, 5);
  places.start_sample(index);
  std::vector<double> all{places.in_pixel().x, places.in_pixel().y, places.on_lens().x,
                          places.in_time()};
  for (const std::uint32_t light : {0u, 1u, 2u, 100u}) all.push_back(places.on_light(light).x);
  all.push_back(places.on_light(number_of(SampleStream::highlights)).x);
  for (const SampleStream stream : {SampleStream::reflections, SampleStream::roulette}) {
    for (const int bounce : {0, 1, 64}) all.push_back(places.in_lobe(stream, bounce).x);
  }
  for (const SampleStream stream :
       {SampleStream::light_choice, SampleStream::sky, SampleStream::sky_of_bounce})
    all.push_back(places.in_lobe(stream, 0).x);
  return all;
}

// Uses that share a number have equal coordinates in every sample.
TEST(SampleStreams, GiveEveryUseNumbersOfItsOwn) {
  constexpr int samples = 16;
  const auto grid = std::make_unique<GridSampler>(4, true);
  const auto sobol = std::make_unique<SobolSampler>(1);
  for (PixelSampler* places :
       {static_cast<PixelSampler*>(grid.get()), static_cast<PixelSampler*>(sobol.get())}) {
    places->use_lens();
    places->use_time();
    for (int i = 0; i < samples; ++i) {
      std::vector<double> all = coordinates(*places, i);
      std::sort(all.begin(), all.end());
      EXPECT_EQ(std::adjacent_find(all.begin(), all.end()), all.end()) << "sample " << i;
    }
  }
}

}  // namespace
}  // namespace asos::test::sample_streams_test
