#include "renderer/asos/refinement.h"

#include "renderer/asos/layered_sight.h"
#include "renderer/asos/part_shape.h"
#include "renderer/asos/textured_sight.h"
#include "renderer/geometry/largest.h"
#include "renderer/lights/lights_without_geometry.h"
#include "renderer/pyray/prices.h"
#include "renderer/reflections/mirror_surface.h"
#include "renderer/shading/brdf.h"
#include "renderer/shading/gloss.h"
#include "renderer/shading/unevenness.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace asos {
namespace {

/// By how much less a mesh may spread a pyray that it mirrors than an analytic shape: a triangle
/// tells of its own bend only, and its neighbours are bent otherwise.
constexpr double strictness_of_meshes = 8.0;

/// The most that a surface makes of light, by its base colour.
float brightest(const Material& material) {
  const glm::vec3 diffuse = diffuse_share(material) * glm::vec3(material.base_color);
  const glm::vec3 c = glm::clamp(diffuse + material.sheen.color, 0.0f, 1.0f);
  return std::max({c.x, c.y, c.z});
}

/// Whether samples of its lobes tell all that a surface mirrors and lets through, whatever its
/// textures say: no pyray does.
bool by_lobes_only(const EyeContext& eye, const Hit& hit) {
  const Material& material = eye.scene->world().material_of(hit.triangle);
  return !material.metallic_roughness_texture.used() && !material.coat.roughness_texture.used() &&
         eye.viewer.shader.mirrors_by_lobe(hit.triangle, least_mirror_roughness(material));
}

/// What a leaf of the material costs, in samples: those of mirrors are pyrays of their own.
double leaf_price(const Material& material) {
  return may_be_glossy(material) ? Prices::glossy_leaf : Prices::leaf;
}

}  // namespace

Refinement::Refinement(const EyeContext& eye, const EyeSamples& samples,
                       const WeakLights& weak_lights, const ShadowContext& shadows)
    : eye_(&eye),
      samples_(&samples),
      weak_lights_(&weak_lights),
      shadows_(eye, weak_lights, shadows),
      gloss_(eye, samples, weak_lights) {
  for (const PreparedLight& light : eye.viewer.shader.lights()) spots_ |= light.cone_scale > 0.0;
}

void Refinement::learn_normals(int side) {
  const auto count = static_cast<std::size_t>(side * side);
  std::vector<glm::vec3> normals(count, glm::vec3(0.0f));
  std::vector<std::uint32_t> surfaces(count, Hit::none);
  for (SampleId i = 0; i < count; ++i) {
    if (!samples_->hit(i).valid()) continue;
    normals[i] = samples_->point(i).shading_normal;
    surfaces[i] = samples_->surface(i);
  }
  normals_.find(side, normals, surfaces, Hit::none);
  border_ = (eye_->block.width - side) / 2;
}

LeafVerdict Refinement::judge(SampleId sample, double share, const LeafRegion& region) {
  if (!samples_->hit(sample).valid() || !eye_->budget.refines()) return {};
  const BySamples told = by_samples(sample, share, region);
  if (told == BySamples::only) return {Unevenness::none, 0, told};
  const bool glinting = glints(sample, share);
  if (!glinting && (told == BySamples::cheaper || better_sampled_at_once(sample, share, region)))
    return {Unevenness::none, 0, BySamples::cheaper};
  const float tolerance = eye_->budget.tolerance;
  const ShadingError found = glinting ? ShadingError{} : shading_error(sample, share, region);
  const double wide = mirrored_width(sample, region);
  // A patch whose parts share one look at the lights is right as a whole only: none of them alone
  // is sampled.
  const bool shared = shadows_.any() && even_around(sample, region);
  const auto sampled = [&](double price) {
    return !shared && eye_->budget.samples_suffice(share, price,
                                                   static_cast<double>(found.highlights.contrast));
  };
  const bool shading = wide > 1.0 || found.all() > tolerance;
  const double leaf = leaf_price(eye_->scene->world().material_of(samples_->hit(sample).triangle));
  if (shading && sampled(found.price_of_splitting(eye_->budget, wide, leaf, highlights_price())))
    return {Unevenness::shading, 0, BySamples::cheaper};
  LeafVerdict verdict;
  if (shadows_.any() && !shared) {
    const SoftShadows::Verdict shadow = judge_shadows(sample, share, region);
    if (shadow.error > 0.0f) {
      const double leaves = eye_->budget.leaves_of_bent(static_cast<double>(shadow.error));
      const bool cheaper = sampled(leaves * (leaf + shadows_.price()));
      return {Unevenness::shadow, 0, cheaper ? BySamples::cheaper : BySamples::no};
    }
    verdict.note = shadow.note;
    // A leaf that is split for its shading need not have its shadows found again for each part.
    if (shading && region.border.empty() && samples_->opaque(sample) && nearly_flat(sample, share))
      even_.push_back(even_patch(sample, region, verdict.note));
  }
  if (shading) verdict.uneven = Unevenness::shading;
  return verdict;
}

BySamples Refinement::by_samples(SampleId sample, double share, const LeafRegion& region) const {
  if (!eye_->budget.refines() || eye_->budget.max_level == 0 || region.marginal)
    return BySamples::no;
  if (samples_->cut_out(sample)) return BySamples::only;
  if (samples_->opaque(sample)) return BySamples::no;
  const LayeredSight seen = layered_sight(*eye_, *samples_, sample, share, region);
  if (seen.uneven_together) return BySamples::only;
  return seen.uneven_behind ? BySamples::cheaper : BySamples::no;
}

double Refinement::part_price() const {
  return Prices::part + shadows_.price();
}

// What their highlights add to it: each light is summed up over.
double Refinement::highlights_price() const {
  return Prices::highlight * static_cast<double>(eye_->viewer.shader.lights().size());
}

// Edges of shadows from lights of some size.
SoftShadows::Verdict Refinement::judge_shadows(SampleId sample, double share,
                                               const LeafRegion& region) {
  const Material& material = eye_->scene->world().material_of(samples_->hit(sample).triangle);
  if (material.unlit || !(brightest(material) > 0.0f)) return {};
  const SurfacePoint point = samples_->point(sample);
  const Patch patch = patch_around(sample, region);
  const float reflected = brightest(material) * std::numbers::inv_pi_v<float>;
  const auto level =
      static_cast<int>(std::lround(std::log2(eye_->root_side() / region.square.side)));
  return shadows_.judge(point, patch, reflected, level, share);
}

ShadingError Refinement::shading_error(SampleId sample, double share,
                                       const LeafRegion& region) const {
  const Hit& hit = samples_->hit(sample);
  const Ray& ray = samples_->ray(sample);
  const Patch patch = samples_->patch(sample, share);
  ShadingError found = gloss_.error(sample, share, patch_around(sample, region));
  found.error +=
      midpoint_error(eye_->scene->world(), eye_->scene->lights(), ray, hit, patch,
                     eye_->viewer.spacing.distance(hit.t), eye_->settings->shadow.light_rule) +
      normal_error(sample, region) + light_error(sample, region);
  return found;
}

// Normals that vary from pixel to pixel: in a part of a pixel, as much less as its area is.
float Refinement::normal_error(SampleId sample, const LeafRegion& region) const {
  const glm::ivec2 pixel = pixel_of(region);
  const float error = normals_.error(pixel.x, pixel.y);
  const Material& material = eye_->scene->world().material_of(samples_->hit(sample).triangle);
  if (error == 0.0f || material.unlit) return 0.0f;
  const float part = region.square.side * static_cast<float>(eye_->block.width);
  return brightest(material) * error * part * part;
}

// The root that a region's middle lies in, as NormalVariation counts them.
glm::ivec2 Refinement::pixel_of(const LeafRegion& region) const {
  const auto width = static_cast<float>(eye_->block.width);
  return glm::ivec2(width * glm::vec2(region.square.centre_u(), region.square.centre_v())) -
         border_;
}

// How the light of lights that have a size, or a cone, falls off across a leaf.
float Refinement::light_error(SampleId sample, const LeafRegion& region) const {
  const Hit& hit = samples_->hit(sample);
  if (!(shadows_.any() || spots_) || eye_->scene->world().material_of(hit.triangle).unlit)
    return 0.0f;
  const Patch patch = patch_around(sample, region);
  const Receiver receiver = receiver_at(samples_->point(sample));
  float error = 0.0f;
  const auto lights = eye_->viewer.shader.lights();
  for (std::size_t i = 0; i < lights.size(); ++i) {
    if (weak_lights_->holds(i)) continue;
    if (shadows_.any() && lights[i].extended()) error += falloff_error(lights[i], receiver, patch);
    error += cone_error(lights[i], receiver, patch);
  }
  return error;
}

// How far neighbours' normals are from what the mirror's own triangle says of them, in what may be
// neglected: where triangles are smaller than the patch, one of them does not tell how it bends.
double Refinement::strayed_width(const Hit& hit, const MirrorSurface& mirror,
                                 const LeafRegion& region, float side) const {
  constexpr double negligible = 0.02;
  if (eye_->scene->world().is_face(hit.triangle)) return 0.0;
  const glm::ivec2 pixel = pixel_of(region);
  const auto across = static_cast<double>(side);
  const float strays = normals_.strays(pixel.x, pixel.y, glm::vec3(mirror.turn_right / across),
                                       glm::vec3(mirror.turn_down / across));
  return static_cast<double>(strays) * across / negligible;
}

// How far a curved mirror spreads the region's corner rays, in what one reflected pyray may be wide
// (CGF'98 sections 5.2.1 to 5.2.4).
double Refinement::mirrored_width(SampleId sample, const LeafRegion& region) const {
  const MirrorSettings& settings = eye_->settings->mirror;
  const Viewer& viewer = eye_->viewer;
  if (viewer.bounces >= viewer.shader.reflections() || settings.curved == CurvedMirror::tangent)
    return 0.0;
  const Hit& hit = samples_->hit(sample);
  const Material& material = eye_->scene->world().material_of(hit.triangle);
  const bool mirror = eye_->scene->dfr_of(hit.triangle) ||
                      static_cast<double>(least_mirror_roughness(material)) <= settings.roughest;
  const bool refracts = bounds_volume(material);
  if (!(mirror || refracts) || material.unlit || by_lobes_only(*eye_, hit)) return 0.0;
  const SurfacePoint point = samples_->point(sample);
  const float side = region.square.side * static_cast<float>(eye_->block.width);
  const IncidentPyray pyray = pyray_around(viewer.spacing, samples_->ray(sample), hit.t, side);
  const MirrorSurface surface = mirror_surface(eye_->scene->world(), hit, point, pyray, true);
  const double strayed = strayed_width(hit, surface, region, side);
  if (strayed > 1.0) return strayed;
  if (!surface.bent()) return 0.0;
  if (settings.curved == CurvedMirror::supersample) return std::numeric_limits<double>::infinity();
  const double widest = glm::radians(settings.widest_angle_deg);
  const double strictness = eye_->scene->world().is_face(hit.triangle) ? 1.0 : strictness_of_meshes;
  const double mirrored = mirror ? strictness * reflected_angle(pyray, surface) / widest : 0.0;
  if (!refracts) return mirrored;
  const auto boundary =
      VolumeBoundary::met(eye_->scene->world(), hit, samples_->ray(sample), viewer.passage);
  const auto ratio = static_cast<double>(boundary->ratio_of(viewer.passage));
  return std::max(mirrored, reflected_angle(pyray, refracting(surface, ratio)) / widest);
}

bool Refinement::may_misplace_light(SampleId sample, const LeafRegion& region) const {
  constexpr double wider = 8.0;  // than the corner rays tell: the other's pyray is elsewhere
  const Viewer& viewer = eye_->viewer;
  const Hit& hit = samples_->hit(sample);
  if (!hit.valid() || viewer.shader.lights_without_geometry().empty()) return false;
  const double spread =
      mirrored_width(sample, region) * glm::radians(eye_->settings->mirror.widest_angle_deg);
  if (!(spread > 0.0)) return false;
  const glm::dvec3 from(samples_->point(sample).position);
  const glm::dvec3 towards(
      glm::reflect(samples_->ray(sample).direction, samples_->point(sample).shading_normal));
  const auto bare = viewer.shader.lights_without_geometry();
  return std::any_of(bare.begin(), bare.end(), [&](std::uint32_t i) {
    const PreparedLight& light = viewer.shader.lights()[i];
    return largest(light.power) > 1.0f && may_show(light, from, towards, wider * spread);
  });
}

// Whether that is too much of what shines through the boundary of a volume.
bool Refinement::refracts_too_widely(SampleId sample, const LeafRegion& region) const {
  const Hit& hit = samples_->hit(sample);
  return bounds_volume(eye_->scene->world().material_of(hit.triangle)) &&
         mirrored_width(sample, region) > 1.0;
}

bool Refinement::glints(SampleId sample, double share) const {
  const RenderScene& scene = *eye_->scene;
  const Hit& hit = samples_->hit(sample);
  if (!scene.needs.normal_maps || !hit.valid() || !eye_->budget.refines() || share <= 0.0 ||
      eye_->budget.max_level == 0)
    return false;
  const Material& material = scene.world().material_of(hit.triangle);
  if (!material.normal_texture.used() || material.unlit || scene.lights().empty()) return false;
  // Textures make roughness less only.
  if (!material.metallic_roughness_texture.used() && material.roughness >= least_broad_roughness)
    return false;
  const SampleExtent extent{&eye_->viewer.spacing, &scene.mips(), eye_->side_of(share)};
  const glm::vec3 to_viewer = -samples_->ray(sample).direction;
  const SurfacePoint point = surface_point(scene.world(), scene.needs, hit, to_viewer, extent);
  if (!(point.spread.variance > 0.0f)) return false;
  const SurfaceMaterial seen =
      surface_material(scene.world(), scene.needs, hit, point.footprint, &scene.mips());
  return glint_error(scene.lights(), material, seen.roughness, point, to_viewer) >
         eye_->budget.tolerance;
}

bool Refinement::better_sampled_at_once(SampleId sample, double share,
                                        const LeafRegion& region) const {
  constexpr float bright = 0.25f;
  const Hit& hit = samples_->hit(sample);
  const RenderScene& scene = *eye_->scene;
  if (eye_->mask || !eye_->budget.refines() || eye_->budget.max_level == 0 || region.marginal ||
      !hit.valid() || scene.world().is_face(hit.triangle))
    return false;
  const Patch square = samples_->patch(sample, share);
  if (textured_by_several(*eye_, hit, square) ||
      strays_beyond_edges(*eye_, *samples_, sample, share, region) ||
      recedes(*eye_, samples_->ray(sample), hit, square) ||
      uneven_products(*eye_, hit, square, part_shape(region, samples_->at(sample)), share))
    return true;
  const Material& material = scene.world().material_of(hit.triangle);
  if (material.unlit) return false;
  // No mean of what a texture turns is what its highlights are the mean of.
  if (scene.needs.textures && material.anisotropy.texture.used()) return true;
  if (!shadows_.any()) return false;
  if (scene.needs.normal_maps && has_normal_map(material)) return true;
  return scene.features().deviation(hit.triangle) > 0.0f &&
         (reaches_beyond_triangle(scene.world(), hit, square) ||
          gloss_.error(sample, share, patch_around(sample, region)).highlights.contrast <= bright);
}

bool Refinement::is_finest(const LeafRegion& region) const {
  const float finest = std::ldexp(eye_->viewer.pixel, -eye_->budget.max_level) /
                       static_cast<float>(eye_->block.width);
  return region.square.side < 1.5f * finest;
}

bool Refinement::uneven_at_last(SampleId sample, double share, const LeafRegion& region) const {
  return eye_->budget.max_level > 0 && eye_->budget.refines() && !region.marginal &&
         samples_->hit(sample).valid() && is_finest(region) &&
         (better_sampled_at_once(sample, share, region) ||
          shading_error(sample, share, region).better_sampled(eye_->budget) ||
          refracts_too_widely(sample, region));
}

// Whether the surface deviates from its plane by little, beside the patch: what lies closer to a
// bent surface than that is not looked at for its shadows' edges (find_penumbra).
bool Refinement::nearly_flat(SampleId sample, double share) const {
  const Hit& hit = samples_->hit(sample);
  const Patch patch = samples_->patch(sample, share);
  const float size = std::min(glm::length(patch.right), glm::length(patch.down));
  const glm::dvec3 at(samples_->ray(sample).at(hit.t));
  return 4.0 * eye_->scene->features().deviation(hit.triangle, at, size) <
         static_cast<double>(size);
}

EvenPatch Refinement::even_patch(SampleId sample, const LeafRegion& region,
                                 std::uint32_t note) const {
  const std::span<const std::uint32_t> lights = shadows_.saturated(note);
  return {samples_->point(sample),
          region.square,
          std::vector<Visibility>(eye_->viewer.shader.lights().size(), Visibility(-1.0)),
          {lights.begin(), lights.end()}};
}

// A part of it, and not only overlapping it as pixels with a wide filter do.
EvenPatch* Refinement::even_around(SampleId sample, const LeafRegion& region) {
  const Square& s = region.square;
  const float rounding = 1e-3f * s.side;
  for (EvenPatch& even : even_) {
    const Square& all = even.square;
    const float wider = all.side - s.side + rounding;
    if (s.u >= all.u - rounding && s.u <= all.u + wider && s.v >= all.v - rounding &&
        s.v <= all.v + wider &&
        samples_->surface(sample) == eye_->scene->features().sheet(even.middle.triangle))
      return &even;
  }
  return nullptr;
}

// The patch around the sample that holds all of the leaf: what is long and thin, or away from its
// sample, may have a shadow's edge at its far end.
Patch Refinement::patch_around(SampleId sample, const LeafRegion& region) const {
  glm::vec2 farthest(0.0f);
  region.for_each_edge([&](const BorderEdge& edge) {
    farthest = glm::max(farthest, glm::abs(edge.from - samples_->at(sample)));
  });
  const float per_pixel = 2.0f * static_cast<float>(eye_->block.width);
  Patch patch = samples_->patch(sample, 1.0);
  patch.right *= farthest.x * per_pixel;
  patch.down *= farthest.y * per_pixel;
  return patch;
}

}  // namespace asos
