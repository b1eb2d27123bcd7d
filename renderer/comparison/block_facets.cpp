#include "renderer/comparison/block_facets.h"

#include "renderer/rays/back_face.h"

#include <array>
#include <cmath>
#include <optional>

namespace asos {

namespace {

std::array<glm::dvec3, 3> corners_of_triangle(const World& world, std::uint32_t triangle) {
  const glm::uvec3 t = world.triangles[triangle];
  return {glm::dvec3(world.positions[t.x]), glm::dvec3(world.positions[t.y]),
          glm::dvec3(world.positions[t.z])};
}

/// The lights of one visible part. Each light with an extent is sampled with `samples` points,
/// others with one.
class PartLights final : public LightTransport {
 public:
  PartLights(SampledLights& lights, PixelSampler& places, int samples)
      : lights_(lights), places_(places), samples_(samples) {}

  void add(const Illumination& lit, glm::vec3& /*radiance*/, RenderStatistics& counts) override {
    const int samples = lit.light.extended() ? samples_ : 1;
    const SampleWeight share{{}, glm::vec3(1.0f / static_cast<float>(samples))};
    for (int i = 0; i < samples; ++i) {
      places_.start_sample(i);
      lights_.add(lit, share, counts);
    }
  }

 private:
  SampledLights& lights_;
  PixelSampler& places_;
  int samples_;
};

}  // namespace

BlockFacets::BlockFacets(const BlockJob& job, int margin)
    : job_(job),
      corner_(job.block.x - margin, job.block.y - margin),
      pixel_(1.0 / (block_size + 2 * margin)),
      frame_(
          job.view.frame(corner_.x, corner_.y, block_size + 2 * margin, block_size + 2 * margin)),
      shader_(shader_of(job.scene, job.settings, job.view)),
      places_(grid_side(job.settings.sampling.spp), true),
      light_samples_(grid_side(job.settings.sampling.spp) * grid_side(job.settings.sampling.spp)),
      lights_(job.scene.rays(), places_) {
  const World& world = job.scene.world();
  std::optional<double> near, far;
  if (job.view.ahead()) near = nearness_of(job.view.near_depth());
  if (job.view.before()) far = nearness_of(job.view.far_depth());
  std::vector<std::size_t> begins;
  std::uint32_t last = 0;
  for (std::uint32_t t = 0; t < world.triangles.size(); ++t) {
    if (job.settings.cull && !shows_both_sides(world.material_of(t)) && shows_back(t)) continue;
    auto facet = make_facet(frame_, t, corners_of_triangle(world, t));
    if (!facet) continue;
    cut_facet(*facet, near, far);
    const std::uint32_t part = world.triangle_part[t];
    if (facets_.empty() || part != last) begins.push_back(facets_.size());
    last = part;
    facets_.push_back(*facet);
  }
  for (std::size_t i = 0; i < begins.size(); ++i) {
    const std::size_t end = i + 1 < begins.size() ? begins[i + 1] : facets_.size();
    objects_.push_back(std::span<const Facet>(facets_).subspan(begins[i], end - begins[i]));
  }
}

double BlockFacets::nearness_of(double depth) const {
  return frame_.parallel() ? -depth : 1.0 / depth;
}

bool BlockFacets::shows_back(std::uint32_t triangle) const {
  const World& world = job_.scene.world();
  const glm::dvec3 towards = frame_.parallel()
                                 ? frame_.direction()
                                 : corners_of_triangle(world, triangle)[0] - frame_.apex();
  return meets_back(world, triangle, glm::vec3(towards));
}

FrameRectangle BlockFacets::square(int x, int y, double side) const {
  const glm::dvec2 centre = glm::dvec2(job_.block.x + x + 0.5, job_.block.y + y + 0.5) - corner_;
  return {pixel_ * (centre - 0.5 * side), pixel_ * (centre + 0.5 * side)};
}

glm::vec3 BlockFacets::radiance(const Facet* facet, glm::dvec2 at, double side) {
  const glm::dvec2 place = corner_ + at / pixel_;
  const Ray ray = job_.view.ray(place.x, place.y);
  places_.start_pixel(static_cast<int>(std::floor(place.x)), static_cast<int>(std::floor(place.y)));
  sums_.assign(1, glm::dvec3(0.0));
  PartLights transport(lights_, places_, light_samples_);
  const Hit hit = facet ? hit_of(*facet, at, ray) : Hit{};
  const glm::vec3 own =
      shader_.radiance(ray, hit, static_cast<float>(side), transport, statistics_);
  lights_.trace(sums_);
  const glm::vec3 all = own + glm::vec3(sums_.front());
  if (std::isfinite(all.x + all.y + all.z)) return all;
  ++statistics_.rejected_samples;
  return glm::vec3(0.0f);
}

// Derives the hit from the exact point, since no ray was cast.
Hit BlockFacets::hit_of(const Facet& facet, glm::dvec2 at, const Ray& ray) const {
  Hit hit;
  const auto corners = corners_of_triangle(job_.scene.world(), facet.triangle);
  const glm::dvec3 point = frame_.world({at.x, at.y, facet.q(at)});
  const glm::dvec3 e1 = corners[1] - corners[0];
  const glm::dvec3 e2 = corners[2] - corners[0];
  const glm::dvec3 to_point = point - corners[0];
  const glm::dvec3 normal = glm::cross(e1, e2);
  const double area2 = glm::dot(normal, normal);
  hit.triangle = facet.triangle;
  hit.t = static_cast<float>(glm::dot(point - glm::dvec3(ray.origin), glm::dvec3(ray.direction)));
  hit.b1 = static_cast<float>(glm::dot(glm::cross(to_point, e2), normal) / area2);
  hit.b2 = static_cast<float>(glm::dot(glm::cross(e1, to_point), normal) / area2);
  return hit;
}

BlockResult BlockFacets::run(const std::function<glm::vec3(int x, int y, bool& split)>& render) {
  BlockResult result;
  result.tile.rect = job_.block;
  for (int y = 0; y < job_.block.height; ++y) {
    for (int x = 0; x < job_.block.width; ++x) {
      if (job_.stop.stop_requested()) return result;
      bool split = false;
      result.tile.radiance.push_back(render(x, y, split));
      statistics_.split_pixels += split ? 1 : 0;
      result.tile.split_level.push_back(split ? 1 : 0);
      result.tile.cause.push_back(SplitCause::none);
    }
  }
  result.statistics = statistics_;
  return result;
}

}  // namespace asos
