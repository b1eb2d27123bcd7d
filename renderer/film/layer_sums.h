#pragma once

#include "renderer/film/layers.h"
#include "renderer/film/light_parts.h"

#include <glm/glm.hpp>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <utility>
#include <vector>

namespace asos {

/// The part of a sample that an object with one material covers.
struct ObjectCover {
  std::uint32_t object = no_id;
  std::uint32_t material = no_id;
  float share = 1.0f;
};

/// The values of all surface layers at one sample. A default one shows the background.
struct LayerSample {
  float alpha = 0.0f;
  glm::vec3 albedo{0.0f};
  glm::vec3 normal{0.0f};
  glm::vec3 geometric_normal{0.0f};
  glm::vec3 position{0.0f};
  glm::vec2 uv{0.0f};
  float depth = std::numeric_limits<float>::infinity();
  float distance = std::numeric_limits<float>::infinity();
  std::uint32_t object = no_id;
  std::uint32_t material = no_id;
  /// The surfaces along the ray, where the first one is transparent; the background covers the
  /// rest. Empty: the first one covers all.
  std::vector<ObjectCover> covers;
};

/// Weights of ids, in order of arrival.
using IdWeights = std::vector<std::pair<std::uint32_t, double>>;
void add_id(IdWeights& ids, std::uint32_t id, double weight);
/// Returns their fractions of `weight`, largest first.
[[nodiscard]] IdShares shares_of(const IdWeights& ids, double weight);

/// The surface layers of one pixel, or of a part of one, as sums over its leaves or samples.
struct LayerSum {
  double weight = 0.0;  ///< of all samples together
  double alpha = 0.0;   ///< this and the next three: weighted sums
  glm::dvec3 albedo{0.0};
  glm::dvec3 normal{0.0};
  glm::dvec3 geometric_normal{0.0};
  LightSum light;       ///< of the samples whose radiance counts
  LayerSample nearest;  ///< the sample nearest to the eye
  IdWeights objects;
  IdWeights materials;

  void add(const LayerSample& sample, double sample_weight);
  /// Adds a part that was sampled separately, scaled to this weight.
  void add(const LayerSum& part, double part_weight);

 private:
  void add_ids(const LayerSample& sample, double sample_weight);
};

/// The sums to which samples add their layers: those of target i are number i / `targets_each`.
/// Null: none.
struct LayerTargets {
  std::vector<LayerSum*> surfaces;
  std::vector<LightSum*> light;
  std::size_t targets_each = 1;

  void add(LayerSum& sum) {
    surfaces.push_back(&sum);
    light.push_back(&sum.light);
  }
};

/// Returns the planes of `layers`. Planes of surfaces are filled; `error` stays 0.
[[nodiscard]] std::vector<LayerPlane> planes_of(std::span<const LayerSum> pixels, LayerSet layers);

}  // namespace asos
