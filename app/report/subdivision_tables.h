#pragma once

#include "renderer/result.h"

#include <cstdint>
#include <vector>

namespace asos {

/// A row of GI'93 tables 1 and 2: level K, its marginal pyrays, and L / 2^2K or L / 2^(2K+1).
struct SubdivisionRow {
  int level = 0;
  std::uint32_t marginal = 0;
  std::uint32_t in = 0;
  std::uint32_t out = 0;
  double change = 0.0;
};

struct SubdivisionTable {
  const char* title;
  std::vector<SubdivisionRow> published;
  std::vector<SubdivisionRow> measured;  ///< by this program, with a polygon of its own
};

/// GI'93 tables 1 and 2 with EPS 1/16, by the published ASOS. Uses other polygons than the papers,
/// whose drawings have no coordinates.
[[nodiscard]] Result<std::vector<SubdivisionTable>> subdivision_tables();

}  // namespace asos
