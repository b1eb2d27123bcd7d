#include "renderer/scene/scene_warnings.h"

#include "renderer/files/printable.h"

#include <algorithm>
#include <array>

namespace asos {
namespace {

struct Lack {
  std::string_view extension;
  std::string_view instead;  ///< appearance without it
};

constexpr std::array<Lack, 22> lacks{{
    {"KHR_materials_volume_scatter", "light does not spread inside of bodies"},
    {"KHR_texture_basisu", "textures that are only KTX2 are missing"},
    {"EXT_texture_avif", "textures that are only AVIF are missing"},
    {"MSFT_texture_dds", "textures that are only DDS are missing"},
    {"EXT_lights_ies", "lights with a measured profile are missing"},
    {"KHR_gaussian_splatting", "splats are missing"},
    {"KHR_audio_emitter", "sounds are not played"},
    {"KHR_interactivity", "nothing reacts to a person"},
    {"KHR_xmp_json_ld", "it says nothing of how things look"},
    {"KHR_physics_rigid_bodies", "nothing falls or collides"},
    {"EXT_mesh_manifold", "it says nothing of how things look"},
    {"EXT_primitive_voxels", "voxels are missing"},
    {"MSFT_screencoverage", "the finest level of detail is drawn, however far away"},
    {"KHR_node_hoverability", "nothing reacts to a person"},
    {"KHR_node_selectability", "nothing reacts to a person"},
    {"CESIUM_primitive_outline", "edges are not drawn as lines"},
    {"EXT_mesh_primitive_edge_visibility", "edges are not drawn as lines"},
    {"EXT_texture_astc", "textures that are only ASTC are missing"},
    {"MPEG_texture_video", "videos stand still or are missing"},
    {"ADOBE_materials_clearcoat_tint", "coats have no colour"},
    {"ADOBE_materials_clearcoat_specular", "coats reflect as if of an index of 1.5"},
    {"ADOBE_materials_thin_transparency", "clear walls are as the rest of the material says"},
}};

}  // namespace

std::vector<std::string> scene_warnings(const SceneNotes& notes) {
  std::vector<std::string> lines;
  for (const std::string& warning : notes.warnings) lines.push_back(printable(warning));
  for (const std::string& extension : notes.unsupported_extensions)
    lines.push_back(unsupported_line(extension));
  for (const std::string& line : notes.not_shown) lines.push_back(printable(line));
  return lines;
}

std::uint64_t count_warnings(const SceneNotes& notes) {
  // The last warning contains the number of the dropped ones.
  const std::uint64_t more = notes.warnings_dropped > 0 ? notes.warnings_dropped - 1 : 0;
  return scene_warnings(notes).size() + more;
}

std::string_view seen_without(std::string_view extension) {
  const auto* found = std::find_if(lacks.begin(), lacks.end(),
                                   [&](const Lack& lack) { return lack.extension == extension; });
  return found != lacks.end() ? found->instead : std::string_view();
}

std::string unsupported_line(std::string_view extension) {
  std::string line = "not supported: " + printable(extension);
  if (const auto instead = seen_without(extension); !instead.empty())
    line += " (" + std::string(instead) + ")";
  return line;
}

}  // namespace asos
