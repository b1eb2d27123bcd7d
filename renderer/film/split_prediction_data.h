#pragma once

#include <cstdint>

namespace asos {

/// Data of an ASOS pixel from which predicted_level estimates its split level for another EPS and
/// MAX.
struct SplitPredictionData {
  /// Estimated error of its centre, in display intensity, from its leaves.
  float error = 0.0f;
  float unresolved = 0.0f;    ///< fraction of its area in cells that stayed marginal
  std::uint32_t samples = 0;  ///< of parts sampled for shading, shadows, saturation or cut-outs
  std::uint8_t edges = 0;     ///< deepest level of cells crossed by boundaries
  bool at_limit = false;      ///< MAX ended the subdivision; a larger one would split further

  bool operator==(const SplitPredictionData&) const = default;
};

}  // namespace asos
