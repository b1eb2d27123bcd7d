#pragma once

#include "renderer/files/read_file.h"
#include "renderer/film/image_io.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

namespace asos {

/// The most text that a picture may hold, all of it together and decompressed: 16 MB.
inline constexpr std::size_t most_image_text = std::size_t{16} << 20;

/// Whether a file begins as a PNG does, or as an EXR.
[[nodiscard]] bool is_png(std::span<const std::uint8_t> file);
[[nodiscard]] bool is_exr(std::span<const std::uint8_t> file);

/// What files have to be to be read as a PNG.
[[nodiscard]] FileRules png_rules();

/// The text chunks of a PNG (tEXt, zTXt, iTXt), decompressed. Errors name `path`: text that is
/// damaged, or too much of it.
[[nodiscard]] Result<ImageText> png_text(const std::string& path,
                                         std::span<const std::uint8_t> file);
/// The string attributes of an EXR.
[[nodiscard]] Result<ImageText> exr_text(const std::string& path, const FileBytes& file);

}  // namespace asos
