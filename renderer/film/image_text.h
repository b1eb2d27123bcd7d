#pragma once

#include "renderer/files/read_file.h"
#include "renderer/film/image_io.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

namespace asos {

/// The largest total size of the decompressed text in a picture: 16 MB.
inline constexpr std::size_t most_image_text = std::size_t{16} << 20;

/// Returns whether a file begins as a PNG, or as an EXR.
[[nodiscard]] bool is_png(std::span<const std::uint8_t> file);
[[nodiscard]] bool is_exr(std::span<const std::uint8_t> file);

/// Returns the conditions on files that are read as PNGs.
[[nodiscard]] FileRules png_rules();

/// Returns the text chunks of a PNG (tEXt, zTXt, iTXt), decompressed. Errors name `path`: damaged
/// text, or too much of it.
[[nodiscard]] Result<ImageText> png_text(const std::string& path,
                                         std::span<const std::uint8_t> file);
/// Returns the string attributes of an EXR.
[[nodiscard]] Result<ImageText> exr_text(const std::string& path, const FileBytes& file);

}  // namespace asos
