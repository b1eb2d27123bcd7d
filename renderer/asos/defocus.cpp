#include "renderer/asos/defocus.h"

#include "renderer/pyray/tuning.h"
#include "renderer/shadows/shaft.h"
#include "renderer/world/hit_plane.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace asos {
namespace {

ErrorBudget refined(RenderSettings settings) {
  settings.asos.refine_shading = true;
  return ErrorBudget::of(settings);
}

}  // namespace

Defocus::Defocus(const BlockJob& job, const ViewContext& viewer, int side)
    : scene_(&job.scene),
      view_(&job.view),
      faces_(culling_of(job.settings)),
      spacing_(viewer.spacing),
      eye_(job.view.frame(0, 0, 1, 1).apex()),
      block_(job.block),
      side_(side),
      width_(static_cast<double>(viewer.pixel)),
      error_budget_(refined(job.settings)),
      sharpest_(LensTuning::sharp_radius * static_cast<double>(error_budget_.tolerance)),
      even_background_(
          viewer.shader.settings().backdrop.everywhere(viewer.shader.settings().sky).has_value()),
      pixels_(static_cast<std::size_t>(side) * static_cast<std::size_t>(side)) {
  std::vector<Ray> rays;
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x)
      rays.push_back(view_->ray(block_.x + x + 0.5, block_.y + y + 0.5));
  std::vector<Hit> hits(rays.size());
  job.scene.rays().closest(rays, hits, faces_);
  for (std::size_t i = 0; i < rays.size(); ++i) {
    measure(job.scene, rays[i], hits[i], pixels_[i]);
    if (pixels_[i].searched)
      reach_ = std::max(reach_, pixels_[i].most);
    else if (job.settings.method == Method::asos_published)
      reach_ = std::max(reach_, std::min(pixels_[i].radius, LensTuning::most_reach));
  }
  Box all;
  for (std::uint32_t i = 0; i < pixels_.size(); ++i)
    if (pixels_[i].searched) all.grow(far_end(i));
  may_meet_ = !all.empty() && meets_boundary(all);
}

// Across the picture of a plane, the circle of confusion varies linearly, as 1 / depth does.
void Defocus::measure(const RenderScene& scene, const Ray& ray, const Hit& hit,
                      Pixel& pixel) const {
  double slope = 0.0;
  double depth = std::numeric_limits<double>::infinity();
  if (hit.valid()) {
    depth = view_->depth(ray, hit.t);
    const HitPlane plane = hit_plane(scene.world(), hit);
    const glm::dvec3 normal = plane.normal();
    const double height = std::abs(glm::dot(normal, glm::dvec3(ray.at(hit.t)) - eye_));
    const double turn = std::abs(glm::dot(normal, glm::dvec3(spacing_.right))) +
                        std::abs(glm::dot(normal, glm::dvec3(spacing_.down)));
    // Change of the circle's radius per pixel across the picture.
    slope = view_->confusion_of_nearness(turn / height);
  }
  pixel.radius = view_->confusion(depth);
  // If the pixel itself is sharp, its neighbours need no search.
  if (is_sharp(pixel.radius + 0.5 * width_ * slope)) {
    pixel.most = pixel.radius + 0.5 * width_ * slope;
    pixel.searched = true;
    return;
  }
  if (!hit.valid() && !even_background_) return;
  if (!(slope < LensTuning::steepest)) return;
  pixel.most = LensTuning::bend_of_meshes * (pixel.radius + 0.5 * width_ * slope) / (1.0 - slope);
  pixel.searched = pixel.most <= LensTuning::most_reach;
}

// Returns the cross-section of all rays of a pixel at the depth in front of the focus plane where
// the circle of confusion has the pixel's largest radius.
Box Defocus::far_end(std::uint32_t root) const {
  const Pixel& pixel = pixels_[root];
  const double radius = std::max(pixel.most, sharpest_);
  const double depth = view_->depth_before_focus(radius);
  const double reach = 0.5 * width_ + radius;
  const double x = block_.x + static_cast<int>(root) % side_ + 0.5 - reach;
  const double y = block_.y + static_cast<int>(root) / side_ + 0.5 - reach;
  const Frame frame = view_->frame(x, y, 2.0 * reach, 2.0 * reach);
  Box box;
  for (const glm::dvec2 p : {glm::dvec2(0, 0), {1, 0}, {0, 1}, {1, 1}})
    box.grow(glm::vec3(frame.world({p.x, p.y, 1.0 / depth})));
  return box;
}

bool Defocus::meets_boundary(const Box& far_end) const {
  const auto radius = static_cast<float>(view_->lens().radius);
  const glm::vec3 across =
      radius * (glm::abs(glm::normalize(spacing_.right)) + glm::abs(glm::normalize(spacing_.down)));
  Box lens;
  lens.grow(glm::vec3(eye_) - across);
  lens.grow(glm::vec3(eye_) + across);
  return any_edge(scene_->features(), Shaft(lens, far_end),
                  [](const FeatureEdge& /*edge*/) { return true; });
}

bool Defocus::nothing_nearer(std::uint32_t root) const {
  return !may_meet_ || !meets_boundary(far_end(root));
}

// All rays of the pixel meet the surface within the search region if its circles of confusion there
// are no larger than the region's margin. Without boundaries, they are largest at its border or,
// nearer than the focus plane, where nothing_nearer finds edges of meshes.
bool Defocus::stays_within_reach(std::uint32_t root, RenderStatistics& counts) const {
  const Pixel& pixel = pixels_[root];
  const double reach = 0.5 * width_ + pixel.most;
  const double x = block_.x + static_cast<int>(root) % side_ + 0.5;
  const double y = block_.y + static_cast<int>(root) / side_ + 0.5;
  std::array<Ray, 8> rays;
  std::size_t count = 0;
  for (int i = -1; i <= 1; ++i)
    for (int j = -1; j <= 1; ++j)
      if (i != 0 || j != 0) rays[count++] = view_->ray(x + i * reach, y + j * reach);
  std::array<Hit, 8> hits;
  scene_->rays().closest(rays, hits, faces_);
  counts.eye_rays += count;
  for (std::size_t i = 0; i < count; ++i) {
    const double depth = hits[i].valid() ? view_->depth(rays[i], hits[i].t)
                                         : std::numeric_limits<double>::infinity();
    if (view_->confusion(depth) > pixel.most) return false;
  }
  return true;
}

double Defocus::leaf_side(std::uint32_t root) const {
  const double radius = std::min(pixels_[root].radius, LensTuning::most_reach);
  return std::sqrt(width_ * width_ + 12.0 * aperture_variance(view_->lens()) * radius * radius);
}

}  // namespace asos
