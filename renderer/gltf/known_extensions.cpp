#include "renderer/gltf/known_extensions.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace asos::gltf {

namespace {

/// The kinds of objects that an extension may extend: the place without the numbers of entries.
/// `textures_of_materials` is any reference to a texture in a material, at any depth.
enum class Place {
  root,
  scenes,
  nodes,
  materials,
  textures_of_materials,
  textures,
  primitives,
  buffers,
  buffer_views,
  targets
};

struct Known {
  std::string_view name;
  std::array<Place, 2> places;
};

constexpr Known at(std::string_view name, Place place) {
  return {name, {place, place}};
}

constexpr auto known = std::to_array<Known>({
    {"KHR_lights_punctual", {Place::root, Place::nodes}},
    {"EXT_lights_area", {Place::root, Place::nodes}},
    {"KHR_lights_area", {Place::root, Place::nodes}},
    {"EXT_lights_image_based", {Place::root, Place::scenes}},
    at("KHR_implicit_shapes", Place::root),
    at("ASOS_implicit_shape", Place::nodes),
    at("EXT_mesh_gpu_instancing", Place::nodes),
    at("KHR_node_visibility", Place::nodes),
    {"MSFT_lod", {Place::nodes, Place::materials}},
    at("KHR_animation_pointer", Place::targets),
    at("KHR_mesh_quantization", Place::root),
    // Says which triangles were polygons, which nothing here asks.
    at("FB_ngon_encoding", Place::primitives),
    at("KHR_draco_mesh_compression", Place::primitives),
    {"EXT_meshopt_compression", {Place::buffers, Place::buffer_views}},
    {"KHR_meshopt_compression", {Place::buffers, Place::buffer_views}},
    at("EXT_texture_webp", Place::textures),
    at("KHR_texture_transform", Place::textures_of_materials),
    {"KHR_materials_variants", {Place::root, Place::primitives}},
    at("KHR_materials_unlit", Place::materials),
    at("KHR_materials_ior", Place::materials),
    at("KHR_materials_emissive_strength", Place::materials),
    at("KHR_materials_transmission", Place::materials),
    at("KHR_materials_specular", Place::materials),
    at("KHR_materials_pbrSpecularGlossiness", Place::materials),
    at("KHR_materials_clearcoat", Place::materials),
    at("KHR_materials_sheen", Place::materials),
    at("KHR_materials_iridescence", Place::materials),
    at("KHR_materials_anisotropy", Place::materials),
    at("KHR_materials_volume", Place::materials),
    at("KHR_materials_dispersion", Place::materials),
    at("KHR_materials_diffuse_transmission", Place::materials),
});

const Known* find(std::string_view name) {
  const auto* found =
      std::find_if(known.begin(), known.end(), [&](const Known& k) { return k.name == name; });
  return found == known.end() ? nullptr : found;
}

/// `shape` is from without_numbers.
bool is_at(std::string_view shape, Place place) {
  switch (place) {
    case Place::root:
      return shape == "/";
    case Place::scenes:
      return shape == "/scenes";
    case Place::nodes:
      return shape == "/nodes";
    case Place::materials:
      return shape == "/materials";
    case Place::textures_of_materials:
      return shape.starts_with("/materials/");
    case Place::textures:
      return shape == "/textures";
    case Place::primitives:
      return shape == "/meshes/primitives";
    case Place::buffers:
      return shape == "/buffers";
    case Place::buffer_views:
      return shape == "/bufferViews";
    case Place::targets:
      return shape == "/animations/channels/target";
  }
  return false;
}

}  // namespace

bool supports_extension(std::string_view name) {
  return find(name) != nullptr;
}

bool belongs_at(std::string_view extension, std::string_view place) {
  const Known* const named = find(extension);
  if (!named) return false;
  const std::string shape = without_numbers(place);
  return std::any_of(named->places.begin(), named->places.end(),
                     [&](Place allowed) { return is_at(shape, allowed); });
}

std::string without_numbers(std::string_view place) {
  if (place.empty()) return "/";
  std::string kept;
  while (!place.empty()) {
    const std::size_t end = std::min(place.find('/', 1), place.size());
    const std::string_view step = place.substr(0, end);
    const bool number = step.size() > 1 && std::all_of(step.begin() + 1, step.end(),
                                                       [](char c) { return c >= '0' && c <= '9'; });
    if (!number) kept += step;
    place.remove_prefix(end);
  }
  return kept;
}

}  // namespace asos::gltf
