#pragma once

#include "app/camera_choice.h"
#include "app/clip_choice.h"
#include "app/values.h"
#include "renderer/gltf/load.h"
#include "renderer/picture/picture_description.h"
#include "renderer/result.h"
#include "renderer/settings/settings.h"
#include "renderer/world/needs.h"

#include <optional>
#include <string>

namespace CLI {
class App;
}

namespace asos {

/// How long the shutter is open, as typed.
struct ShutterChoice {
  double value = 0.0;    ///< seconds, or degrees of a frame's time
  bool degrees = false;  ///< 360 of them are a whole frame
};

/// The arguments that the window and `render` share: a scene, how to render it, and from where.
struct PictureArguments {
  std::string scene = "builtin:office";
  std::string variant;        ///< of its materials, as asked for; see load_options_of
  std::string scene_of_file;  ///< by number or name, as asked for; likewise
  std::string asset_root;     ///< see LoadOptions
  RenderSettings settings;
  CameraChoice camera;
  ClipChoice clip;
  std::optional<ShutterChoice> shutter;  ///< until take_shutter makes it settings.shutter
  SkyChoice sky;                         ///< until with_sky makes it settings.sky
  bool sky_chosen = false;               ///< else the scene has that of its default_look
  bool ground_chosen = false;            ///< else its ground, where the sky is not chosen either
  bool background_chosen = false;        ///< else it has default_background of the sky
  float exposure_ev = 0.0f;
  bool exposure_chosen = false;   ///< else it is usual_exposure
  bool exposure_metered = false;  ///< "auto" was chosen
  ToneCurve tone = ToneCurve::neutral;
  NeedsChoice needs = NeedsChoice::scene;

  std::string from_file;                   ///< a picture whose settings these are; empty: none
  std::optional<PictureDescription> from;  ///< its contents
  std::optional<Error> from_error;         ///< why it could not be read
};

// Each adds options that fill `arguments`, which has to outlive the parser.

/// SCENE, the picture's size, and how to render it.
void add_picture_options(CLI::App& app, PictureArguments& arguments, bool scene_required);
/// Where it is seen from, how bright it is shown, and which part of it.
void add_camera_options(CLI::App& app, PictureArguments& arguments);
/// Which moment of the file's animations it shows.
void add_clip_options(CLI::App& app, ClipChoice& clip);
/// The option for what is kept of a scene and done although the scene does not need it.
void add_needs_option(CLI::App& app, NeedsChoice& needs);
/// Those of the options above that decide on the true picture of a scene, and TR: for commands that
/// choose methods and their quality by themselves.
void add_look_options(CLI::App& app, PictureArguments& arguments);

/// Which of the file's scenes is shown in which variant of its materials: those asked for, or else
/// those of the saved picture whose settings are taken, if it is of the same file. A saved picture
/// grants no asset root, so that a downloaded one cannot.
[[nodiscard]] LoadOptions load_options_of(const PictureArguments& arguments);

/// The settings, judging differences by the curve that the picture is shown by; those of a saved
/// picture as it did, where nothing else is asked for, so that it comes out the same.
[[nodiscard]] RenderSettings judged_as_shown(const PictureArguments& arguments);

/// The settings with the sky that was asked for, which is read where it is a file; errors name it.
[[nodiscard]] Result<RenderSettings> with_sky(const PictureArguments& arguments);

/// Gives the settings what nobody chose: sky, ground and background of the scene's default look.
void take_default_look(PictureArguments& arguments, const RenderScene& scene, const Camera& camera);

/// The largest width and height of a picture, in pixels.
inline constexpr int largest_side = 32768;

}  // namespace asos
