#pragma once

#include "renderer/film/image_io.h"
#include "renderer/picture/picture_description.h"
#include "renderer/result.h"

#include <filesystem>
#include <string>

namespace asos::ui {

class Previewer;
struct DisplaySettings;

/// Where screenshots go: $XDG_PICTURES_DIR where that is a folder, else the current directory.
[[nodiscard]] std::filesystem::path screenshot_folder();

/// A file name made from a scene's source: "builtin:office" gives "office", a path its stem; what
/// cannot be part of a name becomes "_".
[[nodiscard]] std::string screenshot_stem(const std::string& source);

/// FOLDER/NAME-001, or the next number that no picture has.
[[nodiscard]] std::string free_stem(const std::filesystem::path& folder, const std::string& name);

/// FOLDER/NAME-001.glb, or the next number that no file has.
[[nodiscard]] std::string free_scene_path(const std::filesystem::path& folder,
                                          const std::string& name);

/// The metadata of a saved picture: how it can be made again, time and statistics. Only with a
/// picture.
[[nodiscard]] ImageText screenshot_text(const Previewer& previewer, const DisplaySettings& display);

/// The display settings that a picture keeps, and the way back. Values out of the window's range
/// become its nearest end.
[[nodiscard]] PictureDisplay described(const DisplaySettings& display);
void show_as(const PictureDisplay& described, DisplaySettings& display);

/// Writes `image` as a PNG under the next free name, and returns the path.
[[nodiscard]] Result<std::string> save_screenshot(const RgbImage& image,
                                                  const std::filesystem::path& folder,
                                                  const std::string& name);

}  // namespace asos::ui
