#include "renderer/shading/dfr.h"
#include "renderer/shading/gloss.h"
#include "renderer/shading/shade.h"

#include <algorithm>
#include <array>
#include <cmath>

// Reflection and transmission: their blur, and whether they are followed.

namespace asos {

bool Shader::follows(const ViewedRay& seen, glm::vec3 share) const {
  // A reflection that is invisible in any 8-bit picture is not worth a ray, whatever the light.
  constexpr float least_reflected = 1.0f / 256.0f;
  const float most = seen.throughput * std::max({share.x, share.y, share.z});
  return seen.bounces < settings_.reflections && most >= least_reflected;
}

std::optional<glm::vec3> Shader::mirror_width(const ViewedRay& seen, const SurfacePoint& point,
                                              float roughness, glm::vec3 reflected) const {
  if (!follows(seen, reflected)) return std::nullopt;
  // Bumps below the resolution of a normal map's mean add to the blur: squared slopes add up.
  const double bumps = static_cast<double>(point.spread.variance);
  const Dfr* own = own_dfr(point.triangle);
  const bool rough = !(roughness <= settings_.roughest_mirror);
  if (rough && !own) return std::nullopt;
  const Dfr* dfr = settings_.dfr ? settings_.dfr : own;
  if (!dfr) {
    const double alpha = static_cast<double>(roughness * roughness);
    const double all = std::sqrt(alpha * alpha + bumps);
    return glm::vec3(static_cast<float>(lobe_width(std::sqrt(all))));
  }
  const double cosine = static_cast<double>(glm::dot(point.shading_normal, -seen.ray.direction));
  const std::array<double, 3> ratio = dfr_at(*dfr, cosine, place_bits(point.position));
  const double by_bumps = lobe_width(std::sqrt(std::sqrt(bumps)));
  glm::vec3 width;
  for (int i = 0; i < 3; ++i) {
    const double by_ratio =
        static_cast<double>(seen.width) * (1.0 / ratio[static_cast<std::size_t>(i)] - 1.0);
    width[i] = static_cast<float>(std::hypot(by_ratio, by_bumps));
  }
  return width;
}

MirroredLights Shader::mirrored_lights(std::uint32_t triangle, float roughness) const {
  return roughness >= roughness_floor && mirrors_by_lobe(triangle, roughness)
             ? MirroredLights::patterned
             : MirroredLights::all;
}

bool Shader::mirrors_by_lobe(std::uint32_t triangle, float roughness) const {
  return !settings_.dfr && !own_dfr(triangle) && roughness >= least_lobe_roughness &&
         settings_.light_rule == LightRule::physical;
}

bool Shader::reflect(const ViewedRay& seen, const SurfacePoint& point,
                     const ViewedMaterial& material, const Layer& layer, LightTransport& transport,
                     glm::vec3& radiance, RenderStatistics& counts) const {
  if (settings_.reflections == 0) return false;
  const Lobe& lobe = material.lobe;
  if (!lobe.stretch.none() && !own_dfr(point.triangle) &&
      lobe.widest_roughness() > settings_.roughest_mirror)
    return false;
  const float roughness = lobe.round_roughness();
  const glm::vec3 reflected = layer.share * material.specular;
  const auto width = mirror_width(seen, point, roughness, reflected);
  if (!width) return false;
  const bool shows_lights = mirrored_lights(point.triangle, roughness) == MirroredLights::all;
  Reflection reflection{seen, point, layer.hit, *width, reflected, layer.number, shows_lights};
  reflection.passage = layer.passage;
  if (mirrors_by_lobe(point.triangle, roughness)) {
    reflection.lobe = &lobe;
    reflection.share = layer.share;
  }
  return transport.reflect(reflection, radiance, counts);
}

glm::vec3 Shader::add_refracted(const ViewedRay& seen, const SurfacePoint& point, float roughness,
                                const Layer& layer, glm::vec3 through, LightTransport& transport,
                                glm::vec3& radiance, RenderStatistics& counts) const {
  const double alpha = static_cast<double>(roughness * roughness);
  const double bumps = static_cast<double>(point.spread.variance);
  const auto mirrored = static_cast<float>(lobe_width(std::sqrt(std::sqrt(alpha * alpha + bumps))));
  Lobe facets;
  facets.roughness = roughness;
  const auto follow = [&](float ratio, float width, const VolumePath& passage, int colour,
                          glm::vec3 share) {
    if (layer.passage.straight || !follows(seen, share)) return false;
    Reflection refraction{seen,  point,        layer.hit,         glm::vec3(width),
                          share, layer.number, !seen.hides_lights};
    refraction.ratio = ratio;
    refraction.passage = passage;
    refraction.passage.colour = colour;
    if (roughness >= least_lobe_roughness) {
      refraction.lobe = &facets;
      refraction.share = share;
    }
    return transport.reflect(refraction, radiance, counts);
  };
  const int only = layer.passage.colour;
  if (!layer.boundary) {
    VolumePath beyond = layer.passage;
    ++beyond.refractions;
    return follow(1.0f, mirrored, beyond, only, through) ? glm::vec3(0.0f) : through;
  }
  // A facet that is turned by an angle turns the refracted ray by |1 - ratio| of it, and a
  // reflected one by twice the angle.
  const VolumeBoundary& boundary = *layer.boundary;
  const VolumePath beyond = boundary.refracted(layer.passage);
  const auto bend = [&](float ratio, int colour, glm::vec3 share) {
    return follow(ratio, 0.5f * mirrored * std::abs(1.0f - ratio), beyond, colour, share);
  };
  const glm::vec3 ratio = boundary.ratio;
  if (only >= 0 || ratio.x == ratio.z)
    return bend(boundary.ratio_of(layer.passage), only, through) ? glm::vec3(0.0f) : through;
  for (int c = 0; c < 3; ++c) {
    glm::vec3 share(0.0f);
    share[c] = through[c];
    if (bend(ratio[c], c, share)) through[c] = 0.0f;
  }
  return through;
}

}  // namespace asos
