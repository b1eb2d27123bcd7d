#pragma once

#include "renderer/session/render_session.h"
#include "tests/bench/halved_reference.h"

namespace asos::bench {

/// The assumed cost of exact work for single pixels of a block, in percent.
struct SinglePixelCost {
  int search = 4;    ///< of a block's time, for each visit
  int dearer = 120;  ///< time of a pixel relative to its part of the block
};

/// Measures a picture by Sobol sampling with 1 to 256 samples and by the snapshot's method, and
/// prints a line for each schedule that is replayed from these. Columns: the error over that of
/// Sobol sampling at the time of its 16 and 64 samples, and the total time over a direct render.
void print_replays(Snapshot snapshot, const HalvedReference& reference,
                   const SinglePixelCost& cost);

}  // namespace asos::bench
