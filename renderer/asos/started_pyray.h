#pragma once

#include "renderer/asos/root_sums.h"
#include "renderer/film/block_result.h"
#include "renderer/film/layer_sums.h"
#include "renderer/pyray/tracer.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace asos {

/// The pixels of a fat pyray after its first stage, which finds boundaries, splits pixels and
/// shades their leaves. It holds enough to continue with the samples that some parts still need.
struct StartedPyray {
  struct Pixel {
    Trace trace;
    RootSum sum;
  };

  PixelRect block;                           ///< of the picture
  PixelRect framed;                          ///< the block's frame
  std::vector<Pixel> pixels;                 ///< row by row
  std::vector<LayerSum> layers;              ///< of each pixel; empty: no layer is asked for
  LayerSet asked;                            ///< layers that the settings request
  double tolerance = 0.0;                    ///< allowed error of a leaf
  std::vector<std::uint32_t> pixel_of_root;  ///< place in `pixels` of each root of the fat pyray
  OpenRegions open;
  RenderStatistics statistics;

  /// Returns the current estimate of the pixels, from the open regions' samples so far.
  [[nodiscard]] BlockResult result(int max_level) const;
  /// Returns the expected squared errors of the open regions in display intensity, summed over
  /// pixels.
  [[nodiscard]] double squared_error() const;
  [[nodiscard]] std::size_t bytes() const;
};

}  // namespace asos
