#include "renderer/asos/open_sky.h"

#include "renderer/geometry/largest.h"
#include "renderer/shading/sky_light.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <optional>

namespace asos {
namespace {

// Fewer samples than enough end too early where they miss what is bright: with 16 the mean of a
// picture is 2.5e-4 too dark. What may be off by more than that is coarse.
constexpr std::uint32_t few = 16, enough = 128, most = 1024;
constexpr double coarse = 1.0 / 64.0;
constexpr std::uint32_t other_places = 0x100;  // a number that no light has, or few

constexpr std::uint32_t per_sum = few / 4;
using Sums = std::array<glm::dvec3, most / per_sum>;

/// The mean of so many samples, and its error by the scatter of four quarters of them.
struct Mean {
  glm::dvec3 value{0.0};
  double error = 0.0;

  Mean(const Sums& sums, std::uint32_t samples) {
    const std::uint32_t quarter = samples / per_sum / 4;
    std::array<glm::dvec3, 4> quarters{};
    for (std::uint32_t k = 0; k < 4 * quarter; ++k) quarters[k / quarter] += sums[k];
    for (glm::dvec3& part : quarters) {
      part *= 4.0 / samples;
      value += 0.25 * part;
    }
    for (const glm::dvec3& part : quarters) {
      const double off = largest(glm::abs(part - value));
      error += off * off;
    }
    error = std::sqrt(error / 12.0);
  }
};

}  // namespace

glm::vec3 open_sky_within(const SkyLitPoint& point, const SobolPixel& leaf, double error) {
  if (const auto known = open_sky(point)) return *known;
  const SkySampler sampler(point);
  // What is matte has a closed form under more skies, and samples tell the rest.
  const std::optional<glm::vec3> matte = open_sky_of_matte(point);
  Sums sums{};
  std::uint32_t taken = 0;
  for (std::uint32_t end = error > coarse ? few : enough;; end *= 2) {
    for (; taken < end; ++taken) {
      const auto sample = sampler.at(leaf.light(taken, other_places));
      if (!sample || !std::isfinite(sample->carried.x + sample->carried.y + sample->carried.z))
        continue;
      sums[taken / per_sum] += sample->carried;
      if (matte) sums[taken / per_sum] -= sample->matte;
    }
    const Mean mean(sums, end);
    if (end >= most || mean.error <= error)
      return glm::max(glm::vec3(mean.value) + matte.value_or(glm::vec3(0.0f)), 0.0f);
  }
}

}  // namespace asos
