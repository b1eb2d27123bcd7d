#include "renderer/world/needs.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>

namespace asos {

namespace {

using Needs = SceneNeeds;

constexpr std::array features{
    SceneFeature{&Needs::textures, "textures", "no material that is shown has a texture",
                 "texture lookups", "texture coordinates", "", ""},
    SceneFeature{&Needs::mip_chains, "mip chains", "no texture is larger than one texel",
                 "means of textures over footprints", "mip chains", "", ""},
    SceneFeature{&Needs::unused_images, "unused images", "no material that is shown names them", "",
                 "their texels", "", ""},
    SceneFeature{&Needs::normal_maps, "normal maps", "no material that is shown has a normal map",
                 "turning of normals by maps", "tangents, normal maps' mip chains", "", ""},
    SceneFeature{&Needs::vertex_colors, "vertex colours", "no vertex has a colour other than white",
                 "multiplication by vertex colours", "vertices' colours", "", ""},
    SceneFeature{&Needs::alpha_mask, "alpha cut-outs",
                 "no material that is shown cuts by its alpha",
                 "test of opacity where rays meet surfaces", "", "", ""},
    SceneFeature{&Needs::alpha_blend, "alpha blending and transmission",
                 "no material that is shown lets light through",
                 "layers behind a surface, attenuation of shadow rays", "", "", ""},
    SceneFeature{&Needs::varying_opacity, "varying opacity",
                 "the opacity is the same all over each surface",
                 "samples of shadows for what differs between outlines", "", "", ""},
    SceneFeature{&Needs::culling, "culling of backs",
                 "every material that is shown is double-sided", "test of eye rays' hits for backs",
                 "", "", ""},
    SceneFeature{&Needs::metals, "metals", "no material that is shown is metallic",
                 "reflectance from the base colour", "", "", ""},
    SceneFeature{
        &Needs::mirrors, "mirrors",
        "no material that is shown is smooth enough, bounds a volume, or has defocusing ratios "
        "of its own",
        "mirrored pyrays and rays, lights that only mirrors show", "", "", "Reflection rays"},
    SceneFeature{&Needs::shapes, "analytic shapes", "no object that is shown is one",
                 "faces among the rays' triangles, their contours and sections", "faces", "", ""},
    SceneFeature{&Needs::emission, "emissive materials", "no material that is shown shines",
                 "emission, search for surfaces that light the scene", "emission's mip chains", "",
                 "emissive"},
    SceneFeature{&Needs::punctual_lights, "punctual lights",
                 "no light is a point, a spot or a direction without size", "hard shadows", "", "",
                 ""},
    SceneFeature{&Needs::rectangle_lights, "rectangular and polygonal lights",
                 "no light is a rectangle or a polygon", "their irradiance and shadows", "", "",
                 "rectangle, polygon"},
    SceneFeature{&Needs::disk_lights, "disk lights", "no light is a disk",
                 "their irradiance and shadows", "", "", "disk"},
    SceneFeature{&Needs::ball_lights, "ball lights", "no point or spot light has a radius",
                 "their irradiance and shadows", "", "", ""},
    SceneFeature{&Needs::linear_lights, "linear lights", "no light is a line",
                 "their irradiance and shadows", "", "", "linear"},
    SceneFeature{&Needs::suns, "suns", "no directional light has an angular diameter",
                 "their irradiance and shadows", "", "", ""},
    SceneFeature{&Needs::shadows, "shadows", "no light casts shadows", "shadow rays and pyrays", "",
                 "Shadows", "Shadow rays"},
    SceneFeature{&Needs::soft_shadows, "soft shadows", "no light of some size casts shadows",
                 "pyrays to lights, refinement of penumbrae", "", "Quality, Divisions", ""},
    SceneFeature{&Needs::intersections, "intersections", "no surfaces pass through each other", "",
                 "lines of intersection", "", "crossing"},
    SceneFeature{&Needs::sky_picture, "sky picture", "no picture surrounds the scene (--sky)",
                 "means of a picture over directions", "the picture and its means", "", ""},
};
static_assert(features.size() == sizeof(SceneNeeds) / sizeof(bool), "a member has no words");

bool emits(const Material& m) {
  return m.emissive_strength > 0.0f && std::max({m.emissive.x, m.emissive.y, m.emissive.z}) > 0.0f;
}

/// Returns whether a material may be a mirror. A texture may make it smooth anywhere. A material
/// without reflection is none.
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

void add_material(SceneNeeds& needs, const Material& m) {
  needs.textures |= m.base_color_texture.used();
  needs.textures |= m.transmission > 0.0f && m.transmission_texture.used();
  needs.alpha_blend |= m.alpha_mode == AlphaMode::blend || m.transmission > 0.0f;
  needs.alpha_mask |= m.alpha_mode == AlphaMode::mask;
  needs.culling |= !shows_both_sides(m);
  if (m.unlit) {  // it uses only its base colour, and strokes their emission
    needs.emission |= m.stroke && emits(m);
    needs.textures |= m.stroke && emits(m) && m.emissive_texture.used();
    return;
  }
  needs.textures |= m.metallic_roughness_texture.used() || m.normal_texture.used() ||
                    m.occlusion_texture.used() || m.specular_texture.used() ||
                    m.specular_color_texture.used() || (m.emissive_texture.used() && emits(m));
  needs.textures |= m.film.texture.used() || m.film.thickness_texture.used();
  needs.textures |= m.anisotropy.texture.used();
  needs.textures |=
      m.diffuse_transmission.texture.used() || m.diffuse_transmission.color_texture.used();
  needs.textures |= m.sheen.color_texture.used() || m.sheen.roughness_texture.used();
  needs.textures |=
      m.coat.texture.used() || m.coat.roughness_texture.used() || m.coat.normal_texture.used();
  needs.normal_maps |= has_normal_map(m);
  needs.emission |= emits(m);
  needs.metals |= m.metallic > 0.0f;
}

void add_light(SceneNeeds& needs, const Light& light) {
  bool sized = true;
  switch (light.type) {
    case Light::Type::point:
    case Light::Type::spot:
      sized = light.radius > 0.0;
      (sized ? needs.ball_lights : needs.punctual_lights) = true;
      break;
    case Light::Type::directional:
      sized = light.angular_diameter_rad > 0.0;
      (sized ? needs.suns : needs.punctual_lights) = true;
      break;
    case Light::Type::linear:
      needs.linear_lights = true;
      break;
    case Light::Type::rectangle:
    case Light::Type::polygon:
      needs.rectangle_lights = true;
      break;
    case Light::Type::disk:
      needs.disk_lights = true;
      break;
  }
  needs.shadows |= light.casts_shadows;
  needs.soft_shadows |= light.casts_shadows && sized;
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

SceneNeeds SceneNeeds::all() {
  SceneNeeds needs;
  for (const SceneFeature& feature : features) needs.*feature.needed = true;
  needs.varying_opacity = false;
  needs.sky_picture = false;
  return needs;
}

SceneNeeds SceneNeeds::with(const SceneNeeds& other) const {
  SceneNeeds both = *this;
  for (const SceneFeature& feature : features)
    both.*feature.needed = both.*feature.needed || other.*feature.needed;
  return both;
}

std::vector<std::string> SceneNeeds::left_out() const {
  std::vector<std::string> sentences;
  for (const SceneFeature& f : features_left_out(*this)) {
    sentences.push_back(std::string(f.name) + " (" + f.reason +
                        joined({{"stages", f.stages},
                                {"memory", f.memory},
                                {"controls", f.controls},
                                {"rows", f.rows}}) +
                        ")");
  }
  return sentences;
}

std::span<const SceneFeature> scene_features() {
  return features;
}

std::vector<SceneFeature> features_left_out(const SceneNeeds& needs) {
  std::vector<SceneFeature> left_out;
  for (const SceneFeature& feature : features) {
    if (!(needs.*feature.needed)) left_out.push_back(feature);
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

SceneNeeds find_needs(const World& world) {
  SceneNeeds needs;
  for (const std::size_t shown : shown_materials(world))
    add_material(needs, world.materials[shown]);
  needs.mirrors = needs_mirrors(world, dfrs_of(world));
  const std::vector<bool> used = images_of_shown_materials(world);
  for (std::size_t i = 0; i < used.size(); ++i)
    needs.mip_chains |= used[i] && (world.images[i].width > 1 || world.images[i].height > 1);
  needs.mip_chains &= needs.textures;
  needs.unused_images = std::find(used.begin(), used.end(), false) == used.end();
  needs.vertex_colors = !world.colors.empty();
  needs.shapes = !world.faces.empty();
  needs.varying_opacity =
      std::any_of(world.parts.begin(), world.parts.end(),
                  [&](const Part& part) { return opacity_varies(world, part); });
  needs.intersections = true;
  return needs;
}

SceneNeeds find_needs(std::span<const Light> lights) {
  SceneNeeds needs;
  for (const Light& light : lights) add_light(needs, light);
  return needs;
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

void fill_forced_attributes(World& world, const SceneNeeds& forced) {
  const std::size_t vertices = world.positions.own().size();
  if (forced.normal_maps && world.tangents.empty())
    world.tangents.assign(vertices, glm::vec4(0.0f));
  if (forced.vertex_colors && world.colors.empty()) world.colors.assign(vertices, glm::vec4(1.0f));
  for (auto& coordinates : world.texcoords) {
    if (forced.textures && coordinates.empty()) coordinates.assign(vertices, glm::vec2(0.0f));
  }
}

}  // namespace asos
