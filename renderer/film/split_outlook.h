#pragma once

#include <cstdint>

namespace asos {

/// What a rendered pixel of ASOS tells of how deep it would be split by another EPS and MAX
/// (predicted_level).
struct SplitOutlook {
  float error = 0.0f;         ///< of its centre, in display intensity, by the terms of its leaves
  float unresolved = 0.0f;    ///< share of its area whose cells stayed marginal
  std::uint32_t samples = 0;  ///< of parts that were sampled for what varies in them
  std::uint8_t edges = 0;     ///< deepest level of cells that boundaries crossed
  bool at_limit = false;      ///< these would go deeper if MAX let them

  bool operator==(const SplitOutlook&) const = default;
};

}  // namespace asos
