#pragma once

#include "app/picture_options.h"
#include "renderer/prepared/exposure.h"
#include "renderer/result.h"

#include <string>
#include <string_view>
#include <vector>

namespace CLI {
class App;
}

namespace asos {

/// Frames a second that degrees refer to without --frames.
inline constexpr double usual_fps = 24.0;

/// "SECONDS" or "DEGdeg" with 0 to 360 degrees of a frame's time.
[[nodiscard]] Result<ShutterChoice> parse_shutter(std::string_view text);

/// The option for how long the shutter is open.
void add_shutter_option(CLI::App& app, PictureArguments& arguments);

/// Sets the requested shutter in the settings; `fps` converts its degrees to seconds.
void take_shutter(PictureArguments& arguments, double fps);

/// The scene's camera whose motion a picture by the chosen camera follows; -1: the camera stands
/// still.
[[nodiscard]] int followed_camera(const CameraChoice& choice, const World& world,
                                  const ShutterSettings& saved);

/// Refuses a shutter where nothing can move. The error's subject is `source`.
[[nodiscard]] Result<void> check_shutter(const ShutterSettings& shutter,
                                         const SceneContents& contents, const std::string& source);

/// Warnings about the motion blur of a picture by this method; `exposure` may be null.
[[nodiscard]] std::vector<std::string> shutter_remarks(const RenderSettings& settings,
                                                       const Exposure* exposure);

}  // namespace asos
