#pragma once

#include "renderer/asos/open_regions.h"
#include "renderer/asos/root_sums.h"
#include "renderer/film/block_result.h"
#include "renderer/film/layer_sums.h"
#include "renderer/pyray/tracer.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace asos {

/// The pixels of a fat pyray after its first stage, which found boundaries, split pixels and shaded
/// their leaves: all but what some of their parts still need of samples. Enough to go on from.
struct StartedPyray {
  struct Pixel {
    Trace trace;
    RootSum sum;
  };

  PixelRect block;                           ///< of the picture
  PixelRect framed;                          ///< of its frame
  std::vector<Pixel> pixels;                 ///< row by row
  std::vector<LayerSum> layers;              ///< of each pixel; empty: none is asked for
  LayerSet asked;                            ///< by the settings
  double tolerance = 0.0;                    ///< allowed error of a leaf
  std::vector<std::uint32_t> pixel_of_root;  ///< place in `pixels` of each root of the fat pyray
  OpenRegions open;
  RenderStatistics statistics;

  /// The current estimate of the pixels. Open regions use their samples so far.
  [[nodiscard]] BlockResult result(int max_level) const;
  /// Squared errors of display intensity that open regions are likely to have, summed over pixels,
  /// and the samples that they have.
  struct Expected {
    double squared_error = 0.0;
    double samples = 0.0;
  };
  [[nodiscard]] Expected expected() const;
  [[nodiscard]] std::size_t bytes() const;
};

}  // namespace asos
