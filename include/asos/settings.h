#pragma once

#include "asos/types.h"

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace asos::api {

/// What the eye sees where no surface is.
enum class Background {
  automatic,    ///< the sky, or the grey of the distant ground for environments with panels
  environment,  ///< the sky
  blurred,      ///< the sky, out of focus
  colours,      ///< from `background_top` to `background_bottom`
  transparent   ///< nothing: the picture has a layer "alpha"
};

enum class Ground { automatic, off, on, mirror };

/// The curve from radiance to display values.
enum class Tone { none, neutral, agx };

/// A setting that `Settings::more` takes.
struct SettingInfo {
  std::string name = {};
  std::string about = {};                 ///< a sentence for the user
  std::string usual = {};                 ///< its default
  std::vector<std::string> choices = {};  ///< its values; empty: a number, or more than one
  double least = 0.0;                     ///< a number's range
  double most = 0.0;
};

/// How a picture is rendered. Values out of range are errors of the call that takes them.
struct Settings {
  int width = 1280;  ///< pixels, 1 to 32768
  int height = 720;
  std::optional<Rect> crop = {};  ///< the part of the picture to render; none: all
  std::string method = "asos";    ///< a name of `method_names`
  int max_level = 4;              ///< MAX, 0 to 8: the deepest level of a pixel's subdivision
  double eps = 1.0 / 256.0;       ///< EPS, 0 to 1: allowed error of a pixel's display value
  int samples = 16;               ///< a pixel, for sampling methods, 1 to 65536
  int texture_resolution = 1;     ///< TR, 1 to 8
  bool shadows = true;            ///< lights cast shadows
  bool sky_shadows = false;       ///< so does the sky
  int bounces = 0;                ///< diffuse bounces, 0 or 1
  int reflections = 4;            ///< mirror bounces, 0 to 64
  /// The surroundings: empty: the default for the scene; "neutral": even grey; an environment
  /// ("softboxes", "windows", "studio", "daylight", "dusk", "white", "grey"); "R,G,B" or
  /// "R,G,B:R,G,B" (zenith and horizon, linear); or the path of an equirectangular .hdr or .exr
  /// file.
  std::string sky = {};
  double sky_turn_deg = 0.0;    ///< about +Y, counter-clockwise from above
  double sky_brightness = 1.0;  ///< factor, 0 to 1000
  Ground ground = Ground::automatic;
  Background background = Background::automatic;
  Float3 background_top{0.35f, 0.35f, 0.35f};  ///< linear radiance, 0 to 1e6
  Float3 background_bottom{0.35f, 0.35f, 0.35f};
  Tone tone = Tone::neutral;  ///< of saved 8-bit pictures; EPS is judged by it, too
  /// Seconds that the shutter is open around the scene's moment, 0 to 3600. A scene at rest is
  /// shown at the beginning of its first animation. Fails for a scene without animations.
  double shutter_seconds = 0.0;
  /// Layers in addition to those that every picture has: names of `layer_list`.
  std::vector<std::string> layers = {};
  /// All other settings, by a name of `setting_list`: {"filter_width", "2"}. A name that has a
  /// member above, too, counts instead of it.
  std::map<std::string, std::string> more = {};
  int seed = 0;     ///< 0 and more
  int threads = 0;  ///< 0: one for each core, at most 1024
};

/// Returns what `Settings::more` may hold. Any thread.
[[nodiscard]] ASOS_API std::vector<SettingInfo> setting_list();

/// Returns the names of all methods, "asos" first. Any thread.
[[nodiscard]] ASOS_API std::vector<std::string> method_names();

}  // namespace asos::api
