#pragma once

#include <cstdint>

namespace asos {

/// The work that this process has done to prepare scenes, for tests and benchmarks.
struct BuildCounts {
  std::uint64_t geometries = 0;         ///< worlds with a ray hierarchy
  std::uint64_t boundary_searches = 0;  ///< begun
};

[[nodiscard]] BuildCounts build_counts();

}  // namespace asos
