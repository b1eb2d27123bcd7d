#include "renderer/gltf/tidy_lights.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace asos::gltf {

using nlohmann::json;

namespace {

// The extras of lights and their nodes (LIGHTS.md).
constexpr std::array<std::string_view, 5> light_extras = {"casts_shadows", "two_sided", "radius",
                                                          "asos_off_intensity", "angular_diameter"};
constexpr std::array<std::string_view, 5> node_extras = {
    "asos_light", "asos_light_fallback", "asos_shape", "radius", "angular_diameter"};
constexpr std::array<std::string_view, 1> material_extras = {"asos_dfr"};  // MATERIALS.md
constexpr std::array<std::string_view, 1> camera_extras = {"asos_lens"};   // lens.md
constexpr std::array<std::string_view, 1> scene_extras = {"asos_default_lighting"};
constexpr std::array<std::string_view, 3> light_extensions = {"KHR_lights_punctual",
                                                              "EXT_lights_area", "KHR_lights_area"};

/// Writes whole numbers as real ones, at any depth, since tinygltf truncates whole numbers to 32
/// bits.
void make_real(json& value) {
  if (value.is_number_integer()) value = value.get<double>();
  if (!value.is_structured()) return;
  for (json& member : value) make_real(member);
}

/// Returns whether `place` is that of an element of `list`, and not of something inside one.
bool is_entry(std::string_view place, std::string_view list) {
  return place.starts_with(list) && place.find('/', list.size()) == std::string_view::npos;
}

}  // namespace

bool is_one_of(std::string_view name, std::span<const std::string_view> names) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

void tidy_extras(json& object, const std::string& place) {
  const auto extras = object.find("extras");
  if (extras == object.end()) return;
  const bool node = is_entry(place, "/nodes/");
  const bool light = std::any_of(
      light_extensions.begin(), light_extensions.end(), [&place](std::string_view name) {
        return is_entry(place, fmt::format("/extensions/{}/lights/", name));
      });
  std::span<const std::string_view> names;
  if (node) names = node_extras;
  if (light) names = light_extras;
  if (is_entry(place, "/materials/")) names = material_extras;
  if (is_entry(place, "/cameras/")) names = camera_extras;
  // A file without scenes has the scene's extras itself.
  if (place.empty() || is_entry(place, "/scenes/")) names = scene_extras;
  json kept = json::object();
  for (auto it = extras->begin(); extras->is_object() && it != extras->end(); ++it) {
    if (!is_one_of(it.key(), names)) continue;
    make_real(it.value());
    kept[it.key()] = it.value();
  }
  if (kept.empty()) {
    object.erase(extras);
  } else {
    *extras = std::move(kept);
  }
}

void tidy_area_lights(json& root) {
  for (const char* name : {"EXT_lights_area", "KHR_lights_area"}) {
    const json::json_pointer place(fmt::format("/extensions/{}/lights", name));
    if (root.contains(place)) make_real(root[place]);
  }
  const json::json_pointer shapes("/extensions/KHR_implicit_shapes/shapes");
  if (root.contains(shapes)) make_real(root[shapes]);
}

}  // namespace asos::gltf
