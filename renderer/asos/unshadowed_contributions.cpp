#include "renderer/asos/unshadowed_contributions.h"

#include "renderer/geometry/largest.h"

#include <algorithm>
#include <limits>
#include <map>

namespace asos {
namespace {

constexpr std::size_t no_part = std::numeric_limits<std::size_t>::max();

// Returns the largest contribution of a light to a pixel: its radiance if known, at most white.
double brightest(const PreparedLight& light) {
  return light.traits().has_area() ? std::min(1.0, static_cast<double>(largest(light.power))) : 1.0;
}

}  // namespace

UnshadowedContributions::UnshadowedContributions(std::span<const PreparedLight> lights)
    : point_(ThreadLocalCache<ShadingPoints>::make()) {
  std::map<std::int32_t, std::size_t> numbers;
  for (std::uint32_t i = 0; i < lights.size(); ++i) {
    const PreparedLight& light = lights[i];
    table_.add(LightConstants(light), i);
    brightest_.push_back(brightest(light));
    part_of_light_.push_back(
        light.own_part < 0 ? no_part
                           : numbers.try_emplace(light.own_part, numbers.size()).first->second);
  }
  parts_ = numbers.size();
  worth_.resize(table_.padded_size());
  start();
}

void UnshadowedContributions::start() {
  most_.assign(worth_.size(), 0.0f);
}

void UnshadowedContributions::add(const LightingQuery& point) {
  point_->count = 0;
  point_->add(point, glm::vec3(1.0f));
  (void)weigh_lights(table_, *point_, 0, worth_);
  for (std::size_t i = 0; i < worth_.size(); ++i) most_[i] = std::max(most_[i], worth_[i]);
}

std::vector<double> UnshadowedContributions::most() const {
  std::vector<double> most(brightest_.size());
  for (std::size_t i = 0; i < most.size(); ++i)
    most[i] = std::min(brightest_[i], static_cast<double>(most_[i]));
  // Lights of one part of a mesh hide each other.
  constexpr double sides = 2.0;
  struct OnePart {
    double all = 0.0, most = 0.0;
  };
  std::vector<OnePart> parts(parts_);
  for (std::size_t i = 0; i < most.size(); ++i) {
    if (part_of_light_[i] == no_part) continue;
    OnePart& part = parts[part_of_light_[i]];
    part.all += most[i];
    part.most = std::max(part.most, sides * brightest_[i]);
  }
  for (std::size_t i = 0; i < most.size(); ++i) {
    if (part_of_light_[i] == no_part) continue;
    const OnePart& part = parts[part_of_light_[i]];
    if (part.all > part.most) most[i] *= part.most / part.all;
  }
  return most;
}

}  // namespace asos
