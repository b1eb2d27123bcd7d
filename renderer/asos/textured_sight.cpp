#include "renderer/asos/textured_sight.h"

#include "renderer/asos/texture_samples.h"
#include "renderer/kernels/light_selection.h"
#include "renderer/pyray/tuning.h"
#include "renderer/shading/surface.h"
#include "renderer/shading/texture.h"
#include "renderer/shading/texture_products.h"
#include "renderer/world/texture_image.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <vector>

namespace asos {

namespace {

/// Returns the texture with the most influence on a material's look; null: none.
const TextureUse* main_texture(const Material& material) {
  for (const TextureUse* use : {&material.base_color_texture, &material.emissive_texture,
                                &material.metallic_roughness_texture})
    if (use->used()) return use;
  return nullptr;
}

/// Returns whether a footprint extends beyond its triangle.
bool crosses_edge(const Hit& hit, const Footprint& seen) {
  const auto reach = [](float right, float down) {
    return 0.5f * (std::abs(right) + std::abs(down));
  };
  const float b1 = hit.b1 + seen.offset.x, b2 = hit.b2 + seen.offset.y;
  return b1 < reach(seen.right.x, seen.down.x) || b2 < reach(seen.right.y, seen.down.y) ||
         1.0f - b1 - b2 < reach(seen.right.x + seen.right.y, seen.down.x + seen.down.y);
}

/// A triangle's texture coordinates, in texels, extrapolated over its plane. Without a texture all
/// distances are 0.
class TexturePlane {
 public:
  TexturePlane(const World& world, std::uint32_t triangle, const TextureUse* use)
      : world_(&world), use_(use) {
    if (!use) return;
    uv_ = corner_texcoords(world, use->texcoord, triangle);
    texture_of_uv_ = use->uv_transform;
    const Image* image = image_of(world, use->texture);
    if (!image) return;
    const Texture& texture = world.textures[static_cast<std::size_t>(use->texture)];
    texels_ = glm::vec2(image->width, image->height);
    period_ = {period_of(texture.wrap_u), period_of(texture.wrap_v)};
  }

  /// Returns the longer edge of a footprint, in texels.
  [[nodiscard]] float extent(const Footprint& seen) const {
    const Steps steps(seen, uv_.at_0, uv_.at_1, uv_.at_2);
    return std::max(glm::length(texels_ * (texture_of_uv_ * steps.right)),
                    glm::length(texels_ * (texture_of_uv_ * steps.down)));
  }
  /// Returns the distance, in texels, from the coordinates at (b1, b2) to those of a hit.
  [[nodiscard]] float distance(glm::vec2 b, const Hit& met) const {
    if (!use_) return 0.0f;
    const glm::vec2 uv = texcoord_at(*world_, use_->texcoord, met.triangle, met.b1, met.b2);
    const glm::vec2 here = uv_.at_0 + b.x * (uv_.at_1 - uv_.at_0) + b.y * (uv_.at_2 - uv_.at_0);
    glm::vec2 away = texture_of_uv_ * (uv - here);
    for (int i = 0; i < 2; ++i)
      if (period_[i] > 0.0f) away[i] -= period_[i] * std::round(away[i] / period_[i]);
    return glm::length(texels_ * away);
  }

 private:
  /// Returns the period in texture coordinates; 0: the texture does not repeat.
  [[nodiscard]] static float period_of(Wrap wrap) {
    return wrap == Wrap::repeat ? 1.0f : wrap == Wrap::mirrored_repeat ? 2.0f : 0.0f;
  }

  const World* world_;
  const TextureUse* use_;
  CornerTexcoords uv_{};
  glm::mat2 texture_of_uv_{1.0f};
  glm::vec2 texels_{1.0f}, period_{0.0f};
};

/// Returns whether a triangle's corners have different colours.
bool is_tinted(const World& world, std::uint32_t triangle) {
  if (world.colors.empty() || world.is_face(triangle)) return false;
  const glm::uvec3 v = world.triangles[triangle];
  return world.colors[v.x] != world.colors[v.y] || world.colors[v.x] != world.colors[v.z];
}

/// Returns the difference between the colour of a hit and the triangle's colour, extrapolated to
/// (b1, b2).
float colour_difference(const World& world, std::uint32_t triangle, glm::vec2 b, const Hit& met) {
  const glm::vec4 of_met = vertex_color(world, met.triangle, met.b1, met.b2);
  const glm::vec4 apart = glm::abs(of_met - vertex_color(world, triangle, b.x, b.y));
  return std::max({apart.x, apart.y, apart.z, apart.w});
}

/// Returns whether an edge is part of a square's sides.
bool lies_along(const Square& square, const BorderEdge& edge) {
  for (int axis = 0; axis < 2; ++axis) {
    const float lo = axis == 0 ? square.u : square.v;
    for (const float line : {lo, lo + square.side})
      if (edge.from[axis] == line && edge.to[axis] == line) return true;
  }
  return false;
}

/// Places that represent the part of a leaf beyond its triangle.
struct Places {
  static constexpr std::size_t most = 8;
  std::array<glm::vec2, most> from_sample;  ///< in sides of a square with the leaf's area
  std::size_t count = 0;
};

/// Returns the corners of the parallelogram of a leaf whose sample is `at`, and points just inside
/// the centres of the longest edges that cut it. Along these edges may lie strips as narrow as a
/// tenth of a pixel, such as bevels.
Places places_near_border(const LeafRegion& region, const FootprintShape& part, glm::vec2 at,
                          float side) {
  constexpr float apart = 0.45f;   // of the leaf's sides
  constexpr float within = 0.05f;  // of the way to the leaf's centre
  Places places;
  for (const glm::vec2 c : {glm::vec2(-apart), {apart, -apart}, {-apart, apart}, glm::vec2(apart)})
    places.from_sample[places.count++] = part.offset + c.x * part.right + c.y * part.down;
  std::vector<BorderEdge> cuts(region.border.begin(), region.border.end());
  const auto longer = [](const BorderEdge& a, const BorderEdge& b) {
    return glm::distance(a.from, a.to) > glm::distance(b.from, b.to);
  };
  std::erase_if(cuts, [&](const BorderEdge& e) { return lies_along(region.square, e); });
  std::stable_sort(cuts.begin(), cuts.end(), longer);
  for (const BorderEdge& e : cuts) {
    if (places.count == Places::most) break;
    const glm::vec2 middle = (0.5f * (e.from + e.to) - at) / side;
    places.from_sample[places.count++] = glm::mix(middle, part.offset, within);
  }
  return places;
}

}  // namespace

bool reaches_beyond_triangle(const World& world, const Hit& hit, const Patch& patch) {
  const Footprint seen = footprint_on(world, hit, patch);
  const auto reach = [](glm::vec2 edge) {
    return std::max({std::abs(edge.x), std::abs(edge.y), std::abs(edge.x + edge.y)});
  };
  return std::max(reach(seen.right), reach(seen.down)) > LeafTuning::far_beyond_triangle;
}

bool textured_by_several(const EyeContext& eye, const Hit& hit, const Patch& patch) {
  const RenderScene& scene = *eye.scene;
  return eye.settings->texture.filter != TextureFilter::point &&
         is_textured(scene.world().material_of(hit.triangle), scene.render_features) &&
         scene.features().deviation(hit.triangle) > 0.0f &&
         reaches_beyond_triangle(scene.world(), hit, patch);
}

bool strays_beyond_edges(const EyeContext& eye, const EyeSamples& samples, const Leaf& leaf) {
  const RenderScene& scene = *eye.scene;
  const World& world = scene.world();
  const Hit& hit = leaf.hit;
  const TextureUse* use = nullptr;
  if (scene.render_features.textures && eye.settings->texture.filter != TextureFilter::point)
    use = main_texture(world.material_of(hit.triangle));
  const bool coloured = scene.render_features.vertex_colors &&
                        world.parts[world.triangle_part[hit.triangle]].coloured;
  if (!(use || coloured) || world.is_face(hit.triangle) || eye.viewer.passage.in_medium())
    return false;
  const FootprintShape& part = leaf.shape;
  const Footprint square = footprint_on(world, hit, leaf.square);
  const Footprint seen = shaped(square, part);
  if (!crosses_edge(hit, seen)) return false;
  // Cast rays at the leaf's corners and along its border.
  const float side = eye.root_side() * static_cast<float>(std::sqrt(leaf.weight));
  const Places places = places_near_border(leaf.region, part, leaf.at, side);
  std::array<Ray, Places::most> rays;
  std::array<Hit, Places::most> hits;
  for (std::size_t i = 0; i < places.count; ++i)
    rays[i] = samples.ray_through(leaf.at + side * places.from_sample[i]);
  scene.rays().closest(std::span(rays).first(places.count), std::span(hits).first(places.count),
                       culling_of(*eye.settings));
  eye.counts->eye_rays += places.count;
  // Compare these hits with the footprint. Skip hits on other surfaces, which belong to other
  // leaves.
  const TexturePlane plane(world, hit.triangle, use);
  const float allowed =
      std::max(LeafTuning::negligible_texels, LeafTuning::negligible_extent * plane.extent(seen));
  for (std::size_t i = 0; i < places.count; ++i) {
    const Hit& met = hits[i];
    if (!met.valid() || met.triangle == hit.triangle ||
        scene.features().smooth_surface(met.triangle) !=
            scene.features().smooth_surface(hit.triangle))
      continue;
    const glm::vec2 away = places.from_sample[i];
    const glm::vec2 b =
        glm::vec2(hit.b1, hit.b2) + square.offset + away.x * square.right + away.y * square.down;
    if (plane.distance(b, met) > allowed) return true;
    if (coloured && colour_difference(world, hit.triangle, b, met) > eye.error_budget.tolerance)
      return true;
  }
  return false;
}

bool recedes(const EyeContext& eye, const Ray& ray, const Hit& hit, const Patch& patch) {
  const RenderScene& scene = *eye.scene;
  const Material& material = scene.world().material_of(hit.triangle);
  if (eye.settings->texture.filter == TextureFilter::point ||
      !(is_tinted(scene.world(), hit.triangle) || is_textured(material, scene.render_features)))
    return false;
  const float depth = std::abs(glm::dot(patch.right, ray.direction)) +
                      std::abs(glm::dot(patch.down, ray.direction));
  return depth > LeafTuning::negligible_extent * eye.viewer.spacing.distance(hit.t);
}

bool uneven_products(const EyeContext& eye, const Ray& ray, const Hit& hit, const Patch& square,
                     const FootprintShape& part, double share) {
  const RenderScene& scene = *eye.scene;
  if (eye.settings->texture.filter == TextureFilter::point ||
      !multiplies_textures(scene.world().material_of(hit.triangle), scene.render_features))
    return false;
  Footprint seen = shaped(footprint_on(scene.world(), hit, square), part);
  seen.side = eye.side_of(share);
  const Shader& shader = eye.viewer.shader;
  ViewedFrom from;
  from.to_viewer = -ray.direction;
  from.roughest_mirror = shader.settings().roughest_mirror;
  if (eye.viewer.bounces < shader.reflections()) from.reflections = &scene.mips();
  // Many lights are sampled.
  if (shader.lights().size() <= LightSelection::few_lights) from.lights = shader.lights();
  from.enough = eye.error_budget.tolerance;
  return product_error(scene.world(), scene.render_features, hit, seen, from).sum() > from.enough;
}

}  // namespace asos
