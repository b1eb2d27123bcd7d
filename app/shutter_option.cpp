#include "app/shutter_option.h"

#include "app/option.h"
#include "renderer/comparison/method.h"
#include "renderer/settings/value_text.h"

#include <fmt/format.h>

namespace asos {
namespace {

constexpr std::string_view degrees_unit = "deg";

}  // namespace

Result<ShutterChoice> parse_shutter(std::string_view text) {
  const bool degrees = text.ends_with(degrees_unit);
  const std::string_view number =
      degrees ? text.substr(0, text.size() - degrees_unit.size()) : text;
  const auto value = parse_number(number, 0.0, degrees ? 360.0 : ShutterSettings::longest);
  if (value) return ShutterChoice{*value, degrees};
  return tl::unexpected(Error{
      fmt::format("\"{}\"", text),
      fmt::format("is neither 0 to {:g} seconds nor 0deg to 360deg", ShutterSettings::longest)});
}

void add_shutter_option(CLI::App& app, PictureArguments& arguments) {
  add_parsed_option(
      app, "--shutter", "SECONDS|DEGdeg",
      "Motion blur: how long the shutter is open around --time, in seconds or as 0deg to 360deg of "
      "a frame (of --frames, else 1/24 s) [0: off]",
      parse_shutter, [&](ShutterChoice shutter) { arguments.shutter = shutter; });
}

void take_shutter(PictureArguments& arguments, double fps) {
  if (!arguments.shutter) return;
  const ShutterChoice& shutter = *arguments.shutter;
  arguments.settings.shutter.seconds =
      shutter.degrees ? shutter.value / 360.0 / fps : shutter.value;
}

int followed_camera(const CameraChoice& choice, const World& world, const ShutterSettings& saved) {
  if (choice.index) return *choice.index;
  if (choice.look_at) return -1;
  if (choice.given) return saved.camera;
  return world.cameras.empty() ? -1 : 0;
}

Result<void> check_shutter(const ShutterSettings& shutter, const SceneContents& contents,
                           const std::string& source) {
  if (!shutter.blurs() || !contents.animations.empty()) return {};
  return tl::unexpected(
      Error{source, "has no animations, so --shutter has nothing to blur (--shutter 0: off)"});
}

std::vector<std::string> shutter_remarks(const RenderSettings& settings, const Exposure* exposure) {
  if (!settings.shutter.blurs()) return {};
  const MethodRow& row = row_of(settings.method);
  if (!row.takes_motion)
    return {fmt::format("{} renders without motion blur; the picture shows one moment", row.name)};
  return exposure ? exposure_remarks(*exposure) : std::vector<std::string>{};
}

}  // namespace asos
