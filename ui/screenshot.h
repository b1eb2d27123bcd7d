#pragma once

#include "renderer/film/image_io.h"
#include "renderer/result.h"

#include <filesystem>
#include <string>

namespace asos {

class Previewer;
struct DisplaySettings;

/// Where screenshots go: $XDG_PICTURES_DIR where that is a folder, else the current directory.
[[nodiscard]] std::filesystem::path screenshot_folder();

/// A file name made from a scene's source: "builtin:office" gives "office", a path its stem; what
/// cannot be part of a name becomes "_".
[[nodiscard]] std::string screenshot_stem(const std::string& source);

/// What a saved picture says about itself: scene, camera, settings, time and statistics, in the
/// words of the command line's pictures.
[[nodiscard]] ImageText screenshot_text(const Previewer& previewer, const DisplaySettings& display);

/// Writes `image` as STEM-001.png in `folder`, or the next number that is free, and returns the
/// path.
[[nodiscard]] Result<std::string> save_screenshot(const RgbImage& image,
                                                  const std::filesystem::path& folder,
                                                  const std::string& stem);

}  // namespace asos
