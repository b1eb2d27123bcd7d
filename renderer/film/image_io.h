#pragma once

#include "renderer/film/exr_options.h"
#include "renderer/film/film.h"
#include "renderer/film/size_check.h"
#include "renderer/film/split_map.h"
#include "renderer/film/tone.h"
#include "renderer/result.h"

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace asos {

/// Keys and values stored in a picture's file, in order.
using ImageText = std::vector<std::pair<std::string, std::string>>;

/// 8-bit RGB, rows from top to bottom, 3 * width * height bytes.
struct RgbImage {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> rgb;
  ImageText text;
};

// The writers create a temporary file in the same folder and rename it when it is complete: a
// reader never sees half a picture, and a failure keeps the old file. Errors name the file and the
// reason.

/// Writes a PNG with `text` as tEXt chunks (iTXt if a value is not plain ASCII). Keys have 1 to 79
/// printable ASCII characters and no spaces at their ends.
[[nodiscard]] Result<void> write_png(const std::string& path, const RgbImage& image);

/// Writes the picture as displayed by `display`, with an alpha channel if the film has coverage.
[[nodiscard]] Result<void> write_png(const std::string& path, const Film& film,
                                     const DisplayTransform& display, const ImageText& text);

/// Writes the split map in the colours of `key`.
[[nodiscard]] Result<void> write_split_map_png(const std::string& path, const Film& film,
                                               SplitMapKey key, const ImageText& text = {});

/// Writes linear radiance as 32-bit floats, and `attributes` as string attributes (keys of 1 to 255
/// bytes, each once), which are read in the order of their keys.
/// `options`: layers in channels of their own ("depth.Z"), ids as Cryptomatte, and the camera.
[[nodiscard]] Result<void> write_exr(const std::string& path, const Film& film,
                                     const ImageText& attributes, const ExrOptions& options = {});

[[nodiscard]] Result<RgbImage> read_png(const std::string& path);

struct ExrImage {
  Film film;  ///< without split levels; with coverage where the file has an A channel
  ImageText attributes;
};
/// Reads an EXR. Calls `check` before it allocates the picture.
[[nodiscard]] Result<ExrImage> read_exr(const std::string& path, const SizeCheck& check = {});

/// Returns the text of a PNG's text chunks or an EXR's string attributes; the file's first bytes
/// determine its format. Errors: it cannot be read, has neither format, or its text is damaged.
[[nodiscard]] Result<ImageText> read_image_text(const std::string& path);

/// Writes `bytes` to `path` through a temporary file. All files of the program are written in this
/// way.
[[nodiscard]] Result<void> write_file_atomically(const std::string& path,
                                                 const std::vector<std::uint8_t>& bytes);

}  // namespace asos
