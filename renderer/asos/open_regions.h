#pragma once

#include "renderer/pyray/caster.h"
#include "renderer/samples/region_sampler.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace asos {

/// Parts of pixels with an error above the allowance after a block's first stage.
struct OpenRegions {
  struct Part {
    std::uint32_t root = 0;
    SampleId sample = no_sample;  ///< sample that represents it
    double weight = 1.0;          ///< fraction of the root's area
    bool layers = false;          ///< it is sampled because of texture cut-outs
    bool planes = false;          ///< its surface layers are those of its samples
    RegionSampler::Estimate so_far;
  };
  std::vector<Part> parts;
  RegionSampler::Open samples;  ///< in the order of `parts`

  [[nodiscard]] std::size_t bytes() const { return parts.size() * sizeof(Part) + samples.bytes(); }
};

}  // namespace asos
