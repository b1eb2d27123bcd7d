#pragma once

#include "renderer/shading/lobe.h"

namespace asos::test {

/// Returns a GGX lobe that reflects this fraction of light at normal incidence, and all at grazing
/// incidence.
[[nodiscard]] inline Lobe white_lobe(double roughness, float f0 = 1.0f) {
  Lobe lobe;
  lobe.f0 = glm::vec3(f0);
  lobe.roughness = static_cast<float>(roughness);
  return lobe;
}

}  // namespace asos::test
