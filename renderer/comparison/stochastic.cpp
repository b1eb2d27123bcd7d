#include "renderer/samples/block_job.h"
#include "renderer/samples/sample_block.h"

namespace asos {

/// One sample at a random place in each of the n x n strata, of the pixel and of each light, seeded
/// by pixel and sample.
BlockResult render_block_stochastic(const BlockJob& job) {
  const int n = grid_side(job.settings.sampling.spp);
  GridPlaces places(n, true);
  return sample_block(job, places, n * n);
}

}  // namespace asos
