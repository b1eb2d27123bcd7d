#pragma once

#include "renderer/features/feature_set.h"
#include "renderer/pyray/estimate.h"
#include "renderer/shadows/leaf.h"

#include <glm/glm.hpp>

#include <span>

namespace asos {

/// The light that a leaf reflects, estimated by samples.
struct SampledLeaf {
  const Leaf* leaf = nullptr;
  glm::vec3 reflectance{0.0f};
  bool shares = true;      ///< may share samples with other leaves
  Estimate found{};        ///< value, error and cost of its own samples
  bool converged = false;  ///< its own samples suffice
  bool fitted = false;
  glm::dvec3 correction{0.0};  ///< the fit minus the value; 0: not fitted
};

/// Fits quadratic polynomials through leaves that are on one smooth surface and not all converged,
/// so that they share their samples. A fit is accepted if the leaves' deviations from it are within
/// their noise; otherwise the surface is divided into quarters. A leaf that contradicts an accepted
/// fit keeps its own value.
void fit_surfaces(const FeatureSet& features, std::span<SampledLeaf> leaves);

}  // namespace asos
