#include "renderer/samples/block_job.h"
#include "renderer/samples/sobol_places.h"

namespace asos {

/// `settings.sampling.spp` points of an Owen-scrambled Sobol sequence over the pixel and each
/// light.
BlockResult render_block_sobol(const BlockJob& job) {
  SobolPlaces places(job.settings.seed);
  return sample_block(job, places, job.settings.sampling.spp);
}

}  // namespace asos
