#pragma once

#include "app/camera_choice.h"
#include "app/clip_choice.h"
#include "renderer/gltf/load.h"
#include "renderer/picture/picture_description.h"
#include "renderer/result.h"
#include "renderer/settings/settings.h"
#include "renderer/settings/value_text.h"
#include "renderer/world/render_features.h"

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
  std::string variant;        ///< material variant, as typed: see load_options_of
  std::string scene_of_file;  ///< scene of the file, number or name as typed: see load_options_of
  std::string asset_root;     ///< see LoadOptions
  RenderSettings settings;
  CameraChoice camera;
  ClipChoice clip;
  std::optional<ShutterChoice> shutter;  ///< until take_shutter makes it settings.shutter
  SkyChoice sky;                         ///< until with_sky makes it settings.sky
  bool sky_chosen = false;               ///< false: the sky of default_look
  bool ground_chosen = false;            ///< false: that of default_look, unless a sky is chosen
  bool background_chosen = false;        ///< false: default_background of the sky
  float exposure_ev = 0.0f;
  bool exposure_chosen = false;   ///< false: usual_exposure
  bool exposure_metered = false;  ///< "auto" was chosen
  ToneCurve tone = ToneCurve::neutral;
  FeatureChoice render_features = FeatureChoice::scene;

  std::string from_file;                   ///< the picture given by --from; empty: none
  std::optional<PictureDescription> from;  ///< its contents
  std::optional<Error> from_error;         ///< why it could not be read
};

// Each function adds options that fill `arguments`, which must outlive the parser.

/// The scene, the picture's size, and how to render it.
void add_picture_options(CLI::App& app, PictureArguments& arguments, bool scene_required);
/// Camera, exposure and crop.
void add_camera_options(CLI::App& app, PictureArguments& arguments);
/// The time in the file's animations.
void add_clip_options(CLI::App& app, ClipChoice& clip);
/// The option that keeps features and work that the scene does not need.
void add_needs_option(CLI::App& app, FeatureChoice& render_features);
/// The subset of the options above that defines the exact picture of a scene, and TR: for commands
/// that choose methods and quality themselves.
void add_look_options(CLI::App& app, PictureArguments& arguments);

/// Selects the scene of the file and the material variant: as on the command line, or as in the
/// picture given by --from if it shows the same file. The picture's asset root is not used, so that
/// a downloaded picture cannot grant access to files.
[[nodiscard]] LoadOptions load_options_of(const PictureArguments& arguments);

/// Returns the settings with the displayed tone curve for judging errors. Without other options, a
/// picture given by --from keeps its own, so that it is reproduced exactly.
[[nodiscard]] RenderSettings judged_as_shown(const PictureArguments& arguments);

/// Returns the settings with the selected sky, which is read if it is a file; errors name it.
[[nodiscard]] Result<RenderSettings> with_sky(const PictureArguments& arguments);

/// Completes the settings. Unless a sky was chosen, takes sky and ground from the scene's default
/// look; a chosen ground stays. Unless a background was chosen, takes the sky's default one.
void take_default_look(PictureArguments& arguments, const RenderScene& scene, const Camera& camera);

/// The largest width and height of a picture, in pixels.
inline constexpr int largest_side = 32768;

}  // namespace asos
