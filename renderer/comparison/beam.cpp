#include "renderer/comparison/exact_visibility.h"
#include "renderer/rays/back_face.h"
#include "renderer/samples/block_job.h"
#include "renderer/samples/sample_block.h"
#include "renderer/shading/shade.h"

#include <array>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

// Beam tracing (CGF'98 section 2.6), eye beams only: exact visibility, shading at points.

namespace asos {
namespace {

std::array<glm::dvec3, 3> corners_of(const World& world, std::uint32_t triangle) {
  const glm::uvec3 t = world.triangles[triangle];
  return {glm::dvec3(world.positions[t.x]), glm::dvec3(world.positions[t.y]),
          glm::dvec3(world.positions[t.z])};
}

/// The lights of one visible part, each at as many points as the settings have samples.
class PartLights final : public LightTransport {
 public:
  PartLights(SampledLights& lights, SamplePlaces& places, int samples)
      : lights_(lights), places_(places), samples_(samples) {}

  void add(const Illumination& lit, glm::vec3& /*radiance*/, RenderStatistics& counts) override {
    Illumination one = lit;
    const int samples = lit.light.extended() ? samples_ : 1;
    one.reflected /= static_cast<float>(samples);
    for (int i = 0; i < samples; ++i) {
      places_.start_sample(i);
      lights_.add(one, {}, counts);
    }
  }

 private:
  SampledLights& lights_;
  SamplePlaces& places_;
  int samples_;
};

class BlockTracer {
 public:
  explicit BlockTracer(const BlockJob& job)
      : job_(job),
        frame_(job.view.frame(job.block.x, job.block.y, block_size, block_size)),
        shader_(shader_of(job.scene, job.settings, job.view)),
        places_(grid_side(job.settings.sampling.spp), true),
        light_samples_(grid_side(job.settings.sampling.spp) * grid_side(job.settings.sampling.spp)),
        lights_(job.scene.rays(), places_) {
    const World& world = job.scene.world();
    std::optional<double> near, far;
    if (job.view.ahead()) near = nearness_of(job.view.near_depth());
    if (job.view.before()) far = nearness_of(job.view.far_depth());
    for (std::uint32_t t = 0; t < world.triangles.size(); ++t) {
      if (job.settings.cull && !shows_both_sides(world.material_of(t)) && shows_back(t)) continue;
      auto facet = make_facet(frame_, t, corners_of(world, t));
      if (!facet) continue;
      cut_facet(*facet, near, far);
      facets_.push_back(*facet);
    }
  }

  BlockResult run() {
    result_.tile.rect = job_.block;
    for (int y = 0; y < job_.block.height; ++y) {
      for (int x = 0; x < job_.block.width; ++x) {
        if (job_.stop.stop_requested()) return std::move(result_);
        trace_pixel(x, y);
      }
    }
    return std::move(result_);
  }

 private:
  [[nodiscard]] double nearness_of(double depth) const {
    return frame_.parallel() ? -depth : 1.0 / depth;
  }

  [[nodiscard]] bool shows_back(std::uint32_t triangle) const {
    const World& world = job_.scene.world();
    const glm::dvec3 towards =
        frame_.parallel() ? frame_.direction() : corners_of(world, triangle)[0] - frame_.apex();
    return meets_back(world, triangle, glm::vec3(towards));
  }

  void trace_pixel(int x, int y) {
    const glm::dvec2 corner = glm::dvec2(x, y) / double{block_size};
    const auto parts =
        visibility_.find(facets_, {corner, glm::dvec2(x + 1, y + 1) / double{block_size}});
    glm::dvec3 sum(0.0);
    double area = 0.0;
    for (const VisiblePart& part : parts) {
      const glm::vec3 radiance = shade(part);
      if (!std::isfinite(radiance.x + radiance.y + radiance.z)) {
        ++result_.statistics.rejected_samples;
        continue;
      }
      sum += part.area * glm::dvec3(radiance);
      area += part.area;
    }
    result_.statistics.split_pixels += parts.size() > 1;
    result_.tile.radiance.push_back(area > 0.0 ? glm::vec3(sum / area) : glm::vec3(0.0f));
    result_.tile.split_level.push_back(parts.size() > 1 ? 1 : 0);
    result_.tile.cause.push_back(SplitCause::none);
  }

  glm::vec3 shade(const VisiblePart& part) {
    const glm::dvec2 c = part.centroid;
    const PixelRect& block = job_.block;
    const Ray ray = job_.view.ray(block.x + c.x * block_size, block.y + c.y * block_size);
    const auto side = static_cast<float>(std::sqrt(part.area) * block_size);
    places_.start_pixel(block.x + static_cast<int>(c.x * block_size),
                        block.y + static_cast<int>(c.y * block_size));
    sums_.assign(1, glm::dvec3(0.0));
    PartLights transport(lights_, places_, light_samples_);
    const glm::vec3 radiance =
        shader_.radiance(ray, hit_of(part, ray), side, transport, result_.statistics);
    lights_.trace(sums_);
    return radiance + glm::vec3(sums_.front());
  }

  // The hit from the exact point, for no ray was cast.
  [[nodiscard]] Hit hit_of(const VisiblePart& part, const Ray& ray) const {
    Hit hit;
    if (part.facet == VisiblePart::background) return hit;
    const Facet& facet = facets_[part.facet];
    const auto corners = corners_of(job_.scene.world(), facet.triangle);
    const glm::dvec3 point =
        frame_.world({part.centroid.x, part.centroid.y, facet.q(part.centroid)});
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

  BlockJob job_;
  Frame frame_;
  Shader shader_;
  GridPlaces places_;
  int light_samples_;
  SampledLights lights_;
  std::vector<glm::dvec3> sums_;
  std::vector<Facet> facets_;
  ExactVisibility visibility_;
  BlockResult result_;
};

}  // namespace

/// Beam tracing (CGF'98 section 2.6): a pixel is the sum over its exactly visible polygons of area
/// times radiance at the centroid, whatever MAX, EPS and the samples asked for. The areas are exact
/// for opaque surfaces only: a cut-out or see-through surface hides with its whole triangles what
/// lies behind, but for what the shader adds along the centroid's ray. For small scenes: see
/// check_method.
BlockResult render_block_beam(const BlockJob& job) {
  return BlockTracer(job).run();
}

}  // namespace asos
