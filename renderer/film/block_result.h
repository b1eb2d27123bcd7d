#pragma once

#include "renderer/film/film.h"
#include "renderer/film/statistics.h"

namespace asos {

/// The final pixels of one block of a picture, and the statistics of their work.
struct BlockResult {
  FinishedTile tile;
  RenderStatistics statistics;
};

}  // namespace asos
