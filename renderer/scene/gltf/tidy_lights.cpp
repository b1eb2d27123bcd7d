#include "renderer/scene/gltf/tidy_lights.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace asos::gltf {

using nlohmann::json;

namespace {

// What lights and their nodes may say in extras (LIGHTS.md).
constexpr std::array<std::string_view, 4> light_extras = {"casts_shadows", "two_sided", "radius",
                                                          "angular_diameter"};
constexpr std::array<std::string_view, 4> node_extras = {"asos_light", "asos_light_fallback",
                                                         "radius", "angular_diameter"};
constexpr std::array<std::string_view, 3> light_extensions = {"KHR_lights_punctual",
                                                              "EXT_lights_area", "KHR_lights_area"};

template <std::size_t N>
bool is_one_of(std::string_view name, const std::array<std::string_view, N>& names) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

/// Writes whole numbers as real ones, at any depth: tinygltf cuts them off at 32 bits.
void make_real(json& value) {
  if (value.is_number_integer()) value = value.get<double>();
  if (!value.is_structured()) return;
  for (json& member : value) make_real(member);
}

/// Whether `place` is that of an element of `list`, and not of something within one.
bool is_entry(std::string_view place, std::string_view list) {
  return place.starts_with(list) && place.find('/', list.size()) == std::string_view::npos;
}

}  // namespace

bool is_light_extension(std::string_view name) {
  return is_one_of(name, light_extensions);
}

void tidy_extras(json& object, const std::string& place) {
  const auto extras = object.find("extras");
  if (extras == object.end()) return;
  const bool node = is_entry(place, "/nodes/");
  const bool light = std::any_of(
      light_extensions.begin(), light_extensions.end(), [&place](std::string_view name) {
        return is_entry(place, fmt::format("/extensions/{}/lights/", name));
      });
  json kept = json::object();
  for (auto it = extras->begin(); (node || light) && extras->is_object() && it != extras->end();
       ++it) {
    if (!is_one_of(it.key(), node ? node_extras : light_extras)) continue;
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
}

}  // namespace asos::gltf
