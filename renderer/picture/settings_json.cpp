#include "renderer/picture/settings_json.h"

#include "renderer/comparison/method.h"
#include "renderer/picture/dfr_json.h"
#include "renderer/picture/json_fields.h"
#include "renderer/picture/path_text.h"
#include "renderer/settings/names.h"
#include "renderer/settings/setting_table.h"
#include "renderer/shading/environments.h"

#include <algorithm>

namespace asos {
namespace {

void write_setting(FieldWriter& fields, const SettingRow& row, double value) {
  switch (row.kind) {
    case SettingKind::flag:
      return fields(row.key, value != 0.0);
    case SettingKind::whole:
      return fields(row.key, static_cast<int>(value));
    case SettingKind::number:
      return fields(row.key, value);
    case SettingKind::choice:
      return fields(row.key, row.text_of(value));
  }
}

template <typename T>
double read_as(FieldReader& fields, const SettingRow& row) {
  T value{};
  fields(row.key, value);
  return static_cast<double>(value);
}

double read_choice(FieldReader& fields, const SettingRow& row) {
  const OrderedJson* at = fields.take(row.key);
  if (!at) return row.usual();
  const Result<double> value =
      at->is_string() ? row.parse(at->get<std::string>()) : unexpected(Error{});
  if (!value) fields.refuse(row.key, "is none of the names that this version knows");
  return value.value_or(row.usual());
}

double read_setting(FieldReader& fields, const SettingRow& row) {
  switch (row.kind) {
    case SettingKind::flag:
      return read_as<bool>(fields, row);
    case SettingKind::whole:
      return read_as<int>(fields, row);
    case SettingKind::number:
      return read_as<double>(fields, row);
    case SettingKind::choice:
      break;
  }
  return read_choice(fields, row);
}

void write_table(FieldWriter& fields, const RenderSettings& settings, Saved saved) {
  for (const SettingRow& row : setting_table()) {
    const double value = row.get(settings);
    if (row.saved != saved) continue;
    if (saved == Saved::always || value != row.usual()) write_setting(fields, row, value);
  }
}

void read_table(FieldReader& fields, RenderSettings& settings) {
  for (const SettingRow& row : setting_table())
    if (row.saved == Saved::always || (row.saved == Saved::unless_usual && fields.has(row.key)))
      row.set(settings, read_setting(fields, row));
}

// Written only if not the default, since older pictures do not have them.
constexpr const char* sky_turn_key = "turn_deg";
constexpr const char* sky_brightness_key = "brightness";
constexpr const char* environment_key = "environment";
constexpr const char* background_key = "background";
constexpr const char* judged_tone_key = "judged_tone";
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
  fields.named("method", method_table(), settings.method);
  write_table(fields, settings, Saved::always);
  fields.other("crop", crop_json(settings.crop));
  fields.other("dfr", dfr_json(settings.mirror.dfr));
  fields.other("sky", sky_json(sky));
  write_table(fields, settings, Saved::unless_usual);
  if (settings.background != Background{})
    fields.other(background_key, background_json(settings.background));
  if (settings.judged_tone != ToneCurve::none)
    fields.named(judged_tone_key, tone_names, settings.judged_tone);
  if (settings.shutter.blurs() && settings.shutter.camera >= 0)
    fields(shutter_camera_key, settings.shutter.camera);
  if (!settings.layers.empty()) fields(layers_key, text_of(settings.layers));
  return fields.take();
}

Result<DescribedSettings> settings_from_json(const OrderedJson& json) {
  DescribedSettings read;
  FieldReader fields(json, "settings");
  fields.named("method", method_table(), read.settings.method);
  read_table(fields, read.settings);
  read_crop(fields, read.settings.crop);
  read_dfr(fields, read.settings.mirror.dfr);
  read_sky_choice(fields, read.sky);
  if (fields.has(background_key)) read_background(fields, read.settings.background);
  if (fields.has(judged_tone_key))
    fields.named(judged_tone_key, tone_names, read.settings.judged_tone);
  if (fields.has(shutter_camera_key)) fields(shutter_camera_key, read.settings.shutter.camera);
  if (fields.has(layers_key)) read_layers(fields, read.settings.layers);
  if (std::string fault = fields.fault(); !fault.empty())
    return unexpected(Error{"settings", std::move(fault)});
  if (const auto valid = validated(read.settings); !valid)
    return unexpected(Error{"settings", "settings: " + valid.error().message()});
  return read;
}

}  // namespace asos
