#pragma once

#include "renderer/film/image_io.h"
#include "renderer/result.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <memory>
#include <span>
#include <string>

namespace asos {

/// Writes a picture row by row from top to bottom, so that it need not fit into memory. `finish`
/// puts the file in its place; a writer that is dropped before leaves no file. Errors name the file
/// and the reason. One thread.
class PictureWriter {
 public:
  virtual ~PictureWriter() = default;
  /// Adds the next rows: linear radiance, row-major, whole rows. `coverage`, if the picture has an
  /// alpha channel: one value per pixel, or empty if all is covered. `unlit`: as in FinishedTile,
  /// or empty.
  [[nodiscard]] virtual Result<void> add_rows(std::span<const glm::vec3> radiance,
                                              std::span<const float> coverage = {},
                                              std::span<const glm::vec4> unlit = {}) = 0;
  /// Call after the last row.
  [[nodiscard]] virtual Result<void> finish() = 0;
};

struct PictureSizePx {
  int width = 0;
  int height = 0;
};

/// The alpha channel of a picture's file.
enum class Alpha { none, coverage };

[[nodiscard]] inline Alpha alpha_of(const Film& film) {
  return film.coverage.empty() ? Alpha::none : Alpha::coverage;
}

/// Makes a writer of a PNG displayed by `display`, with unlit surfaces unchanged. With alpha,
/// colours are those of the covered part of each pixel (straight alpha).
[[nodiscard]] Result<std::unique_ptr<PictureWriter>> make_png_writer(
    const std::string& path, PictureSizePx size, const DisplayTransform& display,
    const ImageText& text, Alpha alpha = Alpha::none);
/// Makes a writer of an EXR of 32-bit floats: the radiance of lit and unlit surfaces alike. With
/// alpha, radiance is that of the covered part times its coverage (premultiplied, as usual for
/// EXR).
[[nodiscard]] Result<std::unique_ptr<PictureWriter>> make_exr_writer(const std::string& path,
                                                                     PictureSizePx size,
                                                                     const ImageText& attributes,
                                                                     Alpha alpha = Alpha::none);

}  // namespace asos
