#include "renderer/asos/unoccluded_sky.h"

#include "renderer/sampling/sequential_mean.h"
#include "renderer/shading/sky_light.h"

#include <cmath>
#include <cstdint>
#include <optional>

namespace asos {
namespace {

// With too few samples, sampling ends early where they miss a bright spot: with 16, the mean of a
// picture is 2.5e-4 too dark. An allowed error above `coarse` needs only `few` samples.
constexpr std::uint32_t few = 16, enough = 128, most = 1024;
constexpr double coarse = 1.0 / 64.0;
// The number of a light in the sequence that is hardly ever used.
constexpr std::uint32_t other_places = 0x100;

}  // namespace

glm::vec3 unoccluded_sky_within(const SkyQuery& point, const SobolPixel& leaf, double error) {
  if (const auto known = unoccluded_sky(point)) return *known;
  const SkySampler sampler(point);
  // Matte reflection has a closed form under more skies. Samples determine the rest.
  const std::optional<glm::vec3> matte = open_sky_of_matte(point);
  const SamplingGoal goal{error, error > coarse ? few : enough, most, false};
  SequentialMean mean;
  std::uint32_t taken = 0;
  for (std::uint32_t end = goal.least;; end = goal.after_next_round(end)) {
    for (; taken < end; ++taken) {
      const auto sample = sampler.at(leaf.light(taken, other_places));
      glm::dvec3 carried(0.0);
      if (sample && std::isfinite(sample->carried.x + sample->carried.y + sample->carried.z))
        carried = glm::dvec3(sample->carried) - (matte ? glm::dvec3(sample->matte) : carried);
      mean.add(carried);
    }
    if (goal.met(end, mean.standard_error()))
      return glm::max(glm::vec3(mean.mean()) + matte.value_or(glm::vec3(0.0f)), 0.0f);
  }
}

}  // namespace asos
