#include "renderer/features/surface_look.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>

namespace asos {
namespace {

// Shading normals farther apart than this (0.2 degrees) change a display intensity visibly.
constexpr float crease_cosine = 0.999994f;
constexpr float colour_step = 1.0f / 512.0f;
constexpr float texcoord_step = 1e-4f;
// Points at which an edge's two sides are compared: about one per texel.
constexpr float fewest_points = 3.0f;
constexpr float most_points = 64.0f;

bool same_texture(const World& world, const TextureUse& a, const TextureUse& b) {
  if (!a.used() || !b.used()) return a.used() == b.used();
  if (a.texcoord != b.texcoord || a.uv_transform != b.uv_transform || a.scale != b.scale)
    return false;
  if (a.texture == b.texture) return true;
  const auto count = static_cast<int>(world.textures.size());
  if (a.texture >= count || b.texture >= count) return false;
  const auto sampler = [&](const TextureUse& use) {
    const Texture& t = world.textures[static_cast<std::size_t>(use.texture)];
    return std::tuple(t.image, t.wrap_u, t.wrap_v, t.filter);
  };
  return sampler(a) == sampler(b);
}

glm::vec2 weights_of(int corner) {
  return {corner == 1 ? 1.0f : 0.0f, corner == 2 ? 1.0f : 0.0f};
}

// Returns whether `differs` holds for the two triangles' own vertices at one of the shared corners.
template <typename Differs>
bool any_corner(const World& world, std::uint32_t x, std::uint32_t y,
                std::span<const SharedCorner> corners, Differs&& differs) {
  return std::any_of(corners.begin(), corners.end(), [&](SharedCorner c) {
    const std::uint32_t a = world.triangles[x][c.first];
    const std::uint32_t b = world.triangles[y][c.second];
    return a != b && differs(a, b);
  });
}

}  // namespace

bool same_look(const World& world, const Material& a, const Material& b) {
  const auto numbers = [](const Material& m) {
    return std::tuple(
        m.film.factor, m.film.ior, m.film.thickness_min_nm, m.film.thickness_max_nm, m.base_color,
        m.metallic, m.roughness, m.emissive * m.emissive_strength, m.alpha_mode,
        m.alpha_mode == AlphaMode::mask ? m.alpha_cutoff : 0.0f, m.unlit, m.ior, m.transmission,
        m.specular, m.specular_color, m.coat.factor, m.coat.roughness, m.sheen.color,
        m.sheen.roughness, m.dfr, m.volume.thickness, m.volume.attenuation_distance,
        m.volume.attenuation_color, m.volume.dispersion, m.diffuse_transmission.factor,
        m.diffuse_transmission.color, m.anisotropy.strength, m.anisotropy.rotation_rad);
  };
  const auto textures_a = texture_uses(a), textures_b = texture_uses(b);
  return numbers(a) == numbers(b) &&
         std::equal(
             textures_a.begin(), textures_a.end(), textures_b.begin(),
             [&](const TextureUse* x, const TextureUse* y) { return same_texture(world, *x, *y); });
}

SurfaceLook::SurfaceLook(const World& world, TextureAt texture_at)
    : world_(world), texture_at_(texture_at), uses_texcoord_(world.materials.size()) {
  for (std::size_t m = 0; m < world.materials.size(); ++m) {
    const Material& material = world.materials[m];
    for (const TextureUse* use : texture_uses(material))
      if (use->used()) uses_texcoord_[m] |= static_cast<std::uint8_t>(1 << use->texcoord);
  }
}

bool SurfaceLook::seam(std::uint32_t x, std::uint32_t y, std::span<const SharedCorner> ends) const {
  const Material& a = world_.material_of(x);
  const Material& b = world_.material_of(y);
  if (&a != &b && !same_look(world_, a, b)) return true;
  return texcoords_differ(x, y, ends) && textures_differ(x, y, ends);
}

bool SurfaceLook::crease(std::uint32_t x, std::uint32_t y,
                         std::span<const SharedCorner> ends) const {
  if (!world_.material_of(x).unlit &&
      any_corner(world_, x, y, ends, [&](std::uint32_t a, std::uint32_t b) {
        // Neighbours with opposite winding may have opposite normals. Shading turns both towards
        // the viewer, so the sign does not matter.
        return !(std::abs(glm::dot(world_.normals[a], world_.normals[b])) > crease_cosine);
      }))
    return true;
  return !world_.colors.empty() &&
         any_corner(world_, x, y, ends, [&](std::uint32_t a, std::uint32_t b) {
           const glm::vec4 d = glm::abs(world_.colors[a] - world_.colors[b]);
           return std::max({d.x, d.y, d.z, d.w}) > colour_step;
         });
}

bool SurfaceLook::same(std::uint32_t x, std::uint32_t y,
                       std::span<const SharedCorner> corners) const {
  const Material& a = world_.material_of(x);
  const Material& b = world_.material_of(y);
  if (&a != &b && !same_look(world_, a, b)) return false;
  if (texcoords_differ(x, y, corners) || crease(x, y, corners)) return false;
  // The tangents, and the normals' sign, orient a normal map or a lobe.
  if (!needs_tangents(a)) return true;
  return !any_corner(world_, x, y, corners, [&](std::uint32_t i, std::uint32_t k) {
    return glm::dot(world_.normals[i], world_.normals[k]) < 0.0f ||
           (!world_.tangents.empty() && world_.tangents[i] != world_.tangents[k]);
  });
}

bool SurfaceLook::texcoords_differ(std::uint32_t x, std::uint32_t y,
                                   std::span<const SharedCorner> corners) const {
  const std::uint8_t used = uses_texcoord_[world_.parts[world_.triangle_part[x]].material];
  for (int set = 0; set < 2; ++set) {
    const auto& uv = world_.texcoords[set];
    if (!(used & (1 << set)) || uv.empty()) continue;
    if (any_corner(world_, x, y, corners, [&](std::uint32_t a, std::uint32_t b) {
          const glm::vec2 d = glm::abs(uv[a] - uv[b]);
          return !(d.x <= texcoord_step && d.y <= texcoord_step);
        }))
      return true;
  }
  return false;
}

bool SurfaceLook::textures_differ(std::uint32_t x, std::uint32_t y,
                                  std::span<const SharedCorner> ends) const {
  // The orientation of a normal map depends on the direction of the coordinates near the edge.
  const Material& material = world_.material_of(x);
  if (texture_at_ == nullptr || has_normal_map(material)) return true;
  const auto uses = texture_uses(material);
  return std::any_of(uses.begin(), uses.end(), [&](const TextureUse* use) {
    return use->used() && texture_differs(*use, x, y, ends);
  });
}

bool SurfaceLook::texture_differs(const TextureUse& use, std::uint32_t x, std::uint32_t y,
                                  std::span<const SharedCorner> ends) const {
  const glm::uvec3 s = world_.triangles[x], t = world_.triangles[y];
  const float texels =
      std::max({fewest_points, texels_along(use, s[ends[0].first], s[ends[1].first]),
                texels_along(use, t[ends[0].second], t[ends[1].second])});
  const float points = std::ceil(std::min(most_points, texels));
  const auto look = [&](std::uint32_t triangle, int from, int to, float at) {
    const glm::vec2 b = glm::mix(weights_of(from), weights_of(to), at);
    return texture_at_(world_, use, triangle, b.x, b.y);
  };
  for (float i = 0.5f; i < points; i += 1.0f) {
    const glm::vec4 d = glm::abs(look(x, ends[0].first, ends[1].first, i / points) -
                                 look(y, ends[0].second, ends[1].second, i / points));
    if (!(std::max({d.x, d.y, d.z, d.w}) <= colour_step)) return true;
  }
  return false;
}

// Returns the number of texels between two vertices, along the longer direction.
float SurfaceLook::texels_along(const TextureUse& use, std::uint32_t a, std::uint32_t b) const {
  const auto texture = static_cast<std::size_t>(use.texture);
  const auto& uv = world_.texcoords[use.texcoord];
  if (texture >= world_.textures.size() || uv.empty()) return 0.0f;
  const int index = world_.textures[texture].image;
  if (index < 0 || static_cast<std::size_t>(index) >= world_.images.size()) return 0.0f;
  const Image& image = world_.images[static_cast<std::size_t>(index)];
  const glm::vec2 d = glm::abs(glm::mat2(use.uv_transform) * (uv[b] - uv[a]));
  return std::max(d.x * static_cast<float>(image.width), d.y * static_cast<float>(image.height));
}

}  // namespace asos
