#include "renderer/stability/light_meter.h"

#include <gtest/gtest.h>

#include <numbers>

namespace asos::stability {
namespace {

constexpr double lux_of_unit_disk = std::numbers::pi / 2.0;  // 1 cd/m², at distance 1

Finding measured(float nits, double expected) {
  Light disk;
  disk.type = Light::Type::disk;
  disk.position = {0, 1, 0};
  disk.direction = {0, -1, 0};
  disk.radius = 1.0;
  disk.intensity = nits;
  Finding finding;
  const LightMeter meter{{disk}, {}};
  const auto outcome = meter.measure({"lux", 0.0, "the closed form is exact"}, expected);
  if (outcome) finding.outcome = *outcome;
  if (!outcome) finding.fault = outcome.error().reason;
  return finding;
}

// For any light strength the meter distinguishes one that is a thousandth brighter.
TEST(LightMeter, TellsLightsApartWhateverTheirStrength) {
  for (const float nits : {1e-20f, 1e-6f, 1.0f, 1e6f, 1e20f}) {
    const double lux = static_cast<double>(nits) * lux_of_unit_disk;
    EXPECT_TRUE(holds(measured(nits, lux))) << nits;
    EXPECT_FALSE(holds(measured(1.001f * nits, lux))) << nits;
  }
  EXPECT_FALSE(holds(measured(1e-20f, 0.0))) << "no light gives 0";
}

}  // namespace
}  // namespace asos::stability
