#pragma once

#include "renderer/pyray/caster.h"

#include <glm/glm.hpp>

#include <cstdint>

namespace asos {

/// What a leaf of a root gets of something that is found out for a whole block at once.
struct LeafShare {
  std::uint32_t root = 0;
  SampleId sample = no_sample;  ///< the leaf's; none: dropped
  double weight = 1.0;          ///< the leaf's
  glm::dvec3 radiance{0.0};     ///< times its weight
  std::uint64_t rays = 0;
};

}  // namespace asos
