#pragma once

#include "app/camera_choice.h"
#include "app/values.h"
#include "renderer/methods/settings.h"
#include "renderer/scene/needs.h"

#include <string>

namespace CLI {
class App;
}

namespace asos {

/// What the window and `render` have in common: a scene, how to render it, and from where.
struct PictureArguments {
  std::string scene = "builtin:office";
  RenderSettings settings;
  CameraChoice camera;
  SkyChoice sky;  ///< until open_sky makes it settings.sky
  double sky_turn_deg = 0.0;
  float exposure_ev = 0.0f;
  NeedsChoice needs = NeedsChoice::scene;
};

// Each adds options that fill `arguments`, which has to outlive the parser.

/// SCENE, the picture's size, and how to render it.
void add_picture_options(CLI::App& app, PictureArguments& arguments, bool scene_required);
/// Where it is seen from, how bright it is shown, and which part of it.
void add_camera_options(CLI::App& app, PictureArguments& arguments);

/// The settings with the sky that was asked for, which is read where it is a file; errors name it.
[[nodiscard]] Result<RenderSettings> with_sky(const PictureArguments& arguments);

/// The largest width and height of a picture, in pixels.
inline constexpr int largest_side = 32768;

}  // namespace asos
