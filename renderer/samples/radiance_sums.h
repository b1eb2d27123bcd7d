#pragma once

#include "renderer/film/layer_sums.h"

#include <glm/glm.hpp>

#include <cstddef>
#include <vector>

namespace asos {

/// The sum of a sample, and the part of its radiance to which a contribution belongs.
struct SumTarget {
  std::size_t index = 0;
  LightPart part = LightPart::direct;
};

/// The part of samples' radiance that is summed up: all of it, only what the first surfaces reflect
/// of lights directly or by lobes, or none (`layers`: samples only cast eye rays). Lobes reflect
/// the scene, and the sky if it may be occluded.
enum class SummedRadiance { all, direct, lobes, layers };

/// The sums of samples' radiance, and those of its parts where they are asked for. Refers to them.
class RadianceSums {
 public:
  /// `light`: null or without sums: parts are not asked for. Both have to outlive this.
  // NOLINTNEXTLINE(google-explicit-constructor): plain sums are sums without parts.
  RadianceSums(std::vector<glm::dvec3>& all, const LayerTargets* light = nullptr)
      : all_(&all), light_(light && !light->light.empty() ? light : nullptr) {}

  void add(const SumTarget& target, glm::dvec3 radiance) {
    (*all_)[target.index] += radiance;
    if (light_) add_part(target, radiance);
  }
  /// Adds radiance that includes this emission and background.
  void add(const SumTarget& target, glm::dvec3 radiance, glm::dvec3 emission,
           glm::dvec3 background) {
    (*all_)[target.index] += radiance;
    if (!light_) return;
    if (target.part != LightPart::direct) return add_part(target, radiance);
    add_part({target.index, LightPart::emission}, emission);
    add_part({target.index, LightPart::background}, background);
    add_part(target, radiance - emission - background);
  }
  /// Counts a sample whose radiance is added.
  void count(std::size_t index) {
    if (!light_) return;
    if (LightSum* sum = light_->light[index / light_->targets_each]) sum->weight += 1.0;
  }

 private:
  void add_part(const SumTarget& target, glm::dvec3 radiance) {
    LightSum* sum = light_->light[target.index / light_->targets_each];
    if (sum) sum->add(target.part, radiance);
  }

  std::vector<glm::dvec3>* all_;
  const LayerTargets* light_;
};

}  // namespace asos
