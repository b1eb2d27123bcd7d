#include "renderer/asos/textured_sight.h"

#include "renderer/asos/part_shape.h"
#include "renderer/asos/texture_samples.h"
#include "renderer/shading/texture.h"
#include "renderer/shading/texture_products.h"
#include "renderer/world/texture_image.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace asos {

namespace {

/// The texture that shows most of a material; null: none.
const TextureUse* main_texture(const Material& material) {
  for (const TextureUse* use : {&material.base_color_texture, &material.emissive_texture,
                                &material.metallic_roughness_texture})
    if (use->used()) return use;
  return nullptr;
}

/// Whether a footprint goes on beyond its triangle.
bool crosses_edge(const Hit& hit, const Footprint& seen) {
  const auto reach = [](float right, float down) {
    return 0.5f * (std::abs(right) + std::abs(down));
  };
  const float b1 = hit.b1 + seen.offset.x, b2 = hit.b2 + seen.offset.y;
  return b1 < reach(seen.right.x, seen.down.x) || b2 < reach(seen.right.y, seen.down.y) ||
         1.0f - b1 - b2 < reach(seen.right.x + seen.right.y, seen.down.x + seen.down.y);
}

/// A triangle's texture coordinates, in texels, going on all over its plane.
class TexturePlane {
 public:
  TexturePlane(const World& world, std::uint32_t triangle, const TextureUse& use)
      : uv_(corner_texcoords(world, use.texcoord, triangle)), texture_of_uv_(use.uv_transform) {
    const Image* image = image_of(world, use.texture);
    if (!image) return;
    const Texture& texture = world.textures[static_cast<std::size_t>(use.texture)];
    texels_ = glm::vec2(image->width, image->height);
    period_ = {period_of(texture.wrap_u), period_of(texture.wrap_v)};
  }

  /// The longer edge of a footprint.
  [[nodiscard]] float extent(const Footprint& seen) const {
    const Steps steps(seen, uv_.at_0, uv_.at_1, uv_.at_2);
    return std::max(glm::length(texels_ * (texture_of_uv_ * steps.right)),
                    glm::length(texels_ * (texture_of_uv_ * steps.down)));
  }
  /// From what is shown at (b1, b2) to other coordinates.
  [[nodiscard]] float distance(glm::vec2 b, glm::vec2 uv) const {
    const glm::vec2 here = uv_.at_0 + b.x * (uv_.at_1 - uv_.at_0) + b.y * (uv_.at_2 - uv_.at_0);
    glm::vec2 away = texture_of_uv_ * (uv - here);
    for (int i = 0; i < 2; ++i)
      if (period_[i] > 0.0f) away[i] -= period_[i] * std::round(away[i] / period_[i]);
    return glm::length(texels_ * away);
  }

 private:
  /// After which a texture shows the same again; 0: it does not.
  [[nodiscard]] static float period_of(Wrap wrap) {
    return wrap == Wrap::repeat ? 1.0f : wrap == Wrap::mirrored_repeat ? 2.0f : 0.0f;
  }

  CornerTexcoords uv_;
  glm::mat2 texture_of_uv_;
  glm::vec2 texels_{1.0f}, period_{0.0f};
};

/// Whether a triangle's corners have colours of their own.
bool is_tinted(const World& world, std::uint32_t triangle) {
  if (world.colors.empty() || world.is_face(triangle)) return false;
  const glm::uvec3 v = world.triangles[triangle];
  return world.colors[v.x] != world.colors[v.y] || world.colors[v.x] != world.colors[v.z];
}

}  // namespace

bool reaches_beyond_triangle(const World& world, const Hit& hit, const Patch& patch) {
  constexpr float far = 0.5f;  // of the triangle
  const Footprint seen = footprint_on(world, hit, patch);
  const auto reach = [](glm::vec2 edge) {
    return std::max({std::abs(edge.x), std::abs(edge.y), std::abs(edge.x + edge.y)});
  };
  return std::max(reach(seen.right), reach(seen.down)) > far;
}

bool textured_by_several(const EyeContext& eye, const Hit& hit, const Patch& patch) {
  const RenderScene& scene = *eye.scene;
  return eye.settings->texture.filter != TextureFilter::point &&
         is_textured(scene.world().material_of(hit.triangle), scene.needs) &&
         scene.features().deviation(hit.triangle) > 0.0f &&
         reaches_beyond_triangle(scene.world(), hit, patch);
}

bool texture_strays(const EyeContext& eye, const EyeSamples& samples, SampleId sample, double share,
                    const LeafRegion& region) {
  constexpr float apart = 0.45f;                       // of the leaf's sides
  constexpr float negligible = 0.5f, slightly = 0.1f;  // texels; of the leaf's extent
  const RenderScene& scene = *eye.scene;
  const World& world = scene.world();
  const Hit& hit = samples.hit(sample);
  const TextureUse* use = main_texture(world.material_of(hit.triangle));
  if (eye.settings->texture.filter == TextureFilter::point || !scene.needs.textures || !use ||
      world.is_face(hit.triangle) || eye.viewer.passage.in_medium())
    return false;
  const PartShape part = part_shape(region, samples.at(sample));
  const Footprint seen = shaped(footprint_on(world, hit, samples.patch(sample, share)), part);
  if (!crosses_edge(hit, seen)) return false;
  // Look at the leaf's corners.
  const std::array<glm::vec2, 4> corners{
      glm::vec2(-apart), {apart, -apart}, {-apart, apart}, glm::vec2(apart)};
  const float side = eye.root_side() * static_cast<float>(std::sqrt(share));
  std::array<Ray, 4> rays;
  std::array<Hit, 4> hits;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const glm::vec2 at = part.offset + corners[i].x * part.right + corners[i].y * part.down;
    rays[i] = samples.ray_through(samples.at(sample) + side * at);
  }
  scene.rays().closest(rays, hits, culling_of(*eye.settings));
  eye.counts->eye_rays += rays.size();
  // Compare what is there to the footprint, but for other surfaces, which are other leaves.
  const TexturePlane plane(world, hit.triangle, *use);
  const float allowed = std::max(negligible, slightly * plane.extent(seen));
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Hit& met = hits[i];
    if (!met.valid() || met.triangle == hit.triangle ||
        scene.features().sheet(met.triangle) != scene.features().sheet(hit.triangle))
      continue;
    const glm::vec2 b = glm::vec2(hit.b1, hit.b2) + seen.offset + corners[i].x * seen.right +
                        corners[i].y * seen.down;
    if (plane.distance(b, texcoord_at(world, use->texcoord, met.triangle, met.b1, met.b2)) >
        allowed)
      return true;
  }
  return false;
}

bool recedes(const EyeContext& eye, const Ray& ray, const Hit& hit, const Patch& patch) {
  constexpr float much = 0.1f;  // of the distance
  const RenderScene& scene = *eye.scene;
  const Material& material = scene.world().material_of(hit.triangle);
  if (eye.settings->texture.filter == TextureFilter::point ||
      !(is_tinted(scene.world(), hit.triangle) || is_textured(material, scene.needs)))
    return false;
  const float depth = std::abs(glm::dot(patch.right, ray.direction)) +
                      std::abs(glm::dot(patch.down, ray.direction));
  return depth > much * eye.viewer.spacing.distance(hit.t);
}

bool uneven_products(const EyeContext& eye, const Hit& hit, const Patch& square,
                     const PartShape& part, double share) {
  const RenderScene& scene = *eye.scene;
  if (eye.settings->texture.filter == TextureFilter::point ||
      !multiplies_textures(scene.world().material_of(hit.triangle), scene.needs))
    return false;
  Footprint seen = shaped(footprint_on(scene.world(), hit, square), part);
  seen.side = eye.side_of(share);
  const float roughest = eye.viewer.shader.settings().roughest_mirror;
  return product_error(scene.world(), scene.needs, hit, seen, roughest) >
         eye.budget.for_samples().tolerance;
}

}  // namespace asos
