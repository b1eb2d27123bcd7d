#include "app/picture_options.h"

#include "app/option.h"
#include "app/scene_argument.h"

#include <fmt/format.h>

#include <limits>
#include <map>

namespace asos {
namespace {

const std::map<std::string, Method> methods{{"asos", Method::asos},
                                            {"uniform", Method::uniform},
                                            {"stochastic", Method::stochastic},
                                            {"beam", Method::beam}};
const std::map<std::string, Leaf> leaves{{"exact", Leaf::exact}, {"point", Leaf::point}};

// A parser of the names in `known`, which outlives it.
template <typename T>
auto parse_name(const std::map<std::string, T>& known) {
  return [&known](const std::string& text) -> Result<T> {
    const auto found = known.find(text);
    if (found != known.end()) return found->second;
    std::string names;
    for (const auto& [name, value] : known) names += (names.empty() ? "" : ", ") + name;
    return tl::unexpected(Error{fmt::format("\"{}\"", text), "not one of " + names});
  };
}

auto whole(int lo, int hi) {
  return [lo, hi](const std::string& text) { return parse_whole(text, lo, hi); };
}

auto number(double lo, double hi, bool open = false) {
  return [=](const std::string& text) { return parse_number(text, lo, hi, open); };
}

void add_method_options(CLI::App& app, RenderSettings& settings) {
  add_parsed_option(
      app, "--method", "NAME",
      "asos, uniform (n x n grid), stochastic (jittered) or beam (exact, for small scenes)",
      parse_name(methods), [&](Method m) { settings.method = m; })
      ->default_str(name_of(settings.method));
  add_parsed_option(app, "--max", "K",
                    "MAX, the deepest level a pixel is split to: 0 to 8 (cells of 1/2^K pixel)",
                    whole(0, RenderSettings::max_level_limit),
                    [&](int k) { settings.max_level = k; })
      ->default_str(std::to_string(settings.max_level));
  add_parsed_option(app, "--eps", "E",
                    "EPS, the change of a pixel's display intensity that is let pass: 0 to 1",
                    number(0, 1), [&](double e) { settings.eps = e; })
      ->default_str(fmt::format("{}", settings.eps));
  add_parsed_option(app, "--leaf", "KIND",
                    "exact (cells are cut along their one boundary) or point (sampled)",
                    parse_name(leaves), [&](Leaf leaf) { settings.leaf = leaf; })
      ->default_str(name_of(settings.leaf));
  app.add_flag("--jitter", settings.jitter,
               "Jitter the samples of cells that stay unresolved at MAX");
  add_parsed_option(app, "--spp", "N",
                    "Samples a pixel of uniform and stochastic, rounded up to a square",
                    whole(1, 65536), [&](int n) { settings.spp = n; })
      ->default_str(std::to_string(settings.spp));
  add_parsed_option(app, "--threads", "N",
                    "Worker threads, 1 to 1024; 0: one for each core but one", whole(0, 1024),
                    [&](int n) { settings.threads = n; })
      ->default_str("0");
}

}  // namespace

const char* name_of(Method method) {
  switch (method) {
    case Method::asos:
      return "asos";
    case Method::uniform:
      return "uniform";
    case Method::stochastic:
      return "stochastic";
    case Method::beam:
      return "beam";
  }
  return "";
}

const char* name_of(Leaf leaf) {
  return leaf == Leaf::exact ? "exact" : "point";
}

void add_picture_options(CLI::App& app, PictureArguments& arguments, bool scene_required) {
  RenderSettings& settings = arguments.settings;
  add_scene_argument(app, arguments.scene, scene_required);
  add_parsed_option(
      app, "--size", "WxH", "Size of the picture in pixels",
      [](const std::string& text) { return parse_size(text, largest_side); },
      [&](PictureSize s) { settings.width = s.width, settings.height = s.height; })
      ->default_str(fmt::format("{}x{}", settings.width, settings.height));
  add_method_options(app, settings);
}

void add_camera_options(CLI::App& app, PictureArguments& arguments) {
  CameraChoice& camera = arguments.camera;
  CLI::Option* index = add_parsed_option(
      app, "--camera", "N",
      "The file's N-th camera, from 0 [its first, or else one that frames all]",
      whole(0, std::numeric_limits<int>::max()), [&](int n) { camera.index = n; });
  add_parsed_option(
      app, "--look-at", "ex,ey,ez,tx,ty,tz",
      "From the eye at ex,ey,ez to the target tx,ty,tz, in the file's units, +Y up",
      [](const std::string& text) { return parse_look_at(text); },
      [&](LookAt look) { camera.look_at = look; })
      ->excludes(index);
  add_parsed_option(app, "--fov", "DEG",
                    "Full vertical field of view in degrees, between 0 and 180 [the camera's]",
                    number(0, 180, true), [&](double degrees) { camera.fov_y_deg = degrees; });
  add_parsed_option(app, "--exposure", "EV",
                    "Exposure of PNG pictures in stops, -32 to 32; each doubles the brightness",
                    number(-32, 32),
                    [&](double ev) { arguments.exposure_ev = static_cast<float>(ev); })
      ->default_str("0");
  add_parsed_option(
      app, "--crop", "x,y,w,h",
      "Only this part of the picture, in pixels from its top left corner [all]",
      [](const std::string& text) { return parse_rect(text, largest_side); },
      [&](PixelRect crop) { arguments.settings.crop = crop; });
}

}  // namespace asos
