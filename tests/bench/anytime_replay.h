#pragma once

#include "renderer/session/render_session.h"
#include "tests/bench/halved_reference.h"

namespace asos::bench {

/// The assumed costs of work for single pixels, in percent.
struct SinglePixelCost {
  int samples = 130;  ///< time of a single pixel's sample, relative to one of a whole picture
  int search = 2;     ///< of a block's time, for each visit
  int dearer = 110;   ///< time of an exact pixel relative to its part of the block
};

/// Measures a picture by Sobol sampling with 1 to 256 samples and by the snapshot's method, and
/// prints a line for each schedule that is replayed from these. Columns: the error over that of
/// Sobol sampling at the time of its 16 and 64 samples, and the total time over a direct render.
void print_replays(Snapshot snapshot, const HalvedReference& reference,
                   const SinglePixelCost& cost);

}  // namespace asos::bench
