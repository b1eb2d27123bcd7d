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

/// Keys and values that travel inside a picture's file, in order.
using ImageText = std::vector<std::pair<std::string, std::string>>;

/// 8-bit RGB, rows from top to bottom, 3 * width * height bytes.
struct RgbImage {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> rgb;
  ImageText text;
};

// The writers put the file beside its place and rename it there when it is whole: a reader never
// sees half a picture, and a failure leaves what was there. Errors name the file and the reason.

/// A PNG with `text` as tEXt chunks (iTXt where a value is not plain ASCII). Keys have 1 to 79
/// printable ASCII characters and no spaces at their ends.
[[nodiscard]] Result<void> write_png(const std::string& path, const RgbImage& image);

/// The picture as `display` shows it, with an alpha channel where the film has coverage.
[[nodiscard]] Result<void> write_png(const std::string& path, const Film& film,
                                     const DisplayTransform& display, const ImageText& text);

/// The split map in the colours of `key`.
[[nodiscard]] Result<void> write_split_map_png(const std::string& path, const Film& film,
                                               SplitMapKey key, const ImageText& text = {});

/// Linear radiance as 32-bit floats, with `attributes` as string attributes (keys
/// of 1 to 255 bytes, each once), which come back in the order of their keys.
/// `options`: layers in channels of their own ("depth.Z"), ids as Cryptomatte, and the camera.
[[nodiscard]] Result<void> write_exr(const std::string& path, const Film& film,
                                     const ImageText& attributes, const ExrOptions& options = {});

[[nodiscard]] Result<RgbImage> read_png(const std::string& path);

struct ExrImage {
  Film film;  ///< without split levels; with coverage where the file has an A channel
  ImageText attributes;
};
/// `check` is asked before anything of the picture's size is made.
[[nodiscard]] Result<ExrImage> read_exr(const std::string& path, const SizeCheck& check = {});

/// The text of a PNG's text chunks or an EXR's string attributes; the file's first bytes tell which
/// of both it is. Errors: cannot be read, is neither, its text is damaged.
[[nodiscard]] Result<ImageText> read_image_text(const std::string& path);

/// Writes `bytes` to `path` by way of a file beside it. For every file that the program makes.
[[nodiscard]] Result<void> write_file_atomically(const std::string& path,
                                                 const std::vector<std::uint8_t>& bytes);

}  // namespace asos
