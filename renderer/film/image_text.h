#pragma once

#include "renderer/film/image_io.h"

#include <cstdint>
#include <vector>

namespace asos {

/// Whether a file begins as a PNG does.
[[nodiscard]] bool is_png(const std::vector<std::uint8_t>& file);

/// The text chunks of a PNG (tEXt, zTXt, iTXt), decompressed. Errors name `path`: a chunk of text
/// that is damaged, or of more than 16 MB.
[[nodiscard]] Result<ImageText> png_text(const std::string& path,
                                         const std::vector<std::uint8_t>& file);
/// The string attributes of an EXR.
[[nodiscard]] Result<ImageText> exr_text(const std::string& path,
                                         const std::vector<std::uint8_t>& file);

}  // namespace asos
