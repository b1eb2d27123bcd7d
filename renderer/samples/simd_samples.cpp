#include "renderer/samples/simd_samples.h"

#include "renderer/kernels/surface_kernel.h"
#include "renderer/samples/sampled_lights.h"
#include "renderer/shading/anisotropy.h"
#include "renderer/shading/environment.h"
#include "renderer/shading/sky.h"

#include <cmath>
#include <numbers>

namespace asos {
namespace {

bool usable(const Shader& shader) {
  const ShadingSettings& settings = shader.settings();
  return SampledLights::takes_all(shader.lights(), settings.shadows) &&
         settings.backdrop.shows_light();
}

}  // namespace

SimdSamples::SimdSamples(const RenderScene& scene, const ViewContext& viewer)
    : world_(scene.world()),
      rays_(scene.rays()),
      triangles_(static_cast<std::uint32_t>(world_.triangles.size())),
      needs_(scene.render_features),
      table_(*scene.plain),
      viewer_(viewer),
      mips_(viewer.shader.settings().mips),
      sky_(viewer.shader.settings().sky),
      path_(usable(viewer.shader) ? SamplePath::lanes : SamplePath::lighting),
      viewer_path_(path_ == SamplePath::lanes && viewer.sees_bare_lights() ? SamplePath::bare_light
                                                                           : path_),
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

void SimdSamples::clear() {
  own_spacings_ = false;
  if (!arrays_) return;
  arrays_->hits.count = arrays_->looked_up_count = 0;
  arrays_->volumes.clear();
  arrays_->layered.clear();
  arrays_->passages.clear();
}

SamplePath SimdSamples::add(std::size_t index, const Ray& ray, const Hit& hit, float side) {
  if (!hit.valid()) return SamplePath::background;
  if (viewer_path_ != SamplePath::lanes) return viewer_path_;
  return add(index, ray, hit, side,
             {viewer_.bounces, viewer_.hides_lights, colours_, viewer_.passage, ray.t_near});
}

SamplePath SimdSamples::add_reflected(std::size_t index, const ViewedRay& seen) {
  if (!seen.hit.valid()) return SamplePath::background;
  if (path_ != SamplePath::lanes) return path_;
  if (seen.hit.triangle == seen.passed.last) return SamplePath::coplanar;
  if (seen.reflected() && !seen.hides_lights && seen.hit.triangle < triangles_) {
    const auto light = viewer_.shader.nearest_light_without_geometry(seen.ray);
    if (light && !(seen.hit.t < light->t)) return SamplePath::bare_light;
  }
  const std::size_t first = count();
  const SamplePath path =
      add(index, seen.ray, seen.hit, seen.side,
          {seen.bounces, seen.hides_lights, seen.colours, seen.passage, seen.start()});
  if (path != SamplePath::lanes) return path;
  own_spacings_ = true;
  for (std::size_t i = first; i < count(); ++i) arrays_->spacing.set(i, *seen.spacing);
  return path;
}

SamplePath SimdSamples::add(std::size_t index, const Ray& ray, const Hit& hit, float side,
                            const RayState& state) {
  if (hit.triangle >= triangles_) return SamplePath::face;
  const SimdMaterial& material = table_.of(world_, hit.triangle);
  if (material.path != SamplePath::lanes) return material.path;
  if (material.blended) {
    if (!takes_blended_) return SamplePath::blended;
    if (rays_.is_coplanar(hit)) return SamplePath::coplanar;
  }
  if (!arrays_) {
    arrays_ = ThreadLocalCache<Arrays>::make();
    clear();
  }
  const std::size_t top = arrays_->hits.count;
  for (std::size_t k = 0; k < material.layers.size(); ++k)
    add_point(index, ray, hit, side, state, material);
  if (material.blended || state.passage.in_medium()) meet_volume(top, ray, state);
  if (material.looked_up || material.layered()) {
    arrays_->looked_up[arrays_->looked_up_count++] = top;
  } else {
    set_material(top, material.surface);
  }
  return SamplePath::lanes;
}

void SimdSamples::add_point(std::size_t index, const Ray& ray, const Hit& hit, float side,
                            const RayState& state, const SimdMaterial& material) {
  TriangleBatch& hits = arrays_->hits;
  const std::size_t i = hits.count++;
  const glm::uvec3 v = world_.triangles[hit.triangle];
  hits.corner_0.set(i, world_.positions[v.x]);
  hits.corner_1.set(i, world_.positions[v.y]);
  hits.corner_2.set(i, world_.positions[v.z]);
  const bool flat = world_.normals.empty();
  hits.normal_0.set(i, flat ? glm::vec3(0.0f) : world_.normals[v.x]);
  hits.normal_1.set(i, flat ? glm::vec3(0.0f) : world_.normals[v.y]);
  hits.normal_2.set(i, flat ? glm::vec3(0.0f) : world_.normals[v.z]);
  hits.set_hit(i, hit, ray, side);
  hits.textured[i] = material.textured ? 1.0f : 0.0f;
  hits.shiny[i] = material.shiny ? 1.0f : 0.0f;
  arrays_->material[i] = &material;
  arrays_->hit[i] = hit;
  arrays_->index[i] = index;
  arrays_->bounces[i] = state.bounces;
  arrays_->hides_lights[i] = state.hides_lights;
  arrays_->colours[i] = state.colours;
  arrays_->share[i] = glm::vec3(1.0f);
  arrays_->volume[i] = -1;
}

// Finds the boundary of a volume at a hit, and attenuates the hit's points in the medium in front.
void SimdSamples::meet_volume(std::size_t top, const Ray& ray, const RayState& state) {
  const VolumePath& passage = state.passage;
  const SimdMaterial& material = *arrays_->material[top];
  const Hit& hit = arrays_->hit[top];
  const auto boundary =
      material.blended ? VolumeBoundary::met(world_, hit, ray, passage) : std::nullopt;
  // The inner side of a boundary gives the medium in front of it, wherever the ray started.
  const VolumePath before = boundary && !boundary->entering ? boundary->incident(passage) : passage;
  const glm::vec3 left =
      before.in_medium() ? before.left_after(hit.t - state.start) : glm::vec3(1.0f);
  if (boundary) arrays_->volumes.push_back({*boundary, before});
  for (std::size_t k = 0; k < material.layers.size(); ++k) {
    arrays_->share[top + k] = left;
    if (boundary) arrays_->volume[top + k] = static_cast<int>(arrays_->volumes.size()) - 1;
  }
}

glm::vec3 SimdSamples::shown(std::size_t i, glm::vec3 emission) const {
  if (emission == glm::vec3(0.0f)) return emission;
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
  look_up_textures();
  for (std::size_t k = 0; k < arrays_->looked_up_count; ++k) {
    const std::size_t top = arrays_->looked_up[k];
    look_up_material(top, points);
    const glm::vec3 emission = arrays_->emission[top + arrays_->material[top]->layers.base()];
    finite = finite && std::isfinite(emission.x + emission.y + emission.z);
  }
  finite = view_materials(arrays_->rest, arrays_->materials, points) && finite;
  for (const LayeredHit& hit : arrays_->layered) {
    finite = view_layers(hit, points) && finite;
    weigh_layers(hit, points);
  }
  for (std::size_t i = 0; i < count(); ++i) {
    const glm::vec3 share = arrays_->share[i];
    finite = finite && std::isfinite(share.x + share.y + share.z);
  }
  return finite;
}

SurfacePoint SimdSamples::point(std::size_t i, const ShadingPoints& points) const {
  return surface_at(arrays_->hits, arrays_->rest, points, arrays_->hit[i].triangle, i);
}

bool SimdSamples::reflect(std::size_t i, const ViewedRay& seen, ShadingPoints& points,
                          LightTransport& transport, RenderStatistics& counts) const {
  const Shader& shader = viewer_.shader;
  const Hit& hit = arrays_->hit[i];
  const ViewedMaterial material = viewed_material(i, points);
  const MetVolume* volume = volume_of(i);
  const Shader::Layer layer{share(i), seen.passed.count.layers(), hit,
                            volume ? volume->reflected() : seen.passage};
  glm::vec3 later(0.0f);
  if (!shader.reflect(seen, point(i, points), material, layer, transport, later, counts))
    return false;
  points.set_mirrored(i, shader.mirrored_lights(hit.triangle, material.lobe.round_roughness()));
  return true;
}

bool SimdSamples::lobe_reflects_sky(std::size_t i) const {
  return !arrays_->mirrors[i] && arrays_->materials.specular.at(i) != glm::vec3(0.0f);
}

void SimdSamples::reflect_skies(const ShadingPoints& points) {
  if (!picture_.lobes) return;
  for (std::size_t i = 0; i < points.count; ++i) {
    const bool broad = arrays_->materials.roughness[i] >= SkyLobes::least_roughness;
    const bool round = points.stretch.at(i) == glm::vec3(0.0f);
    arrays_->sky.lobe_reflects[i] = broad && round && lobe_reflects_sky(i) ? 1.0f : 0.0f;
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
  seen.lobe.roughness = roughness;
  seen.lobe.stretch.along = points.stretch.at(i);
  return emission + reflected_sky(sky_, seen, points.normal.at(i), points.to_viewer.at(i));
}

ViewedMaterial SimdSamples::viewed_material(std::size_t i, const ShadingPoints& points) const {
  const glm::vec3 f0 = points.f0.at(i);
  ViewedMaterial seen{};
  seen.diffuse = std::numbers::pi_v<float> * points.diffuse.at(i);
  seen.falloff = points.falloff[i];
  seen.specular = arrays_->materials.specular.at(i);
  seen.lobe = {f0, glm::vec3(points.f90_less_f0.x[i] + f0.x), arrays_->materials.roughness[i]};
  seen.ambient = arrays_->materials.ambient.at(i);
  seen.lobe.sheen = points.sheen[i];
  seen.lobe.stretch.along = points.stretch.at(i);
  return seen;
}

glm::vec3 SimdSamples::add_sky(std::size_t i, const ShadingPoints& points,
                               LightTransport& transport, RenderStatistics& counts) const {
  const ViewedMaterial seen = viewed_material(i, points);
  const SurfacePoint place = point(i, points);
  const ViewedPoint view{place, points.to_viewer.at(i), points.n_dot_v[i]};
  glm::vec3 radiance(0.0f);
  (void)transport.add_sky({sky_, view, seen, arrays_->mirrors[i], share(i)}, radiance, counts);
  return radiance;
}

}  // namespace asos
