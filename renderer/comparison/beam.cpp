#include "renderer/comparison/exact_visibility.h"
#include "renderer/comparison/method.h"
#include "renderer/rays/back_face.h"
#include "renderer/samples/sample_block.h"
#include "renderer/shading/shade.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
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

class BlockTracer final : private LightTransport {
 public:
  BlockTracer(const RenderScene& scene, const View& view, const RenderSettings& settings,
              PixelRect block)
      : world_(scene.world),
        view_(view),
        block_(block),
        frame_(view.frame(block.x, block.y, block_size, block_size)),
        shader_(shader_of(scene, settings, view)),
        places_(grid_side(settings.sampling.spp), true),
        light_samples_(grid_side(settings.sampling.spp) * grid_side(settings.sampling.spp)),
        lights_(scene.rays, places_) {
    for (std::uint32_t t = 0; t < world_.triangles.size(); ++t) {
      if (settings.cull && !world_.material_of(t).double_sided && shows_back(t)) continue;
      if (const auto facet = make_facet(frame_, t, corners_of(world_, t)))
        facets_.push_back(*facet);
    }
  }

  BlockResult run(const std::stop_token& stop) {
    result_.tile.rect = block_;
    for (int y = 0; y < block_.height; ++y) {
      for (int x = 0; x < block_.width; ++x) {
        if (stop.stop_requested()) return std::move(result_);
        trace_pixel(x, y);
      }
    }
    return std::move(result_);
  }

 private:
  [[nodiscard]] bool shows_back(std::uint32_t triangle) const {
    const glm::dvec3 towards =
        frame_.parallel() ? frame_.direction() : corners_of(world_, triangle)[0] - frame_.apex();
    return meets_back(world_, triangle, glm::vec3(towards));
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
    const Ray ray = view_.ray(block_.x + c.x * block_size, block_.y + c.y * block_size);
    const auto side = static_cast<float>(std::sqrt(part.area) * block_size);
    places_.start_pixel(block_.x + static_cast<int>(c.x * block_size),
                        block_.y + static_cast<int>(c.y * block_size));
    sums_.assign(1, glm::dvec3(0.0));
    const glm::vec3 radiance =
        shader_.radiance(ray, hit_of(part, ray), side, *this, result_.statistics);
    lights_.trace(sums_);
    return radiance + glm::vec3(sums_.front());
  }

  // Lights at as many points as the settings have samples.
  void add(const Illumination& lit, glm::vec3& radiance, RenderStatistics& counts) override {
    Illumination one = lit;
    const int samples = lit.light.extended() ? light_samples_ : 1;
    one.reflected /= static_cast<float>(samples);
    for (int i = 0; i < samples; ++i) {
      places_.start_sample(i);
      lights_.add(one, radiance, counts);
    }
  }

  // The hit from the exact point, for no ray was cast.
  [[nodiscard]] Hit hit_of(const VisiblePart& part, const Ray& ray) const {
    Hit hit;
    if (part.facet == VisiblePart::background) return hit;
    const Facet& facet = facets_[part.facet];
    const auto corners = corners_of(world_, facet.triangle);
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

  const World& world_;
  const View& view_;
  PixelRect block_;
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

BlockResult render_block_beam(const RenderScene& scene, const View& view,
                              const RenderSettings& settings, PixelRect block,
                              const std::stop_token& stop) {
  return BlockTracer(scene, view, settings, block).run(stop);
}

Result<void> check_method(const RenderScene& scene, const RenderSettings& settings) {
  if (settings.method == Method::beam && !scene.world.faces.empty())
    return unexpected(Error{"method", "beam is for triangles, and this scene has analytic shapes"});
  const std::size_t triangles = scene.world.triangles.size();
  if (settings.method != Method::beam || triangles <= most_beam_triangles) return {};
  return unexpected(
      Error{"method", fmt::format("beam is for scenes of up to {} triangles, and this one has {}",
                                  most_beam_triangles, triangles)});
}

}  // namespace asos
