#include "renderer/asos/eye_caster.h"

#include "renderer/asos/part_shape.h"
#include "renderer/sampling/random.h"
#include "renderer/world/hit_plane.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace asos {
namespace {

// How far one sample may be off the mean of the patch that it stands for: EPS, or a quarter of a
// finest cell where that is more, so that MAX alone refines shading as it refines outlines; but no
// less than an eighth of one step of an 8-bit picture, which nobody sees and which would cost most.
float let_pass(const RenderSettings& settings) {
  if (!settings.asos.refine_shading) return std::numeric_limits<float>::infinity();
  constexpr double invisible = 1.0 / 2048.0;
  return static_cast<float>(std::max(
      {settings.asos.eps, std::ldexp(1.0, -2 * (settings.asos.max_level + 1)), invisible}));
}

ShadowRules shadow_settings(const RenderScene& scene, const RenderSettings& settings,
                            float most_uneven) {
  ShadowRules shadows;
  shadows.see_through = scene.needs.varying_opacity;
  shadows.quality = settings.shadow.quality;
  shadows.divisions = settings.shadow.divisions;
  shadows.max_level = settings.asos.max_level;
  shadows.eps = settings.asos.eps;
  shadows.exact_leaves = settings.asos.leaf == Leaf::exact;
  shadows.most_uneven = most_uneven;
  return shadows;
}

// Of a place to a 2^16th of the block: its last bits are rounding, which the scene's scale decides.
std::uint64_t seed_of(glm::vec2 at, PixelRect block) {
  const auto bits = [](float x) {
    return static_cast<std::uint64_t>(static_cast<std::uint32_t>(std::lround(x * 65536.0f)));
  };
  const std::uint64_t place = static_cast<std::uint64_t>(static_cast<std::uint32_t>(block.x))
                                  << 32 |
                              static_cast<std::uint32_t>(block.y);
  return mix_bits(mix_bits(place) ^ (bits(at.x) << 32 | bits(at.y)));
}

}  // namespace

EyeCaster::EyeCaster(const RenderScene& scene, const Viewer& viewer, const RenderSettings& settings,
                     const Frame& frame, PixelRect block, std::size_t roots, EyeWorkspace& work,
                     const std::stop_token& stop, RenderStatistics& counts,
                     const MirroredMask* mask)
    : scene_(scene),
      shadow_scene_{scene.world, scene.features, scene.rays},
      viewer_(viewer),
      frame_(frame),
      block_(block),
      stop_(stop),
      counts_(counts),
      shader_(viewer.shader),
      mask_(mask),
      faces_(seen_faces(settings)),
      most_uneven_(let_pass(settings)),
      groups_(shadow_scene_),
      shadows_(shadow_scene_, shadow_settings(scene, settings, most_uneven_), frame, *this, groups_,
               work.shadows),
      work_(work),
      sums_(roots),
      settings_(settings) {
  for (const PreparedLight& light : shader_.lights()) {
    const bool casts = settings.shadow.cast && light.casts_shadows;
    cast_shadows_ |= casts;
    extended_lights_ |= casts && light.extended();
    spots_ |= light.cone_scale > 0.0;
  }
}

Caster::SampleId EyeCaster::probe(std::span<const glm::vec2> points) {
  const std::size_t first = rays_.size();
  points_.insert(points_.end(), points.begin(), points.end());
  for (const glm::vec2& p : points) rays_.push_back(ray_through(p));
  hits_.resize(rays_.size());
  // In runs of which each takes well under a millisecond, so that cancelling is quick.
  constexpr std::size_t run = 1024;
  for (std::size_t i = first; i < rays_.size() && !cancelled(); i += run) {
    const std::size_t count = std::min(run, rays_.size() - i);
    const std::span rays = std::span(rays_).subspan(i, count);
    const std::span hits = std::span(hits_).subspan(i, count);
    scene_.rays.closest(rays, hits, faces_);
    if (viewer_.mirror) pass_mirror(*viewer_.mirror, scene_.world, scene_.rays, faces_, rays, hits);
  }
  counts_.eye_rays += points.size();
  return static_cast<SampleId>(first);
}

// The side, in pixels, of the square that a leaf stands for, whatever its shape.
float EyeCaster::side_of(double weight) const {
  return viewer_.pixel * static_cast<float>(std::sqrt(weight));
}

Ray EyeCaster::ray_through(glm::vec2 p) const {
  return viewer_.view.ray(block_.x + static_cast<double>(p.x) * block_.width,
                          block_.y + static_cast<double>(p.y) * block_.height);
}

void EyeCaster::look(std::span<const glm::vec2> at, std::vector<SurfacePoint>& seen,
                     RenderStatistics& counts) const {
  std::vector<Ray>& rays = looked_rays_;
  rays.clear();
  for (const glm::vec2& p : at) rays.push_back(ray_through(p));
  looked_hits_.resize(rays.size());
  scene_.rays.closest(rays, looked_hits_, faces_);
  counts.eye_rays += at.size();
  seen.assign(at.size(), {});
  for (std::size_t i = 0; i < at.size(); ++i) {
    if (looked_hits_[i].valid())
      seen[i] = surface_point(scene_.world, scene_.needs, looked_hits_[i], -rays[i].direction);
  }
}

Cover EyeCaster::cover(SampleId sample) const {
  const Hit& hit = hits_[sample];
  if (!hit.valid()) return Cover::none();
  // What is seen through a surface is not hidden by it.
  if (!opaque(sample)) return Cover::none();
  return cover_of(frame_, scene_.world, scene_.features, hit);
}

bool EyeCaster::opaque(SampleId sample) const {
  const Hit& hit = hits_[sample];
  if (!hit.valid()) return true;
  const Material& material = scene_.world.material_of(hit.triangle);
  return material.alpha_mode == AlphaMode::opaque && !(material.transmission > 0.0f);
}

std::uint32_t EyeCaster::surface(SampleId sample) const {
  // The background is a surface too.
  const Hit& hit = hits_[sample];
  return hit.valid() ? scene_.features.sheet(hit.triangle) : Hit::none;
}

Patch EyeCaster::patch_of(SampleId sample, double share) const {
  const Hit& hit = hits_[sample];
  // In double: the square of the cross product of sides of 1e-10 or 1e10 does not fit a float.
  const glm::dvec3 normal = glm::normalize(hit_plane(scene_.world, hit).normal());
  return patch_on_plane(spacing_, rays_[sample].direction, hit.t, glm::vec3(normal),
                        side_of(share));
}

void EyeCaster::gather_surfaces(int side) {
  const auto count = static_cast<std::size_t>(side * side);
  std::vector<glm::vec3> normals(count, glm::vec3(0.0f));
  std::vector<std::uint32_t> surfaces(count, Hit::none);
  groups_.reset(shader_.lights().size());
  for (std::size_t i = 0; i < count; ++i) {
    const Hit& hit = hits_[i];
    if (!hit.valid()) continue;
    const SurfacePoint point = surface_point(scene_.world, scene_.needs, hit, -rays_[i].direction);
    normals[i] = point.shading_normal;
    surfaces[i] = surface(static_cast<SampleId>(i));
    if (cast_shadows_)
      groups_.add(hit, point.position, point.geometric_normal,
                  patch_of(static_cast<SampleId>(i), 1.0));
  }
  bumps_.find(side, normals, surfaces, Hit::none);
  border_ = (block_.width - side) / 2;
}

// What bumps add: in a part of a pixel, as much less as its area is.
float EyeCaster::bump_error(SampleId sample, const LeafRegion& region) const {
  const auto width = static_cast<float>(block_.width);
  const float bump = bumps_.error(static_cast<int>(region.square.centre_u() * width) - border_,
                                  static_cast<int>(region.square.centre_v() * width) - border_);
  const Material& material = scene_.world.material_of(hits_[sample].triangle);
  if (bump == 0.0f || material.unlit) return 0.0f;
  const glm::vec3 c = glm::clamp(glm::vec3(material.base_color), 0.0f, 1.0f);
  const float part = region.square.side * width;
  return std::max({c.x, c.y, c.z}) * bump * part * part;
}

glm::vec3 EyeCaster::shade(SampleId sample, double weight, const LeafRegion& region,
                           RenderStatistics& counts) {
  const float root = viewer_.pixel / static_cast<float>(block_.width);
  shadows_.set_leaf({region, root, seed_of(points_[sample], block_), weight,
                     divided_ ? divided_ : even_around(sample, region)});
  leaf_ = {region, weight, seed_of(points_[sample], block_), points_[sample]};
  const PartShape shape = part_shape(region, points_[sample]);
  return shader_.radiance(viewer_.viewed(rays_[sample], hits_[sample], side_of(weight), shape),
                          *this, counts);
}

void EyeCaster::add(const Illumination& lit, glm::vec3& radiance, RenderStatistics& counts) {
  counted_shadows_.add(lit, radiance, counts);
}

bool EyeCaster::reflect(const Reflection& reflection, glm::vec3& radiance,
                        RenderStatistics& counts) {
  const ReflectedPyrays pyrays{scene_, viewer_, settings_, frame_, block_, work_, stop_};
  const Mirrored mirrored = pyrays.trace(reflection, leaf_, counts);
  if (!mirrored.followed) return false;
  radiance += mirrored.radiance;
  met_mirror_edge_ |= mirrored.split;
  return true;
}

}  // namespace asos
