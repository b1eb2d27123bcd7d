#include "renderer/samples/block_job.h"
#include "renderer/samples/sample_block.h"

namespace asos {

/// n x n samples a pixel on a regular grid; n * n is the first square of at least
/// `job.settings.sampling.spp`. Each looks at one point of each light, on a grid of its own in an
/// order of the pixel's own.
BlockResult render_block_uniform(const BlockJob& job) {
  const int n = grid_side(job.settings.sampling.spp);
  GridPlaces places(n, false);
  return sample_block(job, places, n * n);
}

}  // namespace asos
