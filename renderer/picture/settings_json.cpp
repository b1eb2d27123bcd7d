#include "renderer/picture/settings_json.h"

#include "renderer/comparison/method.h"
#include "renderer/picture/dfr_json.h"
#include "renderer/picture/json_fields.h"
#include "renderer/picture/path_text.h"
#include "renderer/settings/names.h"
#include "renderer/shading/environments.h"

#include <algorithm>

namespace asos {
namespace {

/// Visits the settings that every picture has. Crop, DFR, sky and newer settings are written
/// separately.
template <typename Fields, typename Settings>
void each_setting(Fields& fields, Settings& s) {
  fields("width", s.width);
  fields("height", s.height);
  fields.named("method", method_table(), s.method);
  fields("max_level", s.asos.max_level);
  fields("eps", s.asos.eps);
  fields.named("leaf", leaf_names, s.asos.leaf);
  fields.named("rule", rule_names, s.asos.rule);
  fields.named("detect", detection_names, s.asos.detect);
  fields("fat", s.asos.fat);
  fields("refine_shading", s.asos.refine_shading);
  fields("filter_width", s.filter_width);
  fields("jitter", s.asos.jitter);
  fields("spp", s.sampling.spp);
  fields("contrast", s.sampling.contrast);
  fields("depth", s.sampling.depth);
  fields("spheres", s.sampling.spheres);
  fields("contrast_scale", s.sampling.contrast_scale);
  fields.named("texture_filter", texture_filter_names, s.texture.filter);
  fields("texture_resolution", s.texture.resolution);
  fields("shadows", s.shadow.cast);
  fields.named("shadow_quality", shadow_quality_names, s.shadow.quality);
  fields("shadow_divisions", s.shadow.divisions);
  fields.named("light_rule", light_rule_names, s.shadow.light_rule);
  fields("reflections", s.mirror.bounces);
  fields("roughest_mirror", s.mirror.roughest);
  fields.named("curved_mirror", curved_mirror_names, s.mirror.curved);
  fields("mirror_angle", s.mirror.widest_angle_deg);
  fields("cull", s.cull);
  fields("seed", s.seed);
}

// Written only if not the default, since older pictures do not have them.
constexpr const char* sky_shadows_key = "sky_shadows";
constexpr const char* bounces_key = "bounces";
constexpr const char* sky_turn_key = "turn_deg";
constexpr const char* sky_brightness_key = "brightness";
constexpr const char* environment_key = "environment";
constexpr const char* line_width_key = "line_width";
constexpr const char* background_key = "background";
constexpr const char* ground_key = "ground";
constexpr const char* judged_tone_key = "judged_tone";
constexpr const char* shutter_key = "shutter_seconds";
constexpr const char* shutter_camera_key = "shutter_camera";
constexpr const char* layers_key = "layers";

OrderedJson crop_json(const PixelRect& crop) {
  if (crop == PixelRect{}) return nullptr;
  return {crop.x, crop.y, crop.width, crop.height};
}

void read_crop(FieldReader& fields, PixelRect& crop) {
  const OrderedJson* at = fields.take("crop");
  if (!at || at->is_null()) return;
  const bool four = at->is_array() && at->size() == 4 &&
                    std::all_of(at->begin(), at->end(), [](const OrderedJson& number) {
                      return number.is_number_integer() && number.get<double>() >= 0.0 &&
                             number.get<double>() <= 1e9;
                    });
  if (!four) return fields.refuse("crop", "is no list of four numbers of pixels");
  crop = {at->at(0).get<int>(), at->at(1).get<int>(), at->at(2).get<int>(), at->at(3).get<int>()};
}

void read_dfr(FieldReader& settings, std::optional<Dfr>& dfr) {
  const OrderedJson* at = settings.take("dfr");
  if (!at) return;
  auto read = dfr_from_json(*at);
  if (!read) return settings.refuse("dfr", read.error().reason);
  dfr = *std::move(read);
}

OrderedJson sky_json(const SkyChoice& sky) {
  FieldWriter fields;
  if (sky.environment) {
    fields.named(environment_key, environments, *sky.environment);
    if (sky.turn_deg != 0.0) fields(sky_turn_key, sky.turn_deg);
    if (sky.brightness != 1.0) fields(sky_brightness_key, sky.brightness);
  } else if (sky.colours) {
    fields("zenith", sky.colours->zenith);
    fields("horizon", sky.colours->horizon);
  } else if (!sky.file.empty()) {
    fields("file", text_of_path(sky.file));
    fields(sky_turn_key, sky.turn_deg);
    if (sky.brightness != 1.0) fields(sky_brightness_key, sky.brightness);
  } else {
    return "neutral";
  }
  return fields.take();
}

void read_brightness(FieldReader& fields, SkyChoice& sky) {
  if (fields.has(sky_brightness_key)) fields(sky_brightness_key, sky.brightness);
  if (!(sky.brightness >= 0.0 && sky.brightness <= SkyChoice::most_brightness))
    fields.refuse(sky_brightness_key, "is out of range");
}

void read_sky_choice(FieldReader& settings, SkyChoice& sky) {
  const OrderedJson* at = settings.take("sky");
  if (!at || *at == "neutral") return;
  FieldReader fields(*at, "sky");
  if (fields.has(environment_key)) {
    fields.named(environment_key, environments, sky.environment.emplace());
    if (fields.has(sky_turn_key)) fields(sky_turn_key, sky.turn_deg);
    read_brightness(fields, sky);
  } else if (at->contains("file")) {
    fields("file", sky.file);
    sky.file = path_of_text(sky.file);
    fields(sky_turn_key, sky.turn_deg);
    read_brightness(fields, sky);
  } else {
    sky.colours = SkyChoice::Colours{};
    fields("zenith", sky.colours->zenith);
    fields("horizon", sky.colours->horizon);
  }
  if (const std::string fault = fields.fault(); !fault.empty()) settings.refuse("sky", fault);
}

OrderedJson background_json(const Background& background) {
  FieldWriter fields;
  fields.named("kind", background_names, background.kind);
  fields("top", background.top);
  fields("bottom", background.bottom);
  return fields.take();
}

void read_background(FieldReader& settings, Background& background) {
  const OrderedJson* at = settings.take(background_key);
  if (!at) return;
  FieldReader fields(*at, background_key);
  fields.named("kind", background_names, background.kind);
  fields("top", background.top);
  fields("bottom", background.bottom);
  if (const std::string fault = fields.fault(); !fault.empty())
    settings.refuse(background_key, fault);
}

void read_layers(FieldReader& settings, LayerSet& layers) {
  std::string text;
  settings(layers_key, text);
  const Result<LayerSet> read = parse_layers(text);
  if (!read) return settings.refuse(layers_key, read.error().message());
  layers = *read;
}

}  // namespace

OrderedJson settings_json(const RenderSettings& settings) {
  return settings_json(settings, choice_of(settings.sky.get()));
}

OrderedJson settings_json(const RenderSettings& settings, const SkyChoice& sky) {
  FieldWriter fields;
  each_setting(fields, settings);
  fields.other("crop", crop_json(settings.crop));
  fields.other("dfr", dfr_json(settings.mirror.dfr));
  fields.other("sky", sky_json(sky));
  if (settings.shadow.sky) fields(sky_shadows_key, true);
  if (settings.shadow.bounces > 0) fields(bounces_key, settings.shadow.bounces);
  if (settings.line_width != RenderSettings{}.line_width)
    fields(line_width_key, settings.line_width);
  if (settings.background != Background{})
    fields.other(background_key, background_json(settings.background));
  if (settings.ground != Ground::off) fields.named(ground_key, ground_names, settings.ground);
  if (settings.judged_tone != ToneCurve::none)
    fields.named(judged_tone_key, tone_names, settings.judged_tone);
  if (settings.shutter.blurs()) {
    fields(shutter_key, settings.shutter.seconds);
    if (settings.shutter.camera >= 0) fields(shutter_camera_key, settings.shutter.camera);
  }
  if (!settings.layers.empty()) fields(layers_key, text_of(settings.layers));
  return fields.take();
}

Result<DescribedSettings> settings_from_json(const OrderedJson& json) {
  DescribedSettings read;
  FieldReader fields(json, "settings");
  each_setting(fields, read.settings);
  read_crop(fields, read.settings.crop);
  read_dfr(fields, read.settings.mirror.dfr);
  read_sky_choice(fields, read.sky);
  if (json.is_object() && json.contains(sky_shadows_key))
    fields(sky_shadows_key, read.settings.shadow.sky);
  if (json.is_object() && json.contains(bounces_key))
    fields(bounces_key, read.settings.shadow.bounces);
  if (json.is_object() && json.contains(line_width_key))
    fields(line_width_key, read.settings.line_width);
  if (json.is_object() && json.contains(background_key))
    read_background(fields, read.settings.background);
  if (json.is_object() && json.contains(ground_key))
    fields.named(ground_key, ground_names, read.settings.ground);
  if (json.is_object() && json.contains(judged_tone_key))
    fields.named(judged_tone_key, tone_names, read.settings.judged_tone);
  if (json.is_object() && json.contains(shutter_key))
    fields(shutter_key, read.settings.shutter.seconds);
  if (json.is_object() && json.contains(shutter_camera_key))
    fields(shutter_camera_key, read.settings.shutter.camera);
  if (json.is_object() && json.contains(layers_key)) read_layers(fields, read.settings.layers);
  if (std::string fault = fields.fault(); !fault.empty())
    return unexpected(Error{"settings", std::move(fault)});
  if (const auto valid = validated(read.settings); !valid)
    return unexpected(Error{"settings", "settings: " + valid.error().message()});
  return read;
}

}  // namespace asos
