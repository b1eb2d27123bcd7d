#pragma once

#include "renderer/film/image_io.h"
#include "renderer/result.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <memory>
#include <span>
#include <string>

namespace asos {

/// Writes a picture from top to bottom as its rows come, so that it need not fit into memory. The
/// file takes its place at `finish`; a writer that is dropped before leaves nothing. Errors name
/// the file and the reason. One thread.
class PictureWriter {
 public:
  virtual ~PictureWriter() = default;
  /// The next rows: linear radiance, row-major, whole rows. `coverage`, where the picture has an
  /// alpha channel: one a pixel, or none where all is covered. `unlit`: FinishedTile's, or none.
  [[nodiscard]] virtual Result<void> add_rows(std::span<const glm::vec3> radiance,
                                              std::span<const float> coverage = {},
                                              std::span<const glm::vec4> unlit = {}) = 0;
  /// After the last row.
  [[nodiscard]] virtual Result<void> finish() = 0;
};

struct PictureSizePx {
  int width = 0;
  int height = 0;
};

/// Whether a picture's file tells how much of its pixels is covered.
enum class Alpha { none, coverage };

[[nodiscard]] inline Alpha alpha_of(const Film& film) {
  return film.coverage.empty() ? Alpha::none : Alpha::coverage;
}

/// A PNG of what `display` shows, unlit surfaces as they are; with alpha, of the covered part of
/// each pixel (straight alpha).
[[nodiscard]] Result<std::unique_ptr<PictureWriter>> make_png_writer(
    const std::string& path, PictureSizePx size, const DisplayTransform& display,
    const ImageText& text, Alpha alpha = Alpha::none);
/// An EXR of 32-bit floats, the radiance of lit and unlit surfaces alike; with alpha, radiance is
/// that of the covered part times its share of the pixel (premultiplied, as EXR has it).
[[nodiscard]] Result<std::unique_ptr<PictureWriter>> make_exr_writer(const std::string& path,
                                                                     PictureSizePx size,
                                                                     const ImageText& attributes,
                                                                     Alpha alpha = Alpha::none);

}  // namespace asos
