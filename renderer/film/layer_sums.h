#pragma once

#include "renderer/film/layers.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <limits>
#include <span>
#include <utility>
#include <vector>

namespace asos {

/// The values of all surface layers at one sample. A default one shows the background.
struct LayerSample {
  float alpha = 0.0f;
  glm::vec3 albedo{0.0f};
  glm::vec3 emission{0.0f};
  glm::vec3 normal{0.0f};
  glm::vec3 geometric_normal{0.0f};
  glm::vec3 position{0.0f};
  glm::vec2 uv{0.0f};
  float depth = std::numeric_limits<float>::infinity();
  float distance = std::numeric_limits<float>::infinity();
  std::uint32_t object = no_id;
  std::uint32_t material = no_id;
};

/// The surface layers of one pixel, or of a part of one, as sums over its leaves or samples.
struct LayerSum {
  double weight = 0.0;  ///< of all samples together
  double alpha = 0.0;   ///< this and the next four: weighted sums
  glm::dvec3 albedo{0.0};
  glm::dvec3 emission{0.0};
  glm::dvec3 normal{0.0};
  glm::dvec3 geometric_normal{0.0};
  LayerSample nearest;  ///< the sample nearest to the eye
  std::vector<std::pair<std::uint32_t, double>>
      objects;  ///< weight of each id, in order of arrival
  std::vector<std::pair<std::uint32_t, double>> materials;

  void add(const LayerSample& sample, double sample_weight);
  /// Adds a part that was sampled by itself, so that it has this weight.
  void add(const LayerSum& part, double part_weight);
};

/// The planes of `layers` that follow from surfaces; `error`, if it is one of them, stays 0.
[[nodiscard]] std::vector<LayerPlane> planes_of(std::span<const LayerSum> pixels, LayerSet layers);

}  // namespace asos
