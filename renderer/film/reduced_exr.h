#pragma once

#include "renderer/film/image_io.h"
#include "renderer/film/size_check.h"

#include <cstdint>
#include <functional>
#include <string>

namespace asos {

/// Returns the largest number of pixels for a picture whose file has this many bytes.
using MostPixels = std::function<std::int64_t(std::uint64_t file_bytes)>;

/// Reads an EXR. If it has more pixels than `most` allows, it is halved while it is read until it
/// fits; each pixel is then the mean of a square of pixels. Calls `check` before it allocates the
/// picture. Errors: those of read_exr.
[[nodiscard]] Result<ExrImage> read_reduced_exr(const std::string& path, const SizeCheck& check,
                                                const MostPixels& most);

/// The reduction of a file: each pixel of the result is a square of `shrink` x `shrink` pixels.
struct ExrReduction {
  std::int64_t width = 0;  ///< of the file, pixels
  std::int64_t height = 0;
  int shrink = 1;

  /// Returns the length of a side after the reduction.
  [[nodiscard]] std::int64_t smaller(std::int64_t side) const {
    return (side + shrink - 1) / shrink;
  }
};
/// Returns the reduction that read_reduced_exr would apply to a file, from its header. Errors:
/// those of read_exr.
[[nodiscard]] Result<ExrReduction> exr_reduction(const std::string& path, const MostPixels& most);

}  // namespace asos
