#include "renderer/picture/picture_description.h"

#include "renderer/files/printable.h"
#include "renderer/geometry/coordinates.h"
#include "renderer/geometry/validate_camera.h"
#include "renderer/lights/prepared_light.h"
#include "renderer/picture/dfr_json.h"
#include "renderer/picture/json_fields.h"
#include "renderer/picture/light_json.h"
#include "renderer/picture/path_text.h"
#include "renderer/picture/settings_json.h"
#include "renderer/prepared/environment_lights.h"
#include "renderer/scene/posable_scene.h"
#include "renderer/settings/names.h"
#include "renderer/shading/sky.h"
#include "renderer/world/ground.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <utility>

namespace asos {
namespace {

constexpr std::array camera_type_names{
    Named<Camera::Type>{"perspective", Camera::Type::perspective},
    Named<Camera::Type>{"orthographic", Camera::Type::orthographic},
};
constexpr const char* near_key = "near_depth";
constexpr const char* far_key = "far_depth";
constexpr const char* lens_key = "lens";
constexpr const char* focus_key = "focus";
constexpr std::array axis_names{"right", "up", "back", "eye"};

std::string absolute_source(const std::string& source) {
  if (source.starts_with("builtin:")) return source;
  std::error_code error;
  const std::filesystem::path path = std::filesystem::absolute(source, error);
  return error ? source : path.lexically_normal().string();
}

template <typename Fields, typename LensValues>
void each_lens_value(Fields& fields, LensValues& lens) {
  fields("radius", lens.radius);
  fields("blades", lens.blades);
  fields("turn_rad", lens.turn_rad);
}

OrderedJson lens_json(const Lens& lens) {
  FieldWriter fields;
  each_lens_value(fields, lens);
  if (lens.focus) fields(focus_key, *lens.focus);
  return fields.take();
}

std::string read_lens(const OrderedJson& json, Lens& lens) {
  FieldReader fields(json, "camera: lens");
  each_lens_value(fields, lens);
  if (fields.has(focus_key)) fields(focus_key, lens.focus.emplace());
  return fields.fault();
}

OrderedJson camera_json(const Camera& camera) {
  FieldWriter fields;
  fields("name", camera.name);
  fields.named("type", camera_type_names, camera.type);
  for (int i = 0; i < 4; ++i)
    fields(axis_names[static_cast<std::size_t>(i)], glm::dvec3(camera.world_from_camera[i]));
  fields("fov_y_rad", camera.fov_y_rad);
  fields("height", camera.height);
  // Write near and far plane only if they exist, since many cameras have none.
  if (camera.near_depth) fields(near_key, *camera.near_depth);
  if (camera.far_depth) fields(far_key, *camera.far_depth);
  if (camera.lens.blurs()) fields.other(lens_key, lens_json(camera.lens));
  return fields.take();
}

std::string read_camera(const OrderedJson& json, Camera& camera) {
  FieldReader fields(json, "camera");
  fields("name", camera.name);
  fields.named("type", camera_type_names, camera.type);
  for (int i = 0; i < 4; ++i) {
    glm::dvec3 column(0.0);
    fields(axis_names[static_cast<std::size_t>(i)], column);
    camera.world_from_camera[i] = glm::dvec4(column, i == 3 ? 1.0 : 0.0);
  }
  fields("fov_y_rad", camera.fov_y_rad);
  fields("height", camera.height);
  if (fields.has(near_key)) fields(near_key, camera.near_depth.emplace());
  if (fields.has(far_key)) fields(far_key, camera.far_depth.emplace());
  if (fields.has(lens_key))
    if (const OrderedJson* at = fields.take(lens_key))
      if (std::string fault = read_lens(*at, camera.lens); !fault.empty()) return fault;
  if (std::string fault = fields.fault(); !fault.empty()) return fault;
  const std::string fault = validate_camera(camera);
  return fault.empty() ? fault : "camera: " + fault;
}

// Written only for a picture at a time of an animation.
constexpr const char* time_key = "animation";

OrderedJson time_json(const ClipTime& time) {
  FieldWriter fields;
  fields("number", time.animation);
  fields("seconds", time.seconds);
  return fields.take();
}

std::string read_time(const OrderedJson& json, ClipTime& time) {
  FieldReader fields(json, time_key);
  fields("number", time.animation);
  fields("seconds", time.seconds);
  if (time.animation < 0) fields.refuse("number", "is below 0");
  if (time.seconds < 0.0) fields.refuse("seconds", "is below 0");
  return fields.fault();
}

// Written only if there is a curve, so that older pictures can be read.
constexpr const char* tone_key = "tone";

// Written only if not the default, for the same reason.
constexpr const char* variant_key = "variant";
constexpr const char* scene_number_key = "scene_number";

template <typename Fields, typename Display>
void each_display_value(Fields& fields, Display& display) {
  fields("exposure_ev", display.exposure_ev);
  fields("split_map", display.split_map);
  fields.named("split_colours", split_map_names, display.split_colours);
  fields("split_dimming", display.split_dimming);
}

/// Reads the fields of the whole description. Returns the first fault.
std::string read_fields(FieldReader& fields, bool moves, PictureDescription& read) {
  fields("scene", read.scene);
  read.scene = path_of_text(read.scene);
  if (fields.has(variant_key)) fields(variant_key, read.variant);
  if (fields.has(scene_number_key)) {
    fields(scene_number_key, read.scene_number);
    if (read.scene_number < 0) fields.refuse(scene_number_key, "is below 0");
  }
  fields("origin", read.origin);
  fields.named("needs", needs_names, read.render_features);
  if (const OrderedJson* at = fields.take("camera"))
    if (std::string fault = read_camera(*at, read.camera); !fault.empty()) return fault;
  if (const OrderedJson* at = fields.take("settings")) {
    auto settings = settings_from_json(*at);
    if (!settings) return settings.error().reason;
    read.settings = std::move(settings->settings);
    read.sky = std::move(settings->sky);
  }
  if (const OrderedJson* at = fields.take("lights"); at && !at->is_null()) {
    auto lights = lights_from_json(*at);
    if (!lights) return lights.error().reason;
    for (const Light& light : *lights)
      if (!traits_of(light_shape(light)).infinite && !within_reach(light.position))
        return fmt::format("light '{}' is farther away than {:g}", light.name, largest_coordinate);
    read.lights = *std::move(lights);
  }
  if (const OrderedJson* at = fields.take("dfrs"); at && !at->is_null()) {
    auto dfrs = dfrs_from_json(*at);
    if (!dfrs) return dfrs.error().reason;
    read.dfrs = *std::move(dfrs);
  }
  if (const OrderedJson* at = fields.take("display")) {
    FieldReader display(*at, "display");
    each_display_value(display, read.display);
    if (at->is_object() && at->contains(tone_key))
      display.named(tone_key, tone_names, read.display.tone);
    if (std::string fault = display.fault(); !fault.empty()) return fault;
  }
  if (const OrderedJson* at = moves ? fields.take(time_key) : nullptr)
    if (std::string fault = read_time(*at, read.time.emplace()); !fault.empty()) return fault;
  return fields.fault();
}

/// If `file` does not exist, uses the file of the same name in `folder` and returns a warning.
std::string look_beside(const std::filesystem::path& folder, std::string& file) {
  if (file.empty() || file.starts_with("builtin:")) return {};
  std::error_code error;
  if (std::filesystem::exists(file, error)) return {};
  const std::filesystem::path beside = folder / std::filesystem::path(file).filename();
  if (!std::filesystem::is_regular_file(beside, error)) return {};
  std::string remark = fmt::format("'{}' is gone; '{}' beside the picture is used", printable(file),
                                   printable(beside.filename().string()));
  file = absolute_source(beside.string());
  return remark;
}

}  // namespace

LoadOptions PictureDescription::load_options() const {
  return {.keep_posable = time.has_value(),
          .variant = variant,
          .scene = scene_number < 0 ? std::string() : std::to_string(scene_number)};
}

Camera PictureDescription::camera_from(glm::dvec3 other_origin) const {
  Camera moved = camera;
  moved.world_from_camera[3] += glm::dvec4(origin - other_origin, 0.0);
  return moved;
}

std::vector<Light> PictureDescription::lights_from(glm::dvec3 other_origin) const {
  std::vector<Light> moved = lights.value_or(std::vector<Light>{});
  for (Light& light : moved) {
    light.position += origin - other_origin;
    for (auto& outline : light.outlines)
      for (glm::dvec3& p : outline) p += origin - other_origin;
  }
  return moved;
}

PictureDescription describe(const RenderScene& scene, const Camera& camera,
                            const RenderSettings& settings, const PictureDisplay& display) {
  PictureDescription description;
  description.scene = absolute_source(scene.geometry->source);
  description.variant = scene.geometry->contents.variant;
  if (const SceneContents& contents = scene.geometry->contents;
      contents.shown_scene != contents.default_scene)
    description.scene_number = contents.shown_scene;
  description.origin = scene.world().origin;
  description.camera = camera;
  description.settings = settings;
  description.sky = choice_of(settings.sky.get());
  if (!description.sky.file.empty()) description.sky.file = absolute_source(description.sky.file);
  description.render_features =
      scene.forced == RenderFeatures{} ? FeatureChoice::scene : FeatureChoice::all;
  if (scene.lighting != scene.own_lighting) description.lights = scene.lights();
  MaterialDfrs dfrs = scene.dfrs();
  dfrs.resize(materials_without_ground(scene.world()));
  if (dfrs != dfrs_without_ground(scene.world())) description.dfrs = std::move(dfrs);
  description.time = scene.geometry->time;
  description.display = display;
  return description;
}

std::string description_text(const PictureDescription& description) {
  FieldWriter fields;
  fields("format", PictureDescription::format);
  fields("scene", text_of_path(description.scene));
  if (!description.variant.empty()) fields(variant_key, description.variant);
  if (description.scene_number >= 0) fields(scene_number_key, description.scene_number);
  fields("origin", description.origin);
  fields.named("needs", needs_names, description.render_features);
  fields.other("camera", camera_json(description.camera));
  fields.other("settings", settings_json(description.settings, description.sky));
  fields.other("lights",
               description.lights ? lights_json(*description.lights) : OrderedJson(nullptr));
  fields.other("dfrs", description.dfrs ? dfrs_json(*description.dfrs) : OrderedJson(nullptr));
  if (description.time) fields.other(time_key, time_json(*description.time));
  FieldWriter display;
  each_display_value(display, description.display);
  if (description.display.tone != ToneCurve::none)
    display.named(tone_key, tone_names, description.display.tone);
  fields.other("display", display.take());
  return fields.take().dump(-1, ' ', false, OrderedJson::error_handler_t::replace);
}

Result<PictureDescription> parse_description(const std::string& text, const std::string& file) {
  const auto fail = [&](const std::string& reason) { return unexpected(Error{file, reason}); };
  const OrderedJson json = OrderedJson::parse(text, nullptr, false);
  if (!json.is_object())
    return fail("what it says of its picture is damaged: it is no JSON object");
  FieldReader fields(json, "the description");
  int format = 0;
  fields("format", format);
  if (format > PictureDescription::format)
    return fail(
        fmt::format("its settings are of format {}, from a newer version of the program; "
                    "this one reads {}",
                    format, PictureDescription::format));
  PictureDescription read;
  std::string fault = read_fields(fields, json.contains(time_key), read);
  if (fault.empty() && format != PictureDescription::format)
    fault = fmt::format("there is no format {}", format);
  if (!fault.empty()) return fail("what it says of its picture is damaged: " + fault);
  return read;
}

Result<PictureDescription> read_description(const std::string& path) {
  const Result<ImageText> text = read_image_text(path);
  if (!text) return unexpected(text.error());
  const auto found = std::find_if(text->begin(), text->end(), [](const auto& entry) {
    return entry.first == PictureDescription::key;
  });
  if (found == text->end())
    return unexpected(Error{path,
                            "holds no settings: this program did not save it, or another one "
                            "left them out when it saved it again"});
  auto read = parse_description(found->second, path);
  if (!read) return read;
  const std::filesystem::path folder = std::filesystem::path(path).parent_path();
  for (std::string* file : {&read->scene, &read->sky.file})
    if (std::string remark = look_beside(folder, *file); !remark.empty())
      read->found_beside.push_back(std::move(remark));
  return read;
}

Error scene_of_picture_error(const std::string& file, const Error& error) {
  return {file, "the scene that it shows cannot be opened: " + error.message()};
}

Result<std::shared_ptr<const RenderScene>> prepare(const Scene& scene,
                                                   const PictureDescription& description) {
  const ChooseGround choose = [&](const World&, bool) {
    return GroundChoice{description.settings.ground};
  };
  if (!description.time) return prepare_posed(scene, description, nullptr, choose);
  if (!scene.rig)
    return unexpected(Error{scene.source, "has no animations, so there is no such time of it"});
  const auto at_rest = prepare(scene, forced_by(description.render_features));
  if (!at_rest) return unexpected(at_rest.error());
  const Result<Scene> posed = scene.rig->pose(description.time);
  if (!posed) return unexpected(posed.error());
  return prepare_posed(*posed, description, &(*at_rest)->geometry->stage, choose);
}

Result<std::shared_ptr<const RenderScene>> prepare_posed(const Scene& scene,
                                                         const PictureDescription& description,
                                                         const AnimationInvariants* stage,
                                                         const ChooseGround& choose) {
  auto prepared = prepare_on_ground(scene, forced_by(description.render_features), stage, choose);
  if (!prepared) return prepared;
  if (description.lights)
    prepared = with_lights(*prepared, description.lights_from((*prepared)->world().origin));
  else
    prepared = lit_under(*prepared, description.settings.sky.get());
  if (prepared && description.dfrs) prepared = with_dfrs(*prepared, *description.dfrs);
  return std::move(prepared).map_error([&](const Error& error) {
    return Error{scene.source, "is not the scene that the picture was made of: " + error.message()};
  });
}

}  // namespace asos
