#include "renderer/world/render_features.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>

namespace asos {

namespace {

using Needs = RenderFeatures;

constexpr std::array features{
    RenderFeature{&Needs::textures, "textures", "no material that is shown has a texture",
                  "texture lookups", "texture coordinates", "", ""},
    RenderFeature{&Needs::mip_chains, "mip chains", "no texture is larger than one texel",
                  "means of textures over footprints", "mip chains", "", ""},
    RenderFeature{&Needs::unused_images, "unused images", "no material that is shown names them",
                  "", "their texels", "", ""},
    RenderFeature{&Needs::normal_maps, "normal maps", "no material that is shown has a normal map",
                  "turning of normals by maps", "tangents, normal maps' mip chains", "", ""},
    RenderFeature{&Needs::vertex_colors, "vertex colours",
                  "no vertex has a colour other than white", "multiplication by vertex colours",
                  "vertices' colours", "", ""},
    RenderFeature{&Needs::alpha_mask, "alpha cut-outs",
                  "no material that is shown cuts by its alpha",
                  "test of opacity where rays meet surfaces", "", "", ""},
    RenderFeature{&Needs::alpha_blend, "alpha blending and transmission",
                  "no material that is shown lets light through",
                  "layers behind a surface, attenuation of shadow rays", "", "", ""},
    RenderFeature{&Needs::varying_opacity, "varying opacity",
                  "the opacity is the same all over each surface",
                  "samples of shadows for what differs between outlines", "", "", ""},
    RenderFeature{&Needs::culling, "culling of backs",
                  "every material that is shown is double-sided",
                  "test of eye rays' hits for backs", "", "", ""},
    RenderFeature{&Needs::metals, "metals", "no material that is shown is metallic",
                  "reflectance from the base colour", "", "", ""},
    RenderFeature{
        &Needs::mirrors, "mirrors",
        "no material that is shown is smooth enough, bounds a volume, or has defocusing ratios "
        "of its own",
        "mirrored pyrays and rays, lights that only mirrors show", "", "", "Reflection rays"},
    RenderFeature{&Needs::shapes, "analytic shapes", "no object that is shown is one",
                  "faces among the rays' triangles, their contours and sections", "faces", "", ""},
    RenderFeature{&Needs::emission, "emissive materials", "no material that is shown shines",
                  "emission, search for surfaces that light the scene", "emission's mip chains", "",
                  "emissive"},
    RenderFeature{&Needs::punctual_lights, "punctual lights",
                  "no light is a point, a spot or a direction without size", "hard shadows", "", "",
                  ""},
    RenderFeature{&Needs::rectangle_lights, "rectangular and polygonal lights",
                  "no light is a rectangle or a polygon", "their irradiance and shadows", "", "",
                  "rectangle, polygon"},
    RenderFeature{&Needs::disk_lights, "disk lights", "no light is a disk",
                  "their irradiance and shadows", "", "", "disk"},
    RenderFeature{&Needs::ball_lights, "ball lights", "no point or spot light has a radius",
                  "their irradiance and shadows", "", "", ""},
    RenderFeature{&Needs::linear_lights, "linear lights", "no light is a line",
                  "their irradiance and shadows", "", "", "linear"},
    RenderFeature{&Needs::suns, "suns", "no directional light has an angular diameter",
                  "their irradiance and shadows", "", "", ""},
    RenderFeature{&Needs::shadows, "shadows", "no light casts shadows", "shadow rays and pyrays",
                  "", "Shadows", "Shadow rays"},
    RenderFeature{&Needs::soft_shadows, "soft shadows", "no light of some size casts shadows",
                  "pyrays to lights, refinement of penumbrae", "", "Quality, Divisions", ""},
    RenderFeature{&Needs::boundaries, "edges", "only methods that cut pixels along edges need them",
                  "search for edges", "edges and their hierarchy", "", ""},
    RenderFeature{&Needs::intersections, "intersections", "no surfaces pass through each other", "",
                  "lines of intersection", "", "crossing"},
    RenderFeature{&Needs::sky_picture, "sky picture", "no picture surrounds the scene (--sky)",
                  "means of a picture over directions", "the picture and its means", "", ""},
};
static_assert(features.size() == sizeof(RenderFeatures) / sizeof(bool), "a member has no words");

bool emits(const Material& m) {
  return m.emissive_strength > 0.0f && std::max({m.emissive.x, m.emissive.y, m.emissive.z}) > 0.0f;
}

/// Returns whether a material may be a mirror. A texture may make it smooth anywhere. A material
/// without reflection is no mirror.
bool may_mirror(const Material& m, const std::optional<Dfr>& dfr) {
  const bool reflects = m.metallic > 0.0f || m.specular > 0.0f || m.film.used();
  const bool smooth = static_cast<double>(m.roughness) <= usual_roughest_mirror ||
                      m.metallic_roughness_texture.used() || dfr;
  const bool smooth_coat =
      m.coat.factor > 0.0f && (static_cast<double>(m.coat.roughness) <= usual_roughest_mirror ||
                               m.coat.roughness_texture.used() || dfr);
  return (reflects && smooth) || smooth_coat;
}

/// Returns the indices of visible materials. Files often contain unused ones.
std::vector<std::size_t> shown_materials(const World& world) {
  std::vector<bool> seen(world.materials.size(), false);
  std::vector<std::size_t> shown;
  for (const Part& part : world.parts) {
    if (part.shows_nothing() || seen[part.material]) continue;
    seen[part.material] = true;
    shown.push_back(part.material);
  }
  return shown;
}

std::vector<bool> images_of_shown_materials(const World& world) {
  std::vector<bool> used(world.images.size(), false);
  for (const std::size_t material : shown_materials(world)) {
    // Includes unused textures, since all of them affect whether surfaces differ.
    for (const TextureUse* use : texture_uses(world.materials[material])) {
      if (!use->used() || static_cast<std::size_t>(use->texture) >= world.textures.size()) continue;
      const int image = world.textures[static_cast<std::size_t>(use->texture)].image;
      if (image >= 0 && static_cast<std::size_t>(image) < used.size())
        used[static_cast<std::size_t>(image)] = true;
    }
  }
  return used;
}

void add_material(RenderFeatures& render_features, const Material& m) {
  render_features.textures |= m.base_color_texture.used();
  render_features.textures |= m.transmission > 0.0f && m.transmission_texture.used();
  render_features.alpha_blend |= m.alpha_mode == AlphaMode::blend || m.transmission > 0.0f;
  render_features.alpha_mask |= m.alpha_mode == AlphaMode::mask;
  render_features.culling |= !shows_both_sides(m);
  if (m.unlit) {  // uses only its base colour; lines and points also emission
    render_features.emission |= m.stroke && emits(m);
    render_features.textures |= m.stroke && emits(m) && m.emissive_texture.used();
    return;
  }
  render_features.textures |= m.metallic_roughness_texture.used() || m.normal_texture.used() ||
                              m.occlusion_texture.used() || m.specular_texture.used() ||
                              m.specular_color_texture.used() ||
                              (m.emissive_texture.used() && emits(m));
  render_features.textures |= m.film.texture.used() || m.film.thickness_texture.used();
  render_features.textures |= m.anisotropy.texture.used();
  render_features.textures |=
      m.diffuse_transmission.texture.used() || m.diffuse_transmission.color_texture.used();
  render_features.textures |= m.sheen.color_texture.used() || m.sheen.roughness_texture.used();
  render_features.textures |=
      m.coat.texture.used() || m.coat.roughness_texture.used() || m.coat.normal_texture.used();
  render_features.normal_maps |= has_normal_map(m);
  render_features.emission |= emits(m);
  render_features.metals |= m.metallic > 0.0f;
}

/// Returns whether the colours' alpha differs within a part.
bool alpha_differs(const World& world, const Part& part) {
  if (world.colors.empty() || part.vertex_count == 0) return false;
  const float a = world.colors[part.first_vertex].a;
  for (std::uint32_t i = 1; i < part.vertex_count; ++i)
    if (world.colors[part.first_vertex + i].a != a) return true;
  return false;
}

std::string joined(std::initializer_list<std::pair<const char*, const char*>> labelled) {
  std::string text;
  for (const auto& [label, words] : labelled) {
    if (*words != '\0') text += std::string("; ") + label + ": " + words;
  }
  return text;
}

}  // namespace

RenderFeatures RenderFeatures::all() {
  RenderFeatures render_features;
  for (const RenderFeature& feature : features) render_features.*feature.needed = true;
  render_features.varying_opacity = false;
  render_features.sky_picture = false;
  return render_features;
}

RenderFeatures RenderFeatures::with(const RenderFeatures& other) const {
  RenderFeatures both = *this;
  for (const RenderFeature& feature : features)
    both.*feature.needed = both.*feature.needed || other.*feature.needed;
  return both;
}

std::vector<std::string> RenderFeatures::left_out() const {
  std::vector<std::string> sentences;
  for (const RenderFeature& f : features_left_out(*this)) {
    sentences.push_back(std::string(f.name) + " (" + f.reason +
                        joined({{"stages", f.stages},
                                {"memory", f.memory},
                                {"controls", f.controls},
                                {"rows", f.rows}}) +
                        ")");
  }
  return sentences;
}

std::span<const RenderFeature> render_feature_list() {
  return features;
}

std::vector<RenderFeature> features_left_out(const RenderFeatures& render_features) {
  std::vector<RenderFeature> left_out;
  for (const RenderFeature& feature : features) {
    if (!(render_features.*feature.needed)) left_out.push_back(feature);
  }
  return left_out;
}

bool opacity_varies(const World& world, const Part& part) {
  const Material& m = world.materials[part.material];
  if (part.shows_nothing()) return false;
  // Attenuation depends on the length of the way in the volume.
  if (m.transmission > 0.0f &&
      (m.base_color_texture.used() || m.transmission_texture.used() || bounds_volume(m)))
    return true;
  return m.alpha_mode != AlphaMode::opaque &&
         (m.base_color_texture.used() || alpha_differs(world, part));
}

RenderFeatures find_render_features(const World& world) {
  RenderFeatures render_features;
  for (const std::size_t shown : shown_materials(world))
    add_material(render_features, world.materials[shown]);
  render_features.mirrors = needs_mirrors(world, dfrs_of(world));
  const std::vector<bool> used = images_of_shown_materials(world);
  for (std::size_t i = 0; i < used.size(); ++i)
    render_features.mip_chains |=
        used[i] && (world.images[i].width > 1 || world.images[i].height > 1);
  render_features.mip_chains &= render_features.textures;
  render_features.unused_images = std::find(used.begin(), used.end(), false) == used.end();
  render_features.vertex_colors = !world.colors.empty();
  render_features.shapes = !world.faces.empty();
  render_features.varying_opacity =
      std::any_of(world.parts.begin(), world.parts.end(),
                  [&](const Part& part) { return opacity_varies(world, part); });
  render_features.boundaries = true;
  render_features.intersections = true;
  return render_features;
}

bool needs_mirrors(const World& world, const MaterialDfrs& dfrs) {
  const std::vector<std::size_t> shown = shown_materials(world);
  return std::any_of(shown.begin(), shown.end(), [&](std::size_t i) {
    const Material& m = world.materials[i];
    return !m.unlit && (may_mirror(m, dfrs[i]) || bounds_volume(m) || is_frosted(m));
  });
}

void release_unused_images(World& world) {
  const std::vector<bool> used = images_of_shown_materials(world);
  for (std::size_t i = 0; i < used.size(); ++i) {
    if (!used[i]) world.images[i].rgba = world.images[i].low = {};
  }
}

void fill_forced_attributes(World& world, const RenderFeatures& forced) {
  const std::size_t vertices = world.positions.own_size();
  if (forced.normal_maps && world.tangents.empty())
    world.tangents.assign(vertices, glm::vec4(0.0f));
  if (forced.vertex_colors && world.colors.empty()) world.colors.assign(vertices, glm::vec4(1.0f));
  for (auto& coordinates : world.texcoords) {
    if (forced.textures && coordinates.empty()) coordinates.assign(vertices, glm::vec2(0.0f));
  }
}

}  // namespace asos
