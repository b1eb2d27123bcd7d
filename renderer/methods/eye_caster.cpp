#include "renderer/methods/eye_caster.h"

#include "renderer/sampling/random.h"
#include "renderer/shading/unevenness.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <numbers>

namespace asos {
namespace {

// How far one sample may be off the mean of the patch that it stands for: EPS, or a quarter of a
// finest cell where that is more, so that MAX alone refines shading as it refines outlines; but no
// less than an eighth of one step of an 8-bit picture, which nobody sees and which would cost most.
float let_pass(const RenderSettings& settings) {
  if (!settings.refine_shading) return std::numeric_limits<float>::infinity();
  constexpr double invisible = 1.0 / 2048.0;
  return static_cast<float>(
      std::max({settings.eps, std::ldexp(1.0, -2 * (settings.max_level + 1)), invisible}));
}

ShadowSettings shadow_settings(const RenderScene& scene, const RenderSettings& settings,
                               float most_uneven) {
  ShadowSettings shadows;
  shadows.see_through = scene.needs.varying_opacity;
  shadows.quality = settings.shadow_quality;
  shadows.divisions = settings.shadow_divisions;
  shadows.max_level = settings.max_level;
  shadows.eps = settings.eps;
  shadows.exact_leaves = settings.leaf == Leaf::exact;
  shadows.most_uneven = most_uneven;
  return shadows;
}

std::uint64_t seed_of(glm::vec2 at, PixelRect block) {
  const auto bits = [](float x) {
    return static_cast<std::uint64_t>(std::bit_cast<std::uint32_t>(x));
  };
  const std::uint64_t place = static_cast<std::uint64_t>(static_cast<std::uint32_t>(block.x))
                                  << 32 |
                              static_cast<std::uint32_t>(block.y);
  return mix_bits(mix_bits(place) ^ (bits(at.x) << 32 | bits(at.y)));
}

// The side, in pixels, of the square that a leaf stands for, whatever its shape.
float side_of(double weight) {
  return static_cast<float>(std::sqrt(weight));
}

}  // namespace

EyeCaster::EyeCaster(const RenderScene& scene, const View& view, const RenderSettings& settings,
                     const Frame& frame, PixelRect block, std::size_t roots,
                     ShadowWorkspace& shadows, const std::stop_token& stop,
                     RenderStatistics& counts)
    : scene_(scene),
      shadow_scene_{scene.world, scene.features, scene.rays},
      view_(view),
      frame_(frame),
      block_(block),
      stop_(stop),
      counts_(counts),
      shader_(shader_of(scene, settings, view)),
      spacing_(PixelSpacing::of(view)),
      faces_(seen_faces(settings)),
      most_uneven_(let_pass(settings)),
      groups_(shadow_scene_),
      shadows_(shadow_scene_, shadow_settings(scene, settings, most_uneven_), frame, *this, groups_,
               shadows),
      sums_(roots),
      settings_(settings) {
  for (const PreparedLight& light : shader_.lights()) {
    const bool casts = settings.shadows && light.casts_shadows;
    cast_shadows_ |= casts;
    extended_lights_ |= casts && light.extended();
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
    scene_.rays.closest(std::span(rays_).subspan(i, count), std::span(hits_).subspan(i, count),
                        faces_);
  }
  counts_.eye_rays += points.size();
  return static_cast<SampleId>(first);
}

Ray EyeCaster::ray_through(glm::vec2 p) const {
  return view_.ray(block_.x + static_cast<double>(p.x) * block_.width,
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
  const glm::uvec3 t = scene_.world.triangles[hit.triangle];
  const glm::dvec3 p0(scene_.world.positions[t.x]);
  const glm::dvec3 e1 = glm::dvec3(scene_.world.positions[t.y]) - p0;
  const glm::dvec3 e2 = glm::dvec3(scene_.world.positions[t.z]) - p0;
  const glm::dvec3 p = p0 + static_cast<double>(hit.b1) * e1 + static_cast<double>(hit.b2) * e2;
  return Cover::plane(frame_, p, glm::cross(e1, e2), scene_.features.departure(hit.triangle));
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
  const glm::uvec3 t = scene_.world.triangles[hit.triangle];
  const glm::dvec3 p0(scene_.world.positions[t.x]);
  // In double: the square of the cross product of sides of 1e-10 or 1e10 does not fit a float.
  const glm::dvec3 normal = glm::normalize(glm::cross(
      glm::dvec3(scene_.world.positions[t.y]) - p0, glm::dvec3(scene_.world.positions[t.z]) - p0));
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
  const float pixel = 1.0f / static_cast<float>(block_.width);
  shadows_.set_leaf(
      {region, pixel, seed_of(points_[sample], block_), weight, even_around(sample, region)});
  return shader_.radiance(rays_[sample], hits_[sample], side_of(weight), counted_shadows_, counts);
}

void EyeCaster::leaf(std::uint32_t root, SampleId sample, double weight, const LeafRegion& region) {
  if (cancelled()) return;
  if (uneven_at_last(sample, weight, region) && add_samples(root, sample, region, weight) > 0)
    return;
  counted_shadows_.forget();
  const glm::vec3 radiance = shade(sample, weight, region, counts_);
  sums_[root].shadow_cut |= counted_shadows_.met_shadow_edge();
  if (root == logged_root_) log_leaf(sample, weight, radiance);
  if (!std::isfinite(radiance.x + radiance.y + radiance.z)) {
    ++counts_.rejected_samples;
    return;
  }
  sums_[root].radiance += weight * glm::dvec3(radiance);
  sums_[root].weight += weight;
}

void EyeCaster::log_leaf(SampleId sample, double weight, glm::vec3 radiance) {
  logged_leaves_.push_back({sample, points_[sample], weight});
  logged_radiance_.emplace(sample, radiance);
}

Caster::TakenOver EyeCaster::sample_tangle(std::uint32_t root, const Square& square,
                                           double weight) {
  if (!std::isfinite(most_uneven_)) return {};
  // A number for all of the samples, where nothing was met.
  const auto sample = static_cast<SampleId>(rays_.size());
  points_.emplace_back(square.centre_u(), square.centre_v());
  rays_.push_back(ray_through(points_.back()));
  hits_.emplace_back();
  return {add_samples(root, sample, {square, {}}, weight), sample};
}

// Half of what is let pass for a pixel, so that its parts, whose errors are independent, stay
// within it together; one sample for each finest cell at least, and four at most.
std::uint32_t EyeCaster::add_samples(std::uint32_t root, SampleId sample, const LeafRegion& region,
                                     double weight) {
  if (!sampler_) sampler_.emplace(scene_, view_, settings_, block_);
  RegionSampler::Goal goal;
  goal.standard_error = 0.5 * static_cast<double>(most_uneven_) / std::sqrt(weight);
  const double finest_cells = weight * std::ldexp(1.0, 2 * settings_.max_level);
  goal.least = std::bit_ceil(std::max(16u, static_cast<std::uint32_t>(finest_cells)));
  goal.most = std::bit_ceil(std::max(16u, static_cast<std::uint32_t>(4.0 * finest_cells)));
  const RegionSampler::Estimate found = sampler_->sample(region, goal, counts_);
  sums_[root].radiance += weight * found.mean;
  sums_[root].weight += found.samples > 0 ? weight : 0.0;
  if (root == logged_root_ && found.samples > 0) log_leaf(sample, weight, glm::vec3(found.mean));
  return found.samples;
}

Unevenness EyeCaster::uneven(SampleId sample, double share, const LeafRegion& region) const {
  const Hit& hit = hits_[sample];
  if (!hit.valid() || !std::isfinite(most_uneven_)) return Unevenness::none;
  const bool shading = shading_error(sample, share, region) > most_uneven_;
  if (extended_lights_ && !even_around(sample, region)) {
    if (shadow_uneven(sample, region)) return Unevenness::shadow;
    // What is split for its shading need not have its shadows found again for each part.
    if (shading && region.sides.empty() && opaque(sample) && nearly_flat(sample, share)) {
      even_.push_back({surface_point(scene_.world, scene_.needs, hit, -rays_[sample].direction),
                       region.square, std::vector<double>(shader_.lights().size(), -1.0)});
    }
  }
  return shading ? Unevenness::shading : Unevenness::none;
}

// Of what is not bounded, nor in shadow.
float EyeCaster::shading_error(SampleId sample, double share, const LeafRegion& region) const {
  const Hit& hit = hits_[sample];
  const Ray& ray = rays_[sample];
  const Patch patch = patch_of(sample, share);
  return midpoint_error(scene_.world, hit, ray.at(hit.t), -ray.direction, patch) +
         bump_error(sample, region) + light_error(sample, region);
}

// Whether a leaf would be split further for its shading, were there any levels left.
bool EyeCaster::uneven_at_last(SampleId sample, double share, const LeafRegion& region) const {
  const float finest = std::ldexp(1.0f, -settings_.max_level) / static_cast<float>(block_.width);
  return settings_.max_level > 0 && std::isfinite(most_uneven_) && !region.marginal &&
         hits_[sample].valid() && region.square.side < 1.5f * finest &&
         shading_error(sample, share, region) > most_uneven_;
}

// Whether the surface leaves its plane by little, beside the patch: what lies closer to a bent
// surface than that is not looked at for its shadows' edges (ShadowPyrays::midpoint_error).
bool EyeCaster::nearly_flat(SampleId sample, double share) const {
  const Patch patch = patch_of(sample, share);
  const float size = std::min(glm::length(patch.right), glm::length(patch.down));
  return 4.0f * scene_.features.departure(hits_[sample].triangle) < size;
}

// The even patch of the sample's surface that the region is a part of.
EvenPatch* EyeCaster::even_around(SampleId sample, const LeafRegion& region) const {
  const Square& s = region.square;
  const float u = s.centre_u(), v = s.centre_v();
  for (EvenPatch& even : even_) {
    const Square& all = even.square;
    if (u > all.u && u < all.u + all.side && v > all.v && v < all.v + all.side &&
        surface(sample) == scene_.features.sheet(even.middle.triangle))
      return &even;
  }
  return nullptr;
}

// The patch around the sample that holds all of the leaf: what is long and thin, or away from its
// sample, may have a shadow's edge at its far end.
Patch EyeCaster::patch_around(SampleId sample, const LeafRegion& region) const {
  glm::vec2 farthest(0.0f);
  region.for_each_side([&](const Side& side) {
    farthest = glm::max(farthest, glm::abs(side.from - points_[sample]));
  });
  const float per_pixel = 2.0f * static_cast<float>(block_.width);
  Patch patch = patch_of(sample, 1.0);
  patch.right *= farthest.x * per_pixel;
  patch.down *= farthest.y * per_pixel;
  return patch;
}

// How light from what has a size falls off across a leaf.
float EyeCaster::light_error(SampleId sample, const LeafRegion& region) const {
  const Hit& hit = hits_[sample];
  if (!extended_lights_ || scene_.world.material_of(hit.triangle).unlit) return 0.0f;
  const Patch patch = patch_around(sample, region);
  const SurfacePoint point =
      surface_point(scene_.world, scene_.needs, hit, -rays_[sample].direction);
  float error = 0.0f;
  for (const PreparedLight& light : shader_.lights())
    if (light.extended()) error += falloff_error(light, receiver_at(point), patch);
  return error;
}

bool EyeCaster::shadow_uneven(SampleId sample, const LeafRegion& region) const {
  const Hit& hit = hits_[sample];
  const Material& material = scene_.world.material_of(hit.triangle);
  if (material.unlit) return false;
  const Patch patch = patch_around(sample, region);
  const SurfacePoint point =
      surface_point(scene_.world, scene_.needs, hit, -rays_[sample].direction);
  const glm::vec3 c = glm::clamp(glm::vec3(material.base_color), 0.0f, 1.0f);
  const float reflected = std::max({c.x, c.y, c.z}) * std::numbers::inv_pi_v<float>;
  float error = 0.0f;
  const auto lights = shader_.lights();
  for (std::uint32_t i = 0; i < lights.size() && !(error > most_uneven_); ++i) {
    if (!lights[i].casts_shadows || !lights[i].extended()) continue;
    const CountForLight count(counts_, i);
    error += shadows_.midpoint_error(lights[i], i, point, patch, reflected, counts_);
  }
  return error > most_uneven_;
}

glm::vec3 EyeCaster::colour(std::uint32_t root) const {
  const Sum& sum = sums_[root];
  return sum.weight > 0.0 ? glm::vec3(sum.radiance / sum.weight) : glm::vec3(0.0f);
}

}  // namespace asos
