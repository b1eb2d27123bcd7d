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
  /// The next rows: linear radiance, row-major, whole rows.
  [[nodiscard]] virtual Result<void> add_rows(std::span<const glm::vec3> radiance) = 0;
  /// After the last row.
  [[nodiscard]] virtual Result<void> finish() = 0;
};

struct PictureSizePx {
  int width = 0;
  int height = 0;
};

/// A PNG of what `display` shows.
[[nodiscard]] Result<std::unique_ptr<PictureWriter>> make_png_writer(
    const std::string& path, PictureSizePx size, const DisplayTransform& display,
    const ImageText& text);
/// An EXR of 32-bit floats.
[[nodiscard]] Result<std::unique_ptr<PictureWriter>> make_exr_writer(const std::string& path,
                                                                     PictureSizePx size,
                                                                     const ImageText& attributes);

}  // namespace asos
