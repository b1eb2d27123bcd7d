#pragma once

#include "renderer/film/image_io.h"
#include "renderer/film/size_check.h"

#include <cstdint>
#include <functional>
#include <string>

namespace asos {

/// How many pixels a picture may have whose file has so many bytes.
using MostPixels = std::function<std::int64_t(std::uint64_t file_bytes)>;

/// An EXR that is made smaller while it is read where it has more pixels than `most` allows: by
/// halves, each pixel the mean of those that it stands for. `check` is asked before anything of the
/// picture's size is made. Errors: those of read_exr.
[[nodiscard]] Result<ExrImage> read_reduced_exr(const std::string& path, const SizeCheck& check,
                                                const MostPixels& most);

/// The number of the file's pixels that become one, along either side.
struct ExrReduction {
  std::int64_t width = 0;  ///< of the file, pixels
  std::int64_t height = 0;
  int shrink = 1;

  /// A side of a picture of which `shrink` pixels become one.
  [[nodiscard]] std::int64_t smaller(std::int64_t side) const {
    return (side + shrink - 1) / shrink;
  }
};
/// What read_reduced_exr does with a file, told from its head. Errors: those of read_exr.
[[nodiscard]] Result<ExrReduction> exr_reduction(const std::string& path, const MostPixels& most);

}  // namespace asos
