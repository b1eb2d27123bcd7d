#include "renderer/asos/unshadowed_contributions.h"

#include "renderer/geometry/largest.h"

#include <algorithm>
#include <map>

namespace asos {
namespace {

// Returns the largest contribution of a light to a pixel: its radiance if known, at most white.
double brightest(const PreparedLight& light) {
  return light.traits().has_area() ? std::min(1.0, static_cast<double>(largest(light.power))) : 1.0;
}

}  // namespace

UnshadowedContributions::UnshadowedContributions(std::span<const PreparedLight> lights)
    : lights_(lights), point_(ThreadLocalCache<ShadingPoints>::make()) {
  for (const PreparedLight& light : lights) bounds_.emplace_back(LightConstants(light));
  weights_.resize((lights.size() + 15) / 16 * 16);
  most_.assign(lights.size(), 0.0f);
}

HandledLights UnshadowedContributions::gather(const LightingQuery& point) {
  point_->count = 0;
  point_->add(point, glm::vec3(1.0f));
  weigh_lights(bounds_, *point_, 0, weights_);
  for (std::size_t i = 0; i < most_.size(); ++i) most_[i] = std::max(most_[i], weights_[i]);
  return {{}, true};
}

std::vector<double> UnshadowedContributions::most() const {
  // Lights of one part of a mesh hide each other.
  constexpr double sides = 2.0;
  struct OnePart {
    double all = 0.0, most = 0.0;
  };
  std::vector<double> most;
  std::map<std::int32_t, OnePart> parts;
  for (std::size_t i = 0; i < lights_.size(); ++i) {
    const double one = brightest(lights_[i]);
    OnePart& part = parts[lights_[i].own_part];
    part.all += most.emplace_back(std::min(one, static_cast<double>(most_[i])));
    part.most = std::max(part.most, sides * one);
  }
  for (std::size_t i = 0; i < most.size(); ++i) {
    const OnePart& part = parts[lights_[i].own_part];
    if (lights_[i].own_part >= 0 && part.all > part.most) most[i] *= part.most / part.all;
  }
  return most;
}

}  // namespace asos
