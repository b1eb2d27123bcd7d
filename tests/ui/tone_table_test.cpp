#include "ui/tone_table.h"

#include "renderer/film/film.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>
#include <random>

namespace asos {
using namespace ui;
namespace {

TEST(ToneTable, AgreesWithDisplayBytesForAllFloats) {
  std::mt19937 random(11);
  for (const float exposure : {0.0f, -10.0f, 10.0f, 0.37f, -2.5f}) {
    const ToneTable table(exposure);
    for (int i = 0; i < 200000; ++i) {
      const float radiance = std::bit_cast<float>(static_cast<std::uint32_t>(random()));
      const glm::vec3 grey(radiance);
      ASSERT_EQ(table.bytes(grey), display_bytes(grey, exposure))
          << "radiance " << radiance << ", exposure " << exposure;
    }
  }
}

TEST(ToneTable, AgreesWithDisplayBytesInTheVisibleRange) {
  std::mt19937 random(12);
  std::uniform_real_distribution<float> stops(-16.0f, 3.0f);
  for (const float exposure : {0.0f, 1.0f, -1.5f}) {
    const ToneTable table(exposure);
    for (int i = 0; i < 200000; ++i) {
      const glm::vec3 c(std::exp2(stops(random)), std::exp2(stops(random)),
                        std::exp2(stops(random)));
      ASSERT_EQ(table.bytes(c), display_bytes(c, exposure))
          << c.x << ' ' << c.y << ' ' << c.z << ", exposure " << exposure;
    }
  }
}

TEST(ToneTable, AgreesAtEveryStepBetweenBytes) {
  const ToneTable table(0.0f);
  // Walks over every change of the byte and its neighbouring floats.
  for (int b = 0; b < 255; ++b) {
    std::uint32_t lo = 0, hi = std::bit_cast<std::uint32_t>(2.0f);
    while (hi - lo > 1) {
      const std::uint32_t middle = lo + (hi - lo) / 2;
      (display_bytes(glm::vec3(std::bit_cast<float>(middle)), 0.0f).x > b ? hi : lo) = middle;
    }
    EXPECT_EQ(table.bytes(glm::vec3(std::bit_cast<float>(lo))).x, b);
    EXPECT_EQ(table.bytes(glm::vec3(std::bit_cast<float>(hi))).x, b + 1);
  }
}

}  // namespace
}  // namespace asos
