#include "renderer/shading/shade.h"

#include "renderer/geometry/largest.h"
#include "renderer/shading/anisotropy.h"
#include "renderer/shading/background_along.h"
#include "renderer/shading/brdf.h"
#include "renderer/shading/layers.h"
#include "renderer/shading/material_layers.h"
#include "renderer/shading/reflected_light.h"
#include "renderer/shading/sky.h"
#include "renderer/world/surface_kind.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace asos {
namespace {

/// Returns the footprint of a sample's whole square, whichever part of it the sample represents.
Footprint square_footprint(const World& world, const SampleExtent& extent, const Ray& ray,
                           const Hit& hit, const SurfacePoint& point) {
  Footprint square = footprint_on(
      world, hit,
      patch_on_plane(*extent.spacing, ray.direction, hit.t, point.geometric_normal, extent.side));
  square.side = extent.side;
  return square;
}

float mean_of(glm::vec3 colour) {
  return (colour.x + colour.y + colour.z) / 3.0f;
}

bool shows_only_unlit(PixelContent content) {
  return content == PixelContent::unlit_share || content == PixelContent::unlit_colour;
}

/// Returns whether an opaque surface contributes the same wherever it is hit.
bool needs_no_point(PixelContent content, const Material& material) {
  if (content == PixelContent::light) return false;
  return !(content == PixelContent::unlit_colour && material.unlit);
}

/// Returns the point of the surface's other side.
SurfacePoint other_side(SurfacePoint point) {
  point.geometric_normal = -point.geometric_normal;
  point.shading_normal = -point.shading_normal;
  point.forget_smooth_surface();
  return point;
}

/// Ignores all light.
class NoTransport final : public LightTransport {
 public:
  void add(const Illumination&, glm::vec3&, RenderStatistics&) override {}
};

}  // namespace

Shader::Shader(const World& world, const RenderFeatures& render_features, const RayScene& rays,
               const Lighting& lighting, ShadingSettings settings)
    : world_(world),
      needs_(render_features),
      rays_(rays),
      lighting_(lighting),
      settings_(settings) {
  if (settings.backdrop.shows_light()) lights_ = lighting.prepared(settings.light_rule);
  sums_patches_ = settings.bend < 1.0f && settings.light_rule == LightRule::physical &&
                  std::any_of(lights_.begin(), lights_.end(),
                              [](const PreparedLight& light) { return light.extended(); });
}

std::optional<LightHit> Shader::nearest_light_without_geometry(const Ray& ray) const {
  std::optional<LightHit> nearest;
  for (const std::uint32_t i : lights_without_geometry()) {
    const auto met = meet_light(lights_[i], ray);
    if (met && (!nearest || met->t < nearest->t)) nearest = met;
  }
  return nearest;
}

const Dfr* Shader::own_dfr(std::uint32_t triangle) const {
  if (!settings_.dfrs) return nullptr;
  const std::optional<Dfr>& own = (*settings_.dfrs)[world_.material_index(triangle)];
  return own ? &*own : nullptr;
}

float Shader::add_material(const ViewedRay& seen, const SurfacePoint& point,
                           const SurfaceMaterial& material, const Layer& layer,
                           const MipChains* mips, LightTransport& transport, glm::vec3& radiance,
                           RenderStatistics& counts) const {
  const glm::vec3 to_viewer = -seen.ray.direction;
  const float n_dot_v = viewed_point(point, to_viewer).n_dot_v;
  Layer below = layer;
  float left = 1.0f;
  for (const MaterialLayer part : MaterialLayers(material)) {
    const bool is_base = part == MaterialLayer::base;
    if (is_base && !seen.diffuse && shows_emission(seen.hides_lights, layer.hit.triangle) &&
        material.emission != glm::vec3(0.0f)) {
      const glm::vec3 emission = below.share * material.emission;
      transport.note(LightPart::emission, emission);
      radiance += emission;
    }
    std::optional<SurfacePoint> own;
    if (part == MaterialLayer::coat) own = coat_point(world_, needs_, layer.hit, mips, point);
    if (part == MaterialLayer::behind) own = other_side(point);
    ViewedPoint view = viewed_point(own ? *own : point, to_viewer);
    // The other side is viewed as the surface reflects the viewer.
    if (part == MaterialLayer::behind)
      view.to_viewer = glm::reflect(to_viewer, point.shading_normal), view.n_dot_v = n_dot_v;
    const float cosine = cosine_for(part, view);
    const ViewedMaterial lobes = is_base && layer.boundary
                                     ? layer.boundary->viewed(material, cosine, layer.passage)
                                     : viewed(material, part, cosine);
    if (!seen.diffuse || part != MaterialLayer::coat)
      add_lit(seen, view, seen.diffuse && is_base ? diffuse_part(lobes) : lobes, below, transport,
              radiance, counts);
    const float passed = passed_below(part, lobes.lobe.f0, lobes.ambient);
    below.share *= passed;
    left *= is_base ? lobes.below : passed;
  }
  return left;
}

void Shader::add_lit(const ViewedRay& viewed_ray, const ViewedPoint& viewed_point,
                     const ViewedMaterial& seen, const Layer& layer, LightTransport& transport,
                     glm::vec3& radiance, RenderStatistics& counts) const {
  ViewedPoint view = viewed_point;
  const SurfacePoint& point = view.point;
  const glm::vec3 to_viewer = view.to_viewer;
  const bool mirrors = reflect(viewed_ray, point, seen, layer, transport, radiance, counts);
  const SkyQuery under_sky{settings_.sky, view, seen, mirrors, layer.share};
  if (!settings_.sky_shadows || !transport.add_sky(under_sky, radiance, counts)) {
    ViewedMaterial by_sky = seen;
    if (mirrors) by_sky.specular = glm::vec3(0.0f);
    radiance += layer.share * reflected_sky(settings_.sky, by_sky, point.shading_normal, to_viewer);
  }

  const PixelSpacing& spacing = viewed_ray.spacing ? *viewed_ray.spacing : settings_.spacing;
  const bool narrow = settings_.mips && !seen.lobe.is_broad();
  if (viewed_ray.side > 0.0f && (narrow || sums_patches_)) {
    view.patch = shaped(patch_on_plane(spacing, viewed_ray.ray.direction, layer.hit.t,
                                       point.geometric_normal, viewed_ray.side),
                        viewed_ray.shape);
    view.distance = spacing.distance(layer.hit.t);
  }
  const MirroredLights mirrored =
      mirrors ? mirrored_lights(point.triangle, seen.lobe.round_roughness()) : MirroredLights::none;
  const LightingQuery lit_point{lights_, view, seen, mirrored, layer.share, settings_.shadows};
  const HandledLights gathered = transport.gather(lit_point);
  if (gathered.all) return;
  const Receiver receiver = receiver_at(point);
  std::optional<PatchCurvature> bend;
  if (viewed_ray.side > 0.0f && sums_patches_)
    bend = PatchCurvature::at(
        world_, layer.hit, view, seen,
        settings_.bend / (viewed_ray.throughput * viewed_ray.side * viewed_ray.side));
  ReflectedLights reflected(lit_point, bend);
  for (std::uint32_t i = 0; i < lights_.size(); ++i) {
    const PreparedLight& light = lights_[i];
    if (gathered.holds(i)) continue;
    const glm::vec3 irradiance = unshadowed_irradiance(light, receiver);
    if (irradiance == glm::vec3(0.0f)) continue;
    const ReflectedLights::LightReflection share = reflected.of(light, irradiance);
    const Illumination lit{light,        i,          point,          irradiance, share.reflected,
                           layer.number, &lit_point, share.highlight};
    if (light.casts_shadows && settings_.shadows) {
      transport.add(lit, radiance, counts);
    } else {
      radiance += lit.reflected * lit.unshadowed;
    }
  }
}

glm::vec3 Shader::radiance(const Ray& ray, const Hit& hit, float side, LightTransport& transport,
                           RenderStatistics& counts) const {
  return radiance(eye_ray(ray, hit, side), transport, counts);
}

ViewedRay Shader::eye_ray(const Ray& ray, const Hit& hit, float side) const {
  const PixelSpacing& spacing = settings_.spacing;
  const float width = spacing.perspective ? glm::length(spacing.right) : 0.0f;
  return {ray, hit, side, nullptr, width, 0, 1.0f};
}

glm::vec3 Shader::radiance(const ViewedRay& seen, LightTransport& transport,
                           RenderStatistics& counts) const {
  const SampleExtent extent{seen.spacing ? seen.spacing : &settings_.spacing, settings_.mips,
                            seen.side, seen.shape, seen.colours};
  if (!settings_.backdrop.shows_light()) {
    NoTransport none;
    const Layers met = look_along(seen, extent, none, counts);
    return settings_.backdrop.content() == PixelContent::coverage ? glm::vec3(1.0f) - met.behind
                                                                  : met.radiance;
  }
  const Layers met = look_along(seen, extent, transport, counts);
  if (met.behind == glm::vec3(0.0f)) return met.radiance;
  const glm::vec3 beyond = background_along(settings_, seen);
  transport.note(LightPart::background, met.behind * beyond);
  return met.radiance + met.behind * beyond;
}

glm::vec3 background_along(const ShadingSettings& settings, const ViewedRay& seen) {
  const SampleExtent extent{seen.spacing ? seen.spacing : &settings.spacing, settings.mips,
                            seen.side};
  const PixelSpacing* spacing = extent.point() ? nullptr : extent.spacing;
  return seen.bounces == 0 ? settings.backdrop.radiance(settings.sky, seen.ray, spacing, seen.side)
                           : background(settings.sky, seen.ray.direction, spacing, seen.side);
}

CoveredRay Shader::covered(const ViewedRay& seen, RenderStatistics& counts) const {
  const SampleExtent extent{seen.spacing ? seen.spacing : &settings_.spacing, settings_.mips,
                            seen.side, seen.shape, seen.colours};
  NoTransport none;
  CoveredRay ray;
  const Layers met = look_along(seen, extent, none, counts, &ray.surfaces);
  ray.coverage = mean_of(glm::vec3(1.0f) - met.behind);
  // So far `share` is the weight that is left behind a surface; behind the last one it is the
  // background's, since invisible surfaces are left out.
  if (!ray.surfaces.empty()) ray.surfaces.back().share = 1.0f - ray.coverage;
  float before = 1.0f;
  for (SurfaceCover& surface : ray.surfaces) {
    const float left = std::min(before, surface.share);
    surface.share = before - left;
    before = left;
  }
  return ray;
}

glm::vec3 Shader::unlit_colour(const SurfaceMaterial& material) const {
  const bool share = settings_.backdrop.content() == PixelContent::unlit_share;
  return (share ? glm::vec3(1.0f) : material.base_color) * (1.0f - material.transmission);
}

Shader::Layers Shader::look_along(const ViewedRay& seen, const SampleExtent& extent,
                                  LightTransport& transport, RenderStatistics& counts,
                                  std::vector<SurfaceCover>* covers) const {
  const MipChains* mips = extent.point() ? nullptr : settings_.mips;
  const bool only_unlit = shows_only_unlit(settings_.backdrop.content());
  glm::vec3 sum{0.0f};
  glm::vec3 left_out{0.0f};
  glm::vec3 share{1.0f};  // weight of the surfaces behind the layers so far
  SurfaceWalk walk(rays_, seen.ray, seen.hit, settings_.faces);
  std::uint32_t last = seen.passed.last;
  VolumePath passage = seen.passage;
  float passed = seen.start();  // share has the attenuation up to here
  const glm::vec3 to_viewer = -seen.ray.direction;
  const auto cover = [&](const Hit& hit, glm::vec3 left) {
    if (covers) covers->push_back({hit, mean_of(left)});
  };
  const auto light = seen.reflected() && !seen.hides_lights
                         ? nearest_light_without_geometry(seen.ray)
                         : std::nullopt;

  LayerCount count = seen.passed.count;
  for (int layer = count.layers(); !count.full(); ++layer) {
    const Hit hit = walk.hit();
    const Ray& ray = walk.ray();
    if (light && !(hit.valid() && hit.t < light->t)) return {sum + share * light->radiance};
    if (!hit.valid()) return {sum, share};
    const Material& own = world_.material_of(hit.triangle);
    const bool blended = needs_.alpha_blend && surface_kind(own) == SurfaceKind::blended;
    if (!blended && needs_no_point(settings_.backdrop.content(), own)) {
      cover(hit, glm::vec3(0.0f));
      return {own.unlit && only_unlit ? sum + share : sum};
    }
    const SurfacePoint point = surface_point(world_, needs_, hit, to_viewer, extent);
    const auto boundary = blended ? VolumeBoundary::met(world_, hit, ray, passage) : std::nullopt;
    // The inner side of a boundary gives the medium in front of it, wherever the ray started.
    if (boundary && !boundary->entering) passage = boundary->incident(passage);
    if (passage.in_medium()) share *= passage.left_after(hit.t - passed);
    passed = hit.t;

    // A face of an analytic shape may be hit twice, at its front and its back.
    if (boundary && boundary->hidden()) {
      passage = boundary->passed(passage);
      count.add_layer();
    } else if (hit.triangle != last || world_.is_face(hit.triangle)) {
      SurfaceMaterial material = surface_material(world_, needs_, hit, point.footprint, mips);
      if (!seen.parts.empty() && mips)
        average_colours(world_, needs_, hit, square_footprint(world_, extent, ray, hit, point),
                        seen.parts, *mips, material);
      if (material.anisotropy.strength > 0.0f)
        material.stretch = lobe_stretch(world_, hit, material.anisotropy, material.roughness,
                                        point.shading_normal, to_viewer);
      float left = 1.0f;
      if (blended && !(material.opacity > 0.0f)) {
        count.pass_clear();
      } else {
        count.add_layer();
      }
      if (material.opacity > 0.0f) {
        Layer here{share * material.opacity, layer, hit, passage};
        if (boundary) {
          boundary->set_reflectance(material);
          here.boundary = &*boundary;
          here.passage = boundary->reflected(passage);
        }
        if (material.unlit) {
          const glm::vec3 colour = here.share * unlit_colour(material);
          transport.note(LightPart::emission, colour);
          sum += colour;
        } else {
          left = add_material(seen, point, material, here, mips, transport,
                              only_unlit ? left_out : sum, counts);
        }
      }
      if (!blended) {
        cover(hit, glm::vec3(0.0f));
        return {sum};
      }
      // Where pixels contain no light, refracting or blurring glass covers fully.
      const bool frosted =
          !boundary && material.transmission > 0.0f && material.roughness > 0.0f && !material.unlit;
      if ((boundary || frosted) && !settings_.backdrop.shows_light() && settings_.reflections > 0) {
        cover(hit, glm::vec3(0.0f));
        return {sum};
      }
      // The base colour tints the transmitted light.
      if (!material.unlit) left *= 1.0f - material.metallic;
      glm::vec3 through =
          share * material.opacity * left * material.transmission * material.base_color;
      if (boundary || frosted) {
        const Layer here{through, layer, hit, passage, boundary ? &*boundary : nullptr};
        through =
            add_refracted(seen, point, material.roughness, here, through, transport, sum, counts);
      }
      share = share * (1.0f - material.opacity) + through;
      if (material.opacity > 0.0f) cover(hit, share);
      if (boundary) {
        passage = boundary->refracted(passage);
        passage.straight = passage.in_medium();
      }
      if (invisible(seen.passed.left * largest(share), count.layers())) return {sum};
      last = hit.triangle;
    } else {
      count.add_layer();
    }

    walk.go_on(point);
    ++(seen.bounces > 0 ? counts.reflection_rays : counts.eye_rays);
  }
  ++counts.cut_stacks;
  return {sum};
}

}  // namespace asos
