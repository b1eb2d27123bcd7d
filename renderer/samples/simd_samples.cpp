#include "renderer/samples/simd_samples.h"

#include "renderer/kernels/surface_kernel.h"
#include "renderer/samples/sampled_lights.h"
#include "renderer/shading/environment.h"
#include "renderer/shading/sky.h"

#include <cmath>
#include <numbers>

namespace asos {
namespace {

bool usable(const World& world, const Shader& shader) {
  const ShadingSettings& settings = shader.settings();
  return SampledLights::takes_all(shader.lights(), settings.shadows) && !world.normals.empty() &&
         settings.backdrop.shows_light();
}

}  // namespace

SimdSamples::SimdSamples(const RenderScene& scene, const ViewContext& viewer)
    : world_(scene.world()),
      triangles_(static_cast<std::uint32_t>(world_.triangles.size())),
      needs_(scene.render_features),
      table_(*scene.plain),
      viewer_(viewer),
      mips_(viewer.shader.settings().mips),
      sky_(viewer.shader.settings().sky),
      path_(usable(world_, viewer.shader) ? SamplePath::lanes : SamplePath::lighting),
      viewer_path_(path_ != SamplePath::lanes   ? path_
                   : viewer.sees_bare_lights()  ? SamplePath::bare_light
                   : viewer.passage.in_medium() ? SamplePath::volume
                                                : SamplePath::lanes),
      reflections_(viewer.shader.reflections()),
      roughest_mirror_(viewer.shader.settings().roughest_mirror),
      picture_(sky_ ? sky_->picture_lobes() : Sky::PictureLobes{}),
      same_sky_(!sky_ || sky_->constant()) {
  if (!viewer.sees_bare_lights()) {
    const BackgroundRadiance environment;
    background_ =
        (viewer.bounces == 0 ? viewer.shader.settings().backdrop : environment).everywhere(sky_);
  }
  if (!same_sky_) return;
  constexpr glm::vec3 any(0.0f, 1.0f, 0.0f);
  sky_radiance_ = sky_ ? sky_->radiance(any) : background_radiance;
}

SamplePath SimdSamples::add(std::size_t index, const Ray& ray, const Hit& hit, float side) {
  if (!hit.valid()) return SamplePath::background;
  if (viewer_path_ != SamplePath::lanes) return viewer_path_;
  return add(index, ray, hit, side, viewer_.bounces, viewer_.hides_lights);
}

SamplePath SimdSamples::add_reflected(std::size_t index, const ViewedRay& seen) {
  if (!seen.hit.valid()) return SamplePath::background;
  if (path_ != SamplePath::lanes) return path_;
  if (seen.passage.in_medium()) return SamplePath::volume;
  if (seen.reflected() && !seen.hides_lights && seen.hit.triangle < triangles_) {
    const auto light = viewer_.shader.nearest_light_without_geometry(seen.ray);
    if (light && !(seen.hit.t < light->t)) return SamplePath::bare_light;
  }
  const SamplePath path =
      add(index, seen.ray, seen.hit, seen.side, seen.bounces, seen.hides_lights);
  if (path != SamplePath::lanes) return path;
  own_spacings_ = true;
  arrays_->spacing.set(count() - 1, *seen.spacing);
  return path;
}

SamplePath SimdSamples::add(std::size_t index, const Ray& ray, const Hit& hit, float side,
                            int bounces, bool hides_lights) {
  if (hit.triangle >= triangles_) return SamplePath::face;
  const SimdMaterial& material = table_.of(world_, hit.triangle);
  if (material.path != SamplePath::lanes) return material.path;
  if (!arrays_) {
    arrays_ = ThreadLocalCache<Arrays>::make();
    clear();
  }
  TriangleBatch& hits = arrays_->hits;
  const std::size_t i = hits.count++;
  const glm::uvec3 v = world_.triangles[hit.triangle];
  hits.corner_0.set(i, world_.positions[v.x]);
  hits.corner_1.set(i, world_.positions[v.y]);
  hits.corner_2.set(i, world_.positions[v.z]);
  hits.normal_0.set(i, world_.normals[v.x]);
  hits.normal_1.set(i, world_.normals[v.y]);
  hits.normal_2.set(i, world_.normals[v.z]);
  hits.set_hit(i, hit, ray, side);
  hits.textured[i] = material.textured ? 1.0f : 0.0f;
  hits.shiny[i] = material.shiny ? 1.0f : 0.0f;
  arrays_->material[i] = &material;
  arrays_->hit[i] = hit;
  arrays_->index[i] = index;
  arrays_->bounces[i] = bounces;
  arrays_->hides_lights[i] = hides_lights;
  if (material.looked_up) {
    arrays_->looked_up[arrays_->looked_up_count++] = i;
  } else {
    arrays_->materials.set(i, material.surface);
    arrays_->emission[i] = shown(i, material.surface.emission);
  }
  return SamplePath::lanes;
}

glm::vec3 SimdSamples::shown(std::size_t i, glm::vec3 emission) const {
  const std::uint32_t triangle = arrays_->hit[i].triangle;
  return viewer_.shader.shows_emission(arrays_->hides_lights[i], triangle) ? emission
                                                                           : glm::vec3(0.0f);
}

bool SimdSamples::shade(ShadingPoints& points) {
  if (own_spacings_ && mips_)
    place_surfaces(arrays_->hits, arrays_->spacing, arrays_->rest, points);
  else
    place_surfaces(arrays_->hits, mips_ ? &viewer_.spacing : nullptr, arrays_->rest, points);
  bool finite = true;
  for (std::size_t k = 0; k < arrays_->looked_up_count; ++k) {
    const std::size_t i = arrays_->looked_up[k];
    look_up_material(i, points);
    const glm::vec3 emission = arrays_->emission[i];
    finite = finite && std::isfinite(emission.x + emission.y + emission.z);
  }
  return view_materials(arrays_->rest, arrays_->materials, points) && finite;
}

void SimdSamples::look_up_material(std::size_t i, ShadingPoints& points) {
  const SimdMaterial& plain = *arrays_->material[i];
  const Hit& hit = arrays_->hit[i];
  const MipChains* mips = arrays_->hits.side[i] > 0.0f ? mips_ : nullptr;
  if (plain.normal_map) {
    SurfacePoint point = surface_at(arrays_->hits, arrays_->rest, points, hit.triangle, i);
    map_normal(world_, hit, mips, arrays_->rest.normal_side[i], point);
    points.normal.set(i, point.shading_normal);
    points.spread_variance[i] = point.spread.variance;
  }
  Footprint footprint = footprint_at(arrays_->hits, arrays_->rest, i);
  footprint.colours = own_spacings_ ? 1.0f : colours_;
  const SurfaceMaterial found = surface_material(world_, needs_, hit, footprint, mips);
  arrays_->materials.set(i, found);
  arrays_->emission[i] = shown(i, found.emission);
}

bool SimdSamples::reflect(std::size_t i, const ViewedRay& seen, ShadingPoints& points,
                          LightTransport& transport, RenderStatistics& counts) const {
  const float roughness = arrays_->materials.roughness[i];
  const SurfacePoint point =
      surface_at(arrays_->hits, arrays_->rest, points, arrays_->hit[i].triangle, i);
  glm::vec3 later(0.0f);
  if (!viewer_.shader.reflect(seen, point, viewed_material(i, points), transport, later, counts))
    return false;
  points.set_mirrored(i, viewer_.shader.mirrored_lights(arrays_->hit[i].triangle, roughness));
  return true;
}

bool SimdSamples::lobe_reflects_sky(std::size_t i) const {
  return !arrays_->mirrors[i] && arrays_->materials.specular.at(i) != glm::vec3(0.0f);
}

void SimdSamples::reflect_skies(const ShadingPoints& points) {
  if (!picture_.lobes) return;
  for (std::size_t i = 0; i < points.count; ++i) {
    const bool broad = arrays_->materials.roughness[i] >= SkyLobes::least_roughness;
    arrays_->sky.lobe_reflects[i] = broad && lobe_reflects_sky(i) ? 1.0f : 0.0f;
  }
  reflect_sky(picture_, arrays_->materials, points, arrays_->sky);
}

glm::vec3 SimdSamples::unlit_radiance(std::size_t i, const ShadingPoints& points) const {
  const glm::vec3 emission = arrays_->emission[i];
  const bool known =
      picture_.lobes && (arrays_->sky.lobe_reflects[i] > 0.0f || !lobe_reflects_sky(i));
  if (known) return emission + (arrays_->sky.diffuse.at(i) + arrays_->sky.by_lobe.at(i));
  const glm::vec3 specular =
      arrays_->mirrors[i] ? glm::vec3(0.0f) : arrays_->materials.specular.at(i);
  const glm::vec3 ambient = arrays_->materials.ambient.at(i);
  const float roughness = arrays_->materials.roughness[i];
  if (same_sky_)
    return emission +
           sky_radiance_ * (sky_visibility * ambient + mirrored_visibility(roughness) * specular);
  ViewedMaterial seen{};
  seen.ambient = ambient;
  seen.specular = specular;
  seen.roughness = roughness;
  return emission + reflected_sky(sky_, seen, points.normal.at(i), points.to_viewer.at(i));
}

ViewedMaterial SimdSamples::viewed_material(std::size_t i, const ShadingPoints& points) const {
  const glm::vec3 f0 = points.f0.at(i);
  ViewedMaterial seen{};
  seen.diffuse = std::numbers::pi_v<float> * points.diffuse.at(i);
  seen.falloff = points.falloff[i];
  seen.specular = arrays_->materials.specular.at(i);
  seen.f0 = f0;
  seen.f90 = glm::vec3(points.f90_less_f0.x[i] + f0.x);
  seen.roughness = arrays_->materials.roughness[i];
  return seen;
}

void SimdSamples::add_sky(std::size_t i, const ShadingPoints& points, LightTransport& transport,
                          RenderStatistics& counts) const {
  const ViewedMaterial seen = viewed_material(i, points);
  const SurfacePoint point =
      surface_at(arrays_->hits, arrays_->rest, points, arrays_->hit[i].triangle, i);
  const ViewedPoint view{point, points.to_viewer.at(i), points.n_dot_v[i]};
  glm::vec3 later(0.0f);
  (void)transport.add_sky({sky_, view, seen, arrays_->mirrors[i]}, later, counts);
}

}  // namespace asos
