#include "renderer/asos/eye_samples.h"

#include "renderer/asos/footprint_shape.h"
#include "renderer/reflections/own_side.h"
#include "renderer/sampling/random.h"
#include "renderer/shading/volume_boundary.h"
#include "renderer/world/hit_plane.h"

#include <algorithm>
#include <cmath>

namespace asos {

EyeSamples::EyeSamples(const EyeContext& eye) : eye_(&eye), faces_(culling_of(*eye.settings)) {}

SampleId EyeSamples::probe(std::span<const glm::vec2> points) {
  const std::size_t first = rays_.size();
  points_.insert(points_.end(), points.begin(), points.end());
  for (const glm::vec2& p : points) rays_.push_back(ray_through(p));
  hits_.resize(rays_.size());
  // Each run takes well under a millisecond, so that cancelling is quick.
  constexpr std::size_t run = 1024;
  for (std::size_t i = first; i < rays_.size() && !eye_->stop.stop_requested(); i += run) {
    const std::size_t count = std::min(run, rays_.size() - i);
    cast(std::span(rays_).subspan(i, count), std::span(hits_).subspan(i, count));
  }
  if (eye_->scene->features().cut_outs_unbounded()) find_cut_outs(first);
  eye_->counts->eye_rays += points.size();
  return static_cast<SampleId>(first);
}

// Finds the first hits of rays, behind the viewer's own mirror and on the viewer's side of glass.
void EyeSamples::cast(std::span<Ray> rays, std::span<Hit> hits) const {
  const RenderScene& scene = *eye_->scene;
  scene.rays().closest(rays, hits, faces_);
  if (eye_->viewer.mirror)
    pass_mirror(*eye_->viewer.mirror, scene.world(), scene.rays(), faces_, rays, hits);
  pass_own_side(eye_->viewer.passage, scene.world(), scene.rays(), faces_, rays, hits);
}

void EyeSamples::find_cut_outs(std::size_t first) {
  cut_out_.resize(rays_.size());
  met_.resize(rays_.size() - first);
  eye_->scene->rays().blockers(std::span(rays_).subspan(first), met_, -1,
                               eye_->scene->features().outlined());
  for (std::size_t i = first; i < rays_.size(); ++i) cut_out_[i] = met_[i - first].cut_out;
}

SampleId EyeSamples::add_unseen(glm::vec2 point) {
  points_.push_back(point);
  rays_.push_back(ray_through(point));
  hits_.emplace_back();
  if (!cut_out_.empty()) cut_out_.push_back(false);
  return static_cast<SampleId>(rays_.size() - 1);
}

// Hashes the sample's place, rounded to 2^-16 of the block. Finer bits are rounding errors that
// depend on the scene's scale.
std::uint64_t EyeSamples::seed(SampleId sample) const {
  const auto bits = [](float x) {
    return static_cast<std::uint64_t>(static_cast<std::uint32_t>(std::lround(x * 65536.0f)));
  };
  const PixelRect& block = eye_->block;
  const glm::vec2 at = points_[sample];
  const std::uint64_t place = static_cast<std::uint64_t>(static_cast<std::uint32_t>(block.x))
                                  << 32 |
                              static_cast<std::uint32_t>(block.y);
  return mix_bits(mix_bits(place) ^ (bits(at.x) << 32 | bits(at.y)));
}

OccluderPlane EyeSamples::cover(SampleId sample) const {
  // A transparent surface hides no boundaries behind it, so its cover is empty.
  const Hit& hit = hits_[sample];
  if (!hit.valid() || !opaque(sample)) return OccluderPlane::none();
  return occluder_of(*eye_->frame, eye_->scene->world(), eye_->scene->features(), hit);
}

std::uint32_t EyeSamples::surface(SampleId sample) const {
  const Hit& hit = hits_[sample];
  return hit.valid() ? eye_->scene->features().smooth_surface(hit.triangle) : Hit::none;
}

bool EyeSamples::opaque(SampleId sample) const {
  const Hit& hit = hits_[sample];
  if (!hit.valid()) return true;
  const Material& material = eye_->scene->world().material_of(hit.triangle);
  if (material.alpha_mode != AlphaMode::opaque && !eye_->scene->features().outlined(hit.triangle))
    return false;
  // Refraction at a volume's boundary displaces the surfaces behind it, and frosted glass blurs
  // them.
  const ViewContext& viewer = eye_->viewer;
  const bool frosted = is_frosted(material) && !material.metallic_roughness_texture.used();
  if (material.transmission > 0.0f && viewer.passage.in_medium()) {
    const auto boundary =
        VolumeBoundary::met(eye_->scene->world(), hit, rays_[sample], viewer.passage);
    if (boundary && boundary->hidden()) return false;
  }
  return !(material.transmission > 0.0f) ||
         ((bounds_volume(material) || frosted) && viewer.bounces < viewer.shader.reflections());
}

SurfacePoint EyeSamples::point(SampleId sample) const {
  return surface_point(eye_->scene->world(), eye_->scene->render_features, hits_[sample],
                       -rays_[sample].direction);
}

Patch EyeSamples::patch(SampleId sample, double share) const {
  const Hit& hit = hits_[sample];
  // In double: the square of the cross product of sides of 1e-10 or 1e10 does not fit a float.
  const glm::dvec3 normal = glm::normalize(hit_plane(eye_->scene->world(), hit).normal());
  return patch_on_plane(eye_->viewer.spacing, rays_[sample].direction, hit.t, glm::vec3(normal),
                        eye_->side_of(share));
}

void EyeSamples::show(const PyrayLeaf& part, Leaf& leaf) const {
  static_cast<PyrayLeaf&>(leaf) = part;
  leaf.border.assign(part.region.border.begin(), part.region.border.end());
  leaf.region.border = leaf.border;
  leaf.at = at(part.sample);
  leaf.seed = seed(part.sample);
  leaf.root_side = eye_->root_side();
  leaf.ray = ray(part.sample);
  leaf.hit = hit(part.sample);
  leaf.shape = footprint_shape(leaf.region, leaf.at);
  leaf.material = nullptr;
  leaf.behind_detail.clear();
  leaf.even = nullptr;
  leaf.observed = {};
  if (eye_->observed.observer && leaf.root == eye_->observed_root) {
    const Square& root = eye_->observed_square;
    leaf.observed = eye_->observed;
    leaf.observed.at = (leaf.at - glm::vec2(root.u, root.v)) / root.side;
    leaf.observed.weight = leaf.weight;
  }
  if (!leaf.hit.valid()) return;
  leaf.material = &eye_->scene->world().material_of(leaf.hit.triangle);
  leaf.point = point(part.sample);
  leaf.distance = eye_->viewer.spacing.distance(leaf.hit.t);
  // Compute the patch of a square with the leaf's area, and the patch of a square that reaches the
  // leaf's farthest corner. A shadow's edge may lie at the far end of a long, thin leaf.
  const Patch pixel = patch(part.sample, 1.0);
  const auto side = static_cast<float>(std::sqrt(leaf.weight));
  leaf.square = {side * pixel.right, side * pixel.down};
  glm::vec2 farthest(0.0f);
  leaf.region.for_each_edge([&](const BorderEdge& edge) {
    farthest = glm::max(farthest, glm::abs(edge.from - leaf.at));
  });
  const glm::vec2 reach = 2.0f * static_cast<float>(eye_->block.width) * farthest;
  leaf.around = {reach.x * pixel.right, reach.y * pixel.down};
}

void EyeSamples::look(std::span<const glm::vec2> at, std::vector<SurfacePoint>& seen,
                      RenderStatistics& counts) {
  looked_rays_.clear();
  for (const glm::vec2& p : at) looked_rays_.push_back(ray_through(p));
  looked_hits_.resize(at.size());
  cast(looked_rays_, looked_hits_);
  counts.eye_rays += at.size();
  seen.assign(at.size(), {});
  for (std::size_t i = 0; i < at.size(); ++i) {
    if (looked_hits_[i].valid())
      seen[i] = surface_point(eye_->scene->world(), eye_->scene->render_features, looked_hits_[i],
                              -looked_rays_[i].direction);
  }
}

Ray EyeSamples::ray_through(glm::vec2 p) const {
  const PixelRect& block = eye_->block;
  return eye_->viewer.view.ray(block.x + static_cast<double>(p.x) * block.width,
                               block.y + static_cast<double>(p.y) * block.height);
}

}  // namespace asos
