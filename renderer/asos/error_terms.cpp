#include "renderer/asos/error_terms.h"

#include "renderer/asos/highlight_rays.h"
#include "renderer/asos/textured_sight.h"
#include "renderer/geometry/largest.h"
#include "renderer/lights/lights_without_geometry.h"
#include "renderer/pyray/tuning.h"
#include "renderer/reflections/mirror_surface.h"
#include "renderer/shading/anisotropy.h"
#include "renderer/shading/brdf.h"
#include "renderer/shading/gloss.h"
#include "renderer/shading/unevenness.h"
#include "renderer/shadows/penumbra.h"
#include "renderer/shadows/shadow.h"
#include "renderer/world/hit_plane.h"
#include "renderer/world/surface_kind.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

namespace asos {
namespace {

bool any_light(const EyeContext& eye, const auto& holds) {
  const auto lights = eye.viewer.shader.lights();
  return std::any_of(lights.begin(), lights.end(), holds);
}

/// Returns whether sampling a surface's lobes covers all its reflection and transmission.
bool by_lobes_only(const EyeContext& eye, const Leaf& leaf) {
  const Material& material = *leaf.material;
  return !material.metallic_roughness_texture.used() && !material.coat.roughness_texture.used() &&
         eye.viewer.shader.mirrors_by_lobe(leaf.hit.triangle, least_mirror_roughness(material));
}

}  // namespace

ErrorTerms::ErrorTerms(const EyeContext& eye, const EyeSamples& samples,
                       const SelectedLights& selected_lights, const ShadowContext& shadows)
    : eye_(&eye),
      samples_(&samples),
      selected_lights_(&selected_lights),
      shadows_(&shadows),
      soft_shadows_(eye.settings->shadow.cast && any_light(eye,
                                                           [](const PreparedLight& light) {
                                                             return light.casts_shadows &&
                                                                    light.extended();
                                                           })),
      spots_(any_light(eye, [](const PreparedLight& light) { return light.cone_scale > 0.0; })) {}

void ErrorTerms::learn_normals(int side) {
  const auto count = static_cast<std::size_t>(side * side);
  std::vector<glm::vec3> normals(count, glm::vec3(0.0f));
  std::vector<std::uint32_t> surfaces(count, Hit::none);
  for (SampleId i = 0; i < count; ++i) {
    if (!samples_->hit(i).valid()) continue;
    normals[i] = samples_->point(i).shading_normal;
    surfaces[i] = samples_->surface(i);
  }
  normals_.find(side, normals, surfaces);
  border_ = (eye_->block.width - side) / 2;
}

// The centre's normal does not represent the leaf's. With soft shadows, leaves with normal maps are
// sampled, and so are those on curved meshes, except inside one triangle with a bright highlight.
// `gloss_of` returns the leaf's gloss term.
ErrorBound ErrorTerms::bumps_with(const Leaf& leaf, const auto& gloss_of) const {
  const RenderScene& scene = *eye_->scene;
  if (!leaf.is_lit()) return ErrorBound::none();
  if (eye_->mirrored() || scene.world().is_face(leaf.hit.triangle)) return ErrorBound::none();
  // The mean of a texture of directions is not the mean of the highlights in these directions.
  if (scene.render_features.textures && leaf.material->anisotropy.texture.used())
    return ErrorBound::unknown();
  if (!soft_shadows_) return ErrorBound::unknown(sparkles(leaf));
  if (scene.render_features.normal_maps && has_normal_map(*leaf.material))
    return ErrorBound::unknown();
  return ErrorBound::unknown(scene.features().deviation(leaf.hit.triangle) > 0.0f &&
                             (reaches_beyond_triangle(scene.world(), leaf.hit, leaf.square) ||
                              gloss_of().contrast <= ErrorBudget::usual_contrast));
}

ErrorBound ErrorTerms::shading(const Leaf& leaf) const {
  // Two terms use the highlights, whose rays are cast once.
  std::optional<ErrorBound> highlights;
  const auto gloss_once = [&]() -> const ErrorBound& {
    if (!highlights) highlights = gloss(leaf);
    return *highlights;
  };
  ErrorBound sum;
  const auto add = [&](const ErrorBound& term) {
    sum += term;
    return !sum.unbounded;
  };
  (void)(add(bumps_with(leaf, gloss_once)) && add(textures(leaf)) && add(bend(leaf)) &&
         add(falloff(leaf)) && add(gloss_once()) && add(mirror(leaf)));
  return sum;
}

ErrorBound ErrorTerms::bumps(const Leaf& leaf) const {
  return bumps_with(leaf, [&] { return gloss(leaf); });
}

// The mean transmittance of several textured layers is not the product of their means, and alpha
// blending has no outlines. The surfaces behind the first layer must have bounded errors, too.
ErrorBound ErrorTerms::layers(const Leaf& leaf) const {
  if (samples_->cut_out(leaf.sample)) return ErrorBound::unknown();
  if (!eye_->scene->render_features.alpha_blend || samples_->opaque(leaf.sample) ||
      surface_kind(*leaf.material) != SurfaceKind::blended)
    return ErrorBound::none();
  const ViewedRay seen = eye_->viewed(leaf);
  const std::vector<SurfaceLayer> layers = eye_->viewer.shader.layers(seen, *eye_->counts);
  double through = 1.0;
  for (std::size_t i = 0; i < layers.size(); ++i) {
    if (!(through > static_cast<double>(eye_->error_budget.tolerance))) break;
    if (i > 0 && varies_behind(leaf, seen, layers[i].hit)) return ErrorBound::unknown();
    through *= 1.0 - static_cast<double>(layers[i].opacity);
  }
  return ErrorBound::unknown(ErrorBudget::usual_contrast * std::sqrt(leaf.weight) *
                                 static_cast<double>(unevenness_of(layers)) >
                             static_cast<double>(eye_->error_budget.tolerance));
}

bool ErrorTerms::varies_behind(const Leaf& leaf, const ViewedRay& seen, const Hit& hit) const {
  const RenderScene& scene = *eye_->scene;
  const World& world = scene.world();
  if (world.is_face(hit.triangle)) return false;
  const Material& material = world.material_of(hit.triangle);
  const glm::dvec3 normal = glm::normalize(hit_plane(world, hit).normal());
  const Patch square = patch_on_plane(eye_->viewer.spacing, seen.ray.direction, hit.t,
                                      glm::vec3(normal), eye_->side_of(leaf.weight));
  if (textured_by_several(*eye_, hit, square) ||
      uneven_products(*eye_, seen.ray, hit, square, seen.shape, leaf.weight))
    return true;
  if (material.unlit || !soft_shadows_) return false;
  return (scene.render_features.normal_maps && has_normal_map(material)) ||
         scene.features().deviation(hit.triangle) > 0.0f;
}

ErrorBound ErrorTerms::textures(const Leaf& leaf) const {
  if (eye_->mirrored() || eye_->scene->world().is_face(leaf.hit.triangle))
    return ErrorBound::none();
  return ErrorBound::unknown(
      textured_by_several(*eye_, leaf.hit, leaf.square) ||
      strays_beyond_edges(*eye_, *samples_, leaf) ||
      recedes(*eye_, leaf.ray, leaf.hit, leaf.square) ||
      uneven_products(*eye_, leaf.ray, leaf.hit, leaf.square, leaf.shape, leaf.weight));
}

// Returns whether highlights of the neighbours may lie in the leaf. If triangles are smaller than
// the leaf, its own triangle does not represent them, but the spread of the neighbours' normals
// does.
bool ErrorTerms::sparkles(const Leaf& leaf) const {
  const RenderScene& scene = *eye_->scene;
  const Hit& hit = leaf.hit;
  if (scene.lights().empty() || !may_be_glossy(*leaf.material) ||
      !(scene.features().deviation(hit.triangle) > 0.0f) ||
      !reaches_beyond_triangle(scene.world(), hit, leaf.square))
    return false;
  SurfacePoint point = leaf.point;
  const NormalSpread own = normal_turn(scene.world(), hit, leaf.square, point.shading_normal);
  const auto across = static_cast<float>(std::sqrt(leaf.weight));
  const glm::ivec2 pixel = pixel_of(leaf.region);
  const float strays =
      across * normals_.strays(pixel.x, pixel.y, own.right / across, own.down / across);
  if (!(strays > 0.0f)) return false;
  // A uniform turn along an edge has a variance of 1/12 of its square.
  point.spread = {};
  point.spread.variance =
      (2.0f * strays * strays + glm::dot(own.right, own.right) + glm::dot(own.down, own.down)) /
      12.0f;
  const SurfaceMaterial seen = surface_material(scene.world(), scene.render_features, hit);
  float error = 0.0f;
  for (const Lobe& lobe : GlossyLobes(seen))
    error += glint_error(scene.lights(), lobe, point, leaf.to_viewer());
  return error > eye_->error_budget.tolerance;
}

ErrorBound ErrorTerms::bend(const Leaf& leaf) const {
  const RenderScene& scene = *eye_->scene;
  return ErrorBound::of(midpoint_error(scene.world(), scene.lights(), leaf.ray, leaf.hit,
                                       leaf.square, leaf.distance,
                                       eye_->settings->shadow.light_rule));
}

ErrorBound ErrorTerms::falloff(const Leaf& leaf) const {
  if (!(soft_shadows_ || spots_) || !leaf.is_lit()) return ErrorBound::none();
  const Receiver receiver = receiver_at(leaf.point);
  const auto lights = eye_->viewer.shader.lights();
  float error = 0.0f;
  for (std::size_t i = 0; i < lights.size(); ++i) {
    if (selected_lights_->holds(i)) continue;
    if (soft_shadows_ && lights[i].extended())
      error += falloff_error(lights[i], receiver, leaf.around);
    error += cone_error(lights[i], receiver, leaf.around);
  }
  return ErrorBound::of(error);
}

// Smooth surfaces have no highlights, since their reflections contain the lights.
ErrorBound ErrorTerms::gloss(const Leaf& leaf) const {
  const RenderScene& scene = *eye_->scene;
  const Hit& hit = leaf.hit;
  // Textures can only reduce roughness.
  const bool by_dfr = eye_->viewer.shader.settings().dfr || scene.dfr_of(hit.triangle);
  if (!leaf.is_lit() || !(by_dfr || may_be_glossy(*leaf.material))) return ErrorBound::none();
  const SurfacePoint& point = leaf.point;
  GlossyPatch glossy{point, normal_turn(scene.world(), hit, leaf.around, point.shading_normal),
                     leaf.around, leaf.to_viewer(), leaf.distance};
  const bool highlights =
      soft_shadows_ && !by_dfr && eye_->settings->shadow.light_rule == LightRule::physical;
  if (!highlights && !turns(glossy)) return ErrorBound::none();
  SurfaceMaterial seen = surface_material(scene.world(), scene.render_features, hit);
  if (seen.anisotropy.strength > 0.0f) {
    seen.stretch = lobe_stretch(scene.world(), hit, seen.anisotropy, seen.roughness,
                                point.shading_normal, glossy.to_viewer);
    glossy.stretch_turn = tangent_turn(scene.world(), hit, leaf.around, point.shading_normal);
  }
  glossy.white = static_cast<float>(1.0 / leaf.weight);
  ErrorBound all;
  for (const Lobe& lobe : GlossyLobes(seen)) {
    glossy.lobe = lobe;
    all += ErrorBound::of(reflectance_error(glossy));
    if (!highlights || !has_highlights(lobe.roughness)) continue;
    const HighlightError found = highlights_error(glossy);
    all += {found.error, found.contrast, false};
  }
  return all;
}

// Returns the error of the highlights of one lobe.
HighlightError ErrorTerms::highlights_error(const GlossyPatch& glossy) const {
  const auto lights = eye_->viewer.shader.lights();
  const float tolerance = eye_->error_budget.tolerance;
  const float negligible = 0.5f * tolerance / static_cast<float>(lights.size());
  HighlightError all;
  for (std::uint32_t i = 0; i < lights.size() && !(all.error > tolerance); ++i) {
    if (selected_lights_->holds(i)) continue;
    const HighlightError one = highlight_error(lights[i], glossy);
    if (one.error > negligible && !shows_highlight(*eye_, i, glossy.point, glossy.to_viewer))
      continue;
    all.error += one.error;
    all.contrast += one.contrast;
  }
  return all;
}

// The error grows with the squared angle, as with the leaf's area.
ErrorBound ErrorTerms::mirror(const Leaf& leaf) const {
  const double wide = mirrored_width(leaf);
  if (!(wide > 1.0)) return ErrorBound::none();
  return ErrorBound::of(wide * wide * static_cast<double>(eye_->error_budget.tolerance));
}

// Returns how far a curved mirror spreads the corner rays of the region, in units of the widest
// reflected pyray allowed.
double ErrorTerms::mirrored_width(const Leaf& leaf) const {
  const MirrorSettings& settings = eye_->settings->mirror;
  const ViewContext& viewer = eye_->viewer;
  const World& world = eye_->scene->world();
  if (!leaf.is_lit() || viewer.bounces >= viewer.shader.reflections() ||
      settings.curved == CurvedMirror::tangent)
    return 0.0;
  const Hit& hit = leaf.hit;
  const bool mirror =
      eye_->scene->dfr_of(hit.triangle) ||
      static_cast<double>(least_mirror_roughness(*leaf.material)) <= settings.roughest;
  const bool refracts = bounds_volume(*leaf.material);
  if (!(mirror || refracts) || by_lobes_only(*eye_, leaf)) return 0.0;
  const float side = leaf.region.square.side * static_cast<float>(eye_->block.width);
  const IncidentPyray pyray = pyray_around(viewer.spacing, leaf.ray, hit.t, side);
  const MirrorSurface surface = mirror_surface(world, hit, leaf.point, pyray, true);
  const double strayed = strayed_width(leaf, surface, side);
  if (!surface.bent()) return strayed;
  if (settings.curved == CurvedMirror::supersample) return std::numeric_limits<double>::infinity();
  const double widest = glm::radians(settings.widest_angle_deg);
  const double strictness = world.is_face(hit.triangle) ? 1.0 : LeafTuning::strictness_of_meshes;
  const double mirrored = mirror ? strictness * reflected_angle(pyray, surface) / widest : 0.0;
  if (!refracts) return std::max(strayed, mirrored);
  const auto boundary = VolumeBoundary::met(world, hit, leaf.ray, viewer.passage);
  const auto ratio = static_cast<double>(boundary->ratio_of(viewer.passage));
  return std::max({strayed, mirrored, reflected_angle(pyray, refracting(surface, ratio)) / widest});
}

// Returns how far the neighbours' normals are from those that the mirror's own triangle predicts,
// in units of a negligible deviation. One triangle does not represent the curvature where triangles
// are smaller than the patch.
double ErrorTerms::strayed_width(const Leaf& leaf, const MirrorSurface& mirror, float side) const {
  if (eye_->scene->world().is_face(leaf.hit.triangle)) return 0.0;
  const glm::ivec2 pixel = pixel_of(leaf.region);
  const auto across = static_cast<double>(side);
  const float strays = normals_.strays(pixel.x, pixel.y, glm::vec3(mirror.turn_right / across),
                                       glm::vec3(mirror.turn_down / across));
  return static_cast<double>(strays) * across / LeafTuning::negligible_strays;
}

// Returns the root that contains a region's centre, in the numbering of NormalVariation.
glm::ivec2 ErrorTerms::pixel_of(const LeafRegion& region) const {
  const auto width = static_cast<float>(eye_->block.width);
  return glm::ivec2(width * glm::vec2(region.square.centre_u(), region.square.centre_v())) -
         border_;
}

// Returns whether the light casts soft shadows and is not one of the sampled lights.
bool ErrorTerms::casts_soft_shadow(std::uint32_t light) const {
  const PreparedLight& asked = eye_->viewer.shader.lights()[light];
  return asked.casts_shadows && asked.extended() && !selected_lights_->holds(light);
}

// Each bound is for a shadow's edge along the whole patch at the worst place; half of it is
// expected. The loop ends once the sum exceeds the allowance.
ErrorBound ErrorTerms::penumbra(Leaf& leaf) const {
  if (!leaf.is_lit() || !(leaf.albedo() > 0.0f)) return ErrorBound::none();
  const float reflected = leaf.albedo() * std::numbers::inv_pi_v<float>;
  const auto level =
      static_cast<int>(std::lround(std::log2(eye_->root_side() / leaf.region.square.side)));
  const auto lights = eye_->viewer.shader.lights();
  const auto most = static_cast<double>(penumbra_tolerance(eye_->error_budget));
  double error = 0.0;
  for (std::uint32_t i = 0; i < lights.size() && !(error > most); ++i) {
    if (!casts_soft_shadow(i)) continue;
    const CountForLight count(*eye_->counts, i);
    const Penumbra found = find_penumbra(
        *shadows_, {lights[i], i, leaf.point, leaf.around, reflected, level, leaf.weight},
        *eye_->counts);
    error += static_cast<double>(found.error);
    if (found.too_detailed) leaf.behind_detail.push_back(i);
  }
  return ErrorBound::of(LeafTuning::expected_penumbra * error);
}

double ErrorTerms::cost_of_shadows() const {
  double price = 0.0;
  for (std::uint32_t i = 0; i < eye_->viewer.shader.lights().size(); ++i)
    if (casts_soft_shadow(i)) price += LeafCosts::part;
  return price;
}

bool ErrorTerms::may_misplace_light(const Leaf& leaf) const {
  const ViewContext& viewer = eye_->viewer;
  if (!leaf.shows_surface() || viewer.shader.lights_without_geometry().empty()) return false;
  const double spread =
      mirrored_width(leaf) * glm::radians(eye_->settings->mirror.widest_angle_deg);
  if (!(spread > 0.0)) return false;
  const glm::dvec3 from(leaf.point.position);
  const glm::dvec3 towards(glm::reflect(leaf.ray.direction, leaf.point.shading_normal));
  const auto bare = viewer.shader.lights_without_geometry();
  return std::any_of(bare.begin(), bare.end(), [&](std::uint32_t i) {
    const PreparedLight& light = viewer.shader.lights()[i];
    return largest(light.power) > 1.0f &&
           may_show(light, from, towards, LeafTuning::wider_mirrored * spread);
  });
}

}  // namespace asos
