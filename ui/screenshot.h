#pragma once

#include "renderer/film/image_io.h"
#include "renderer/picture/picture_description.h"
#include "renderer/result.h"

#include <filesystem>
#include <initializer_list>
#include <string>

namespace asos::ui {

class Previewer;
struct DisplaySettings;

/// Folder for screenshots: $XDG_PICTURES_DIR if that is a folder, otherwise the current directory.
[[nodiscard]] std::filesystem::path screenshot_folder();

/// A file name made from a scene's source: "builtin:office" gives "office", a path its stem.
/// Characters that a file name cannot have become "_".
[[nodiscard]] std::string file_title(const std::string& source);
[[nodiscard]] std::string screenshot_stem(const std::string& source);

/// FOLDER/NAME-001, or the next number without a file that has one of the endings.
[[nodiscard]] std::string free_stem(const std::filesystem::path& folder, const std::string& name,
                                    std::initializer_list<const char*> endings = {".png", ".exr"});

/// Metadata of a saved picture: inputs to render it again, times and statistics. Requires a
/// picture.
[[nodiscard]] ImageText screenshot_text(const Previewer& previewer, const DisplaySettings& display);

/// Converts between the window's display settings and those stored in a picture. Values out of the
/// window's range are clamped.
[[nodiscard]] PictureDisplay described(const DisplaySettings& display);
void show_as(const PictureDisplay& described, DisplaySettings& display);

/// Writes `image` as a PNG under the next free name and returns the path.
[[nodiscard]] Result<std::string> save_screenshot(const RgbImage& image,
                                                  const std::filesystem::path& folder,
                                                  const std::string& name);

}  // namespace asos::ui
