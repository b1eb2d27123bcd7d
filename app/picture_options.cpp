#include "app/picture_options.h"

#include "app/option.h"
#include "app/scene_argument.h"
#include "renderer/comparison/method.h"
#include "renderer/geometry/coordinates.h"
#include "renderer/geometry/lens.h"
#include "renderer/prepared/default_look.h"
#include "renderer/settings/names.h"
#include "renderer/shading/environments.h"

#include <fmt/format.h>

#include <array>
#include <limits>
#include <string>
#include <utility>

namespace asos {
namespace {

constexpr std::array clip_names{Named<bool>{"on", true}, Named<bool>{"off", false}};
constexpr std::array camera_fit_names{
    Named<CameraFit>{"fit", CameraFit::fit},
    Named<CameraFit>{"fill", CameraFit::fill},
    Named<CameraFit>{"crop", CameraFit::crop},
};

auto whole(int lo, int hi) {
  return [lo, hi](const std::string& text) { return parse_whole(text, lo, hi); };
}

auto number(double lo, double hi, bool open = false) {
  return [=](const std::string& text) { return parse_number(text, lo, hi, open); };
}

void add_mirror_options(CLI::App& app, RenderSettings& settings) {
  add_setting(app, "reflections", "N", settings);
  add_setting(app, "roughest-mirror", "R", settings);
  add_parsed_option(
      app, "--dfr", "MIN,MAX,N",
      "One DFR for all mirrors: DFR = MIN + (MAX - MIN) sin(alpha)^N at the angle of incidence "
      "alpha (CGF'98 section 5.1)",
      [](const std::string& text) { return parse_dfr(text); },
      [&](const Dfr& dfr) { settings.mirror.dfr = dfr; });
}

// Lists each method's name and hint.
std::string method_words() {
  std::string words;
  const auto methods = method_table();
  for (const MethodRow& method : methods) {
    if (!words.empty()) words += &method == &methods.back() ? " or " : ", ";
    words += method.name;
    if (*method.hint) words += fmt::format(" ({})", method.hint);
  }
  return words;
}

// Joins the names of the selected rows: "asos, uniform and sobol".
std::string listed(bool (*wanted)(const MethodRow& row)) {
  std::vector<std::string> names;
  for (const MethodRow& row : method_table())
    if (wanted(row)) names.emplace_back(row.name);
  std::string words;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (i > 0) words += i + 1 == names.size() ? " and " : ", ";
    words += names[i];
  }
  return words;
}

void add_method_options(CLI::App& app, RenderSettings& settings) {
  add_choice(app, "--method", "NAME", method_words().c_str(), method_table(), settings.method);
  add_setting(app, "max", "K", settings);
  add_setting(app, "eps", "E", settings);
  add_setting(app, "leaf", "KIND", settings);
  add_setting(app, "rule", "NAME", settings);
  add_setting(app, "detect", "KIND", settings);
  add_setting(app, "fat", "N", settings);
  add_setting(app, "filter-width", "W", settings,
              "; for " + listed([](const MethodRow& row) { return row.takes_filter_width; }));
  add_setting(app, "line-width", "W", settings);
  app.add_flag("--jitter", settings.asos.jitter, setting_of_option("jitter").about);
  add_setting(app, "spp", "N", settings);
  add_setting(app, "contrast", "C", settings);
  add_setting(app, "depth", "K", settings);
  app.add_flag("--spheres", settings.sampling.spheres, setting_of_option("spheres").about);
  add_setting(app, "contrast-scale", "S", settings);
  add_setting(app, "texture-filter", "KIND", settings);
  add_setting(app, "tr", "N", settings);
  app.add_flag("!--no-shading-refinement", settings.asos.refine_shading,
               "Split at edges only, not for varying shading");
  app.add_flag("!--no-culling", settings.cull,
               "Show the backs of single-sided materials, which glTF hides");
  app.add_flag("!--no-shadows", settings.shadow.cast, "Turn shadows off");
  add_setting(app, "sky-shadows", "ON|OFF", settings);
  add_setting(app, "bounces", "N", settings);
  add_setting(app, "shadow-quality", "NAME", settings);
  add_setting(app, "shadow-divisions", "N", settings);
  add_setting(app, "light-rule", "NAME", settings);
  add_mirror_options(app, settings);
  add_setting(app, "curved-mirror", "NAME", settings);
  add_setting(app, "mirror-angle", "DEG", settings);
  add_setting(app, "seed", "N", settings);
  add_setting(app, "threads", "N", settings);
}

std::string environment_words() {
  std::string words;
  for (const EnvironmentRow& row : environments)
    words += (words.empty() ? "" : ", ") + std::string(row.name);
  return words;
}

void add_sky_options(CLI::App& app, PictureArguments& arguments, const char* usual) {
  add_parsed_option(app, "--sky", "WHAT",
                    "Sky: neutral (grey), an environment (" + environment_words() +
                        "; with a light for scenes without lights), R,G,B (linear), R,G,B:R,G,B "
                        "(zenith:horizon), FILE.hdr or FILE.exr (equirectangular)",
                    parse_sky,
                    [&](SkyChoice sky) {
                      sky.turn_deg = arguments.sky.turn_deg;
                      sky.brightness = arguments.sky.brightness;
                      arguments.sky = std::move(sky);
                      arguments.sky_chosen = true;
                    })
      ->default_str(usual);
  add_parsed_option(
      app, "--sky-turn", "DEG",
      "Rotation of a picture or environment about the vertical, counter-clockwise from above, "
      "-360 to 360 degrees",
      number(-360, 360), [&](double degrees) { arguments.sky.turn_deg = degrees; })
      ->default_str("0");
  add_parsed_option(app, "--sky-brightness", "TIMES",
                    "Brightness factor of a picture or environment, 0 to 1000",
                    number(0, SkyChoice::most_brightness),
                    [&](double times) { arguments.sky.brightness = times; })
      ->default_str("1");
}

void add_stage_options(CLI::App& app, PictureArguments& arguments) {
  add_parsed_option(app, "--background", "WHAT",
                    "Background: environment (the sky), blurred, transparent (alpha channel), "
                    "R,G,B (linear) or R,G,B:R,G,B (upper:lower border)",
                    parse_background,
                    [&](const Background& background) {
                      arguments.settings.background = background;
                      arguments.background_chosen = true;
                    })
      ->default_str("environment; the distant ground's grey for softboxes and windows");
  add_parsed_option(app, "--ground", "WHAT",
                    "Ground plane: off, on (catches shadows) or mirror (also reflects)",
                    name_parser(std::span(ground_names)),
                    [&](Ground ground) {
                      arguments.settings.ground = ground;
                      arguments.ground_chosen = true;
                    })
      ->default_str("on for a scene without lights in its default sky, else off");
}

// Options for the camera, without those for the display of the picture.
void add_camera_choice(CLI::App& app, CameraChoice& camera) {
  CLI::Option* index = add_parsed_option(
      app, "--camera", "N",
      "Number of the file's camera, from 0 [the first, else one that frames the scene]",
      whole(0, std::numeric_limits<int>::max()), [&](int n) { camera.index = n; });
  add_parsed_option(
      app, "--look-at", "ex,ey,ez,tx,ty,tz",
      "View from the eye ex,ey,ez to the target tx,ty,tz, in file units, +Y up",
      [](const std::string& text) { return parse_look_at(text); },
      [&](LookAt look) { camera.look_at = look; })
      ->excludes(index);
  add_parsed_option(app, "--fov", "DEG",
                    "Vertical field of view in degrees, between 0 and 180 [the camera's]",
                    number(0, 180, true), [&](double degrees) { camera.fov_y_deg = degrees; });
}

void add_lens_options(CLI::App& app, LensChoice& lens) {
  CLI::Option* aperture = add_parsed_option(
      app, "--aperture", "RADIUS",
      "Depth of field: radius of the lens in file units; 0: a pinhole [the camera's]",
      number(0, largest_coordinate), [&](double radius) { lens.radius = radius; });
  add_parsed_option(app, "--f-stop", "N",
                    "The same for a scene in metres, as f/N of a 24 mm high sensor, 0.1 to 1e6",
                    number(Lens::smallest_f_stop, Lens::largest_f_stop),
                    [&](double n) { lens.f_stop = n; })
      ->excludes(aperture);
  add_parsed_option(
      app, "--focus", "DISTANCE",
      "Distance of the sharp plane along the view axis [of what is in the middle of the picture]",
      [](const std::string& text) { return parse_number(text, 0.0, largest_coordinate); },
      [&](double focus) {
        if (!(focus > 0.0)) throw CLI::ValidationError("--focus", "has to be ahead of the camera");
        lens.focus = focus;
      });
  add_parsed_option(
      app, "--blades", "N", "Corners of the aperture: 0 (a disk) or 3 to 32 [0]",
      [](const std::string& text) -> Result<int> {
        const Result<int> n = parse_whole(text, 0, Lens::most_blades);
        if (n && *n > 0 && *n < Lens::fewest_blades)
          return tl::unexpected(Error{fmt::format("\"{}\"", text), "has to be 0 or 3 to 32"});
        return n;
      },
      [&](int n) { lens.blades = n; });
  add_parsed_option(app, "--blade-turn", "DEG",
                    "Counter-clockwise turn of the first corner from the right, -360 to 360 [0]",
                    number(-360, 360), [&](double degrees) { lens.turn_deg = degrees; });
}

}  // namespace

void add_picture_options(CLI::App& app, PictureArguments& arguments, bool scene_required) {
  RenderSettings& settings = arguments.settings;
  add_scene_argument(app, arguments.scene, scene_required);
  add_parsed_option(
      app, "--size", "WxH", "Size of the picture in pixels",
      [](const std::string& text) { return parse_size(text, largest_side); },
      [&](PictureSize s) { settings.width = s.width, settings.height = s.height; })
      ->default_str(fmt::format("{}x{}", settings.width, settings.height));
  add_method_options(app, settings);
  add_sky_options(app, arguments, "softboxes for a scene without lights, else neutral");
  add_stage_options(app, arguments);
  add_needs_option(app, arguments.render_features);
}

void add_camera_options(CLI::App& app, PictureArguments& arguments) {
  add_camera_choice(app, arguments.camera);
  add_lens_options(app, arguments.camera.lens);
  add_choice(
      app, "--fit", "HOW",
      "A camera of the file in a picture of another aspect ratio: fit (all of its view, and "
      "more), fill (nothing outside its view) or crop (its height; a wider camera loses its sides)",
      camera_fit_names, arguments.camera.fit);
  add_choice(app, "--clip", "on|off",
             "A camera of the file cuts off what is nearer than its znear or farther than its zfar",
             clip_names, arguments.camera.planes);
  add_parsed_option(app, "--exposure", "EV",
                    "Exposure of PNG pictures in stops, -32 to 32; each doubles the brightness. "
                    "auto: by the picture's brightness",
                    parse_exposure,
                    [&](std::optional<float> ev) {
                      arguments.exposure_ev = ev.value_or(0.0f);
                      arguments.exposure_chosen = true;
                      arguments.exposure_metered = !ev;
                    })
      ->default_str("0; auto where a file's lights whiten over a tenth of the picture");
  add_choice(
      app, "--tone", "CURVE",
      "Tone curve of PNG files: none (clipped), neutral (Khronos PBR Neutral) or agx (film-like)",
      tone_names, arguments.tone);
  add_parsed_option(
      app, "--crop", "x,y,w,h",
      "Render only this rectangle, in pixels from the top left corner [all]",
      [](const std::string& text) { return parse_rect(text, largest_side); },
      [&](PixelRect crop) { arguments.settings.crop = crop; });
}

void add_clip_options(CLI::App& app, ClipChoice& clip) {
  app.add_option("--animation", clip.animation,
                 "Animation, by name or number from 0 [the first with --time, else the rest pose]")
      ->type_name("NAME|N");
  add_parsed_option(app, "--time", "SECONDS", "Time in the animation in seconds [0]",
                    number(0, 1e6), [&](double seconds) { clip.seconds = seconds; });
}

void add_needs_option(CLI::App& app, FeatureChoice& render_features) {
  add_choice(app, "--needs", "WHAT",
             "Work to do: scene (only what the scene needs) or all (slower, same picture)",
             needs_names, render_features);
}

void add_look_options(CLI::App& app, PictureArguments& arguments) {
  add_camera_choice(app, arguments.camera);
  add_sky_options(app, arguments, "neutral");
  add_mirror_options(app, arguments.settings);
  add_setting(app, "tr", "N", arguments.settings);
  add_needs_option(app, arguments.render_features);
  add_asset_root_option(app, arguments.asset_root);
}

LoadOptions load_options_of(const PictureArguments& arguments) {
  const bool same = arguments.from && arguments.from->scene == arguments.scene;
  LoadOptions options = same ? arguments.from->load_options() : LoadOptions{};
  options.asset_root = arguments.asset_root;
  if (!arguments.variant.empty()) options.variant = arguments.variant;
  if (!arguments.scene_of_file.empty()) options.scene = arguments.scene_of_file;
  return options;
}

RenderSettings judged_as_shown(const PictureArguments& arguments) {
  const auto& from = arguments.from;
  const bool as_it_was = from && from->settings.method == arguments.settings.method &&
                         from->display.tone == arguments.tone;
  return as_it_was ? arguments.settings : judged_by(arguments.settings, arguments.tone);
}

Result<RenderSettings> with_sky(const PictureArguments& arguments) {
  return make_sky(arguments.sky).map([&](std::shared_ptr<const Sky> sky) {
    RenderSettings settings = arguments.settings;
    settings.sky = std::move(sky);
    return settings;
  });
}

void take_default_look(PictureArguments& arguments, const RenderScene& scene,
                       const Camera& camera) {
  RenderSettings& settings = arguments.settings;
  if (!arguments.sky_chosen) {
    const DefaultLook look = default_look(scene, camera);
    settings.sky = look.sky;
    if (look.sky)
      settings.sky = std::make_shared<const Sky>(
          look.sky->turned(arguments.sky.turn_deg).brightened(arguments.sky.brightness));
    if (!arguments.ground_chosen) settings.ground = look.ground;
  }
  if (!arguments.background_chosen) settings.background = default_background(settings.sky.get());
}

}  // namespace asos
