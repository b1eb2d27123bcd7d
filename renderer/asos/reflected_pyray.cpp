#include "renderer/asos/reflected_pyray.h"

#include "renderer/asos/eye_caster.h"
#include "renderer/asos/reflected_hit.h"
#include "renderer/lights/lights_without_geometry.h"
#include "renderer/pyray/tuning.h"
#include "renderer/reflections/mirror_surface.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <optional>

namespace asos {
namespace {

constexpr Square whole_square{0.0f, 0.0f, 1.0f};

std::optional<Segment> projected(const Frame& frame, glm::dvec3 a, glm::dvec3 b) {
  glm::dvec3 p = frame.homogeneous(a), q = frame.homogeneous(b);
  if (!frame.parallel()) {
    const double least = 1e-6 * std::max(std::abs(p.z), std::abs(q.z));
    if (p.z < least && q.z < least) return std::nullopt;
    if (p.z < least) p += (q - p) * ((least - p.z) / (q.z - p.z));
    if (q.z < least) q += (p - q) * ((least - q.z) / (p.z - q.z));
  }
  const FramePoint from = frame.project(p), to = frame.project(q);
  Segment s;
  s.u0 = static_cast<float>(from.u), s.v0 = static_cast<float>(from.v);
  s.u1 = static_cast<float>(to.u), s.v1 = static_cast<float>(to.v);
  return s;
}

// Adds the part of a line within the square.
void add_line(std::vector<BorderEdge>& outline, const Segment& s) {
  const SegmentPart<float> c = clip(s, {0.0f, 0.0f, 1.0f});
  if (c.empty()) return;
  const glm::vec2 p(s.u0, s.v0), d(s.u1 - s.u0, s.v1 - s.v0);
  outline.push_back({p + c.t0 * d, p + c.t1 * d});
}

// Adds the outlines of lights that are visible in mirrors only, since the scene has no edges for
// them.
void add_lights(std::vector<BorderEdge>& outline, const Frame& frame, const ViewContext& viewer) {
  if (!viewer.sees_bare_lights()) return;
  for (const std::uint32_t i : viewer.shader.lights_without_geometry()) {
    const PreparedLight& light = viewer.shader.lights()[i];
    const auto apex = frame.parallel() ? std::nullopt : std::optional(frame.apex());
    for (const auto& light_outline : light_outlines(light, apex, frame.direction())) {
      for (std::size_t k = 0; k < light_outline.size(); ++k) {
        const glm::dvec3 from = light_outline[k];
        const glm::dvec3 to = light_outline[(k + 1) % light_outline.size()];
        if (const auto s = projected(frame, from, to)) add_line(outline, *s);
      }
    }
  }
}

std::optional<Horizon> horizon_of(const MirroredPyray& pyray, const MirrorSurface& surface) {
  const PyrayPicture& p = pyray.picture;
  const glm::dvec3 n = surface.geometric;
  const glm::dvec3 middle = p.corner + 0.5 * (p.right + p.down);
  const Horizon horizon{glm::dot(middle, n), glm::dot(p.right, n), glm::dot(p.down, n)};
  const bool above = horizon.height > 0.5 * (std::abs(horizon.right) + std::abs(horizon.down));
  return above ? std::nullopt : std::optional(horizon);
}

std::vector<BorderEdge> outline_in(const LeafRegion& region, const Bounds2& part) {
  std::vector<BorderEdge> outline;
  const glm::vec2 size = part.hi - part.lo;
  for (const BorderEdge& edge : region.border)
    outline.push_back({(edge.from - part.lo) / size, (edge.to - part.lo) / size});
  return outline;
}

glm::vec2 random_place(std::uint64_t seed) {
  const glm::dvec2 p = unit_pair_of(seed);
  return glm::vec2(p);
}

// Returns the largest radiance that a pyray may contain: a picture's white, or a light's radiance.
double brightest_in(const PyrayPicture& picture, const Reflection& reflection,
                    const Shader& shader) {
  double brightest = 1.0;
  const glm::dvec3 middle = glm::normalize(picture.corner + 0.5 * (picture.right + picture.down));
  const double half_angle =
      std::atan(0.5 * (glm::length(picture.right) + glm::length(picture.down)));
  for (const PreparedLight& light : shader.lights()) {
    const auto radiance =
        static_cast<double>(std::max({light.power.x, light.power.y, light.power.z}));
    const bool shown = reflection.shows_lights || light.patterned;
    if (shown && radiance > brightest && may_show(light, picture.apex, middle, half_angle))
      brightest = radiance;
  }
  return brightest;
}

// Returns the number of levels for the weight of this part of the root, and the EPS of the
// reflection. A camera's part gets at least one level unless it is far too small.
ErrorBudget reflected_allowance(const EyeContext& eye, const Reflection& reflection,
                                const Leaf& leaf, double brightest) {
  const glm::vec3 c = reflection.reflected;
  const double reflected =
      std::clamp(brightest * static_cast<double>(std::max({c.x, c.y, c.z})), 1e-6, 1.0);
  const int all = eye.error_budget.max_level;
  const int levels = leaf.region.marginal ? all : ErrorBudget::levels_of(leaf.weight * reflected);
  const bool may_be_one_ray =
      leaf.region.marginal || all == 0 || eye.viewer.bounces > 0 || levels > all;
  return eye.error_budget.of_part(leaf.weight).nested(levels, reflected, may_be_one_ray ? 0 : 1);
}

// Returns the part of the parent's square that is reflected: the leaf's bounding box. If that
// square is itself blurred, returns a rectangle with the kernel's mean and variances in the box,
// since the variances of two blurs add up and their widths do not.
Bounds2 incident_part(const EyeContext& eye, const Reflection& reflection,
                      const LeafRegion& region) {
  const Bounds2 part = bounds_of(region);
  if (!eye.mask || !eye.mask->blur) return part;
  return eye.mask->blur->at(static_cast<double>(reflection.hit.t)).uniform_like(part);
}

// Returns whether the leaf's outline is still recognizable in the reflection, despite its blur.
bool shows_outline(const ReflectedHit& sight) {
  const double sharp = std::min(sight.pyray.sharp_share.x, sight.pyray.sharp_share.y);
  return 1.0 - sharp < LeafTuning::blurred_outline * sharp;
}

// Returns a rectangle around the sample with the leaf's area, which represents a leaf whose outline
// is blurred away. A large part of the leaf's bounding box may lie beyond a corner, behind the
// reflected surface.
Bounds2 part_about_sample(const LeafRegion& region, glm::vec2 at) {
  const Bounds2 around = bounds_of(region);
  const float share = std::clamp(filled_share(region, around), 0.01f, 1.0f);
  const glm::vec2 half = 0.5f * std::sqrt(share) * (around.hi - around.lo);
  const glm::vec2 middle = glm::clamp(at, around.lo + half, around.hi - half);
  return {middle - half, middle + half};
}

bool is_whole(const LeafRegion& region) {
  return region.border.empty() && region.square.side == 1.0f;
}

// Returns the weights of the parts of the reflected square: the blur kernel, and the leaf's own
// outline where it is not blurred away.
ReflectionMask mask_of(const ReflectedHit& sight, const LeafRegion& region, const Bounds2& part,
                       double start) {
  ReflectionMask mask;
  if (sight.pyray.sharp_share != glm::dvec2(1.0)) {
    mask.horizon = horizon_of(sight.pyray, sight.surface);
    mask.blur = {sight.pyray.sharp_share, sight.pyray.apex_distance, start};
  }
  if (!region.border.empty() && shows_outline(sight)) mask.outline = outline_in(region, part);
  return mask;
}

// Returns the boundaries that are not edges of the scene: the leaf's outline, the horizon, and
// lights without geometry.
std::vector<BorderEdge> outlines_in(const ReflectionMask& mask, const Frame& frame,
                                    const ViewContext& viewer) {
  std::vector<BorderEdge> outline;
  for (const BorderEdge& s : mask.outline)
    add_line(outline, {s.from.x, s.from.y, 0.0f, s.to.x, s.to.y, 0.0f});
  if (mask.horizon) {
    if (const auto line = mask.horizon->line()) outline.push_back({line->first, line->second});
  }
  add_lights(outline, frame, viewer);
  return outline;
}

// Traces the reflected pyray and reports it to observers. Returns whether it was split.
bool trace_mirrored(EyeContext& eye, const ReflectedHit& sight, const Leaf& leaf, EyeCaster& caster,
                    int bounce) {
  const std::vector<BorderEdge> outline = outlines_in(*eye.mask, *eye.frame, eye.viewer);
  Pyray pyray{*eye.frame};
  pyray.bounds.within = {&sight.pyray.picture.beyond, 1};
  pyray.bounds.beyond_first = 2.0 * sight.surface.clearance;
  pyray.outline = outline;
  pyray.seed = leaf.seed;
  SubdivisionRules rules = SubdivisionRules::of(*eye.settings, eye.variant.pixels);
  rules.error_budget = eye.error_budget;
  TracedPyray own;
  const bool observed = eye.observed.observer != nullptr;
  const Trace trace = eye.work->mirror_tracer(bounce).trace(eye.scene->features(), pyray, rules,
                                                            caster, observed ? &own : nullptr);
  if (observed) {
    TracedPyray& sent = eye.observed.observer->at(eye.observed.pyray);
    sent.bounces = bounce;
    sent.result = caster.colour(0);
    sent.levels = std::move(own.levels);
    sent.cells = std::move(own.cells);
  }
  return trace.outcome.deepest > 0;
}

std::optional<ReflectionEstimate> trace_width(const EyeContext& eye, const Reflection& reflection,
                                              const Leaf& leaf, float width,
                                              RenderStatistics& counts) {
  // Reflect the leaf's pyray.
  Bounds2 part = incident_part(eye, reflection, leaf.region);
  auto sight = reflected_hit(eye, reflection, part, is_whole(leaf.region), width, counts);
  const bool blurred_before = eye.mask && eye.mask->blur;
  if (sight && !leaf.region.border.empty() && !blurred_before && !shows_outline(*sight)) {
    part = part_about_sample(leaf.region, leaf.at);
    sight = reflected_hit(eye, reflection, part, false, width, counts);
  }
  if (!sight) return std::nullopt;
  const View view(sight->pyray.picture);
  const Frame frame = view.frame(0, 0, 1, 1);
  const ReflectionMask mask = mask_of(*sight, leaf.region, part, view.start());

  // Make the viewer of the reflected pyray.
  const ViewContext viewer{view,
                           eye.viewer.shader,
                           PixelSpacing::of(view),
                           eye.viewer.width + width,
                           eye.viewer.bounces + 1,
                           reflection.throughput(),
                           !reflection.shows_lights,
                           plane_of(sight->surface),
                           reflection.passage,
                           sight->bundle};
  RenderStatistics own;
  EyeContext mirrored_eye{eye.scene, eye.settings, viewer, &frame, {0, 0, 1, 1}};
  mirrored_eye.error_budget = reflected_allowance(
      eye, reflection, leaf, brightest_in(sight->pyray.picture, reflection, eye.viewer.shader));
  mirrored_eye.variant = eye.variant;
  mirrored_eye.seed = static_cast<int>(leaf.seed >> 33);
  mirrored_eye.mask = &mask;
  mirrored_eye.work = eye.work;
  mirrored_eye.stop = eye.stop;
  mirrored_eye.counts = &own;
  const bool one_ray = mirrored_eye.error_budget.max_level == 0;
  if (!one_ray && leaf.observed.wants_more()) {
    mirrored_eye.observed = {leaf.observed.observer,
                             leaf.observed.begin(TracedPyray::Kind::mirror)};
  }
  // Trace the pyray, or one ray if its weight allows no more.
  EyeCaster caster(mirrored_eye, 1);
  bool split = false;
  if (one_ray) {
    // Send the ray through the leaf's own sample, or in a random direction of the lobe.
    glm::vec2 at = glm::clamp((leaf.at - part.lo) / (part.hi - part.lo), 0.0f, 1.0f);
    if (mask.blur)
      at = BlurKernel(mask.blur->far_share)
               .warped(random_place(leaf.seed), {{0.0f, 0.0f}, {1.0f, 1.0f}});
    const PyrayLeaf whole{0, caster.probe({&at, 1}), 1.0, {whole_square, {}, true}};
    caster.sends_one_ray();
    caster.take({&whole, 1});
  } else {
    split = trace_mirrored(mirrored_eye, *sight, leaf, caster, eye.viewer.bounces);
  }
  // Count the pyray's eye rays as reflection rays of the picture.
  own.reflection_rays += std::exchange(own.eye_rays, 0);
  counts += own;
  const RootSum& sum = caster.sum(0);
  const bool misplaces = !sight->exact && !std::isfinite(sum.centre_error);
  const double error = misplaces ? sum.centre_error : 0.0;
  return ReflectionEstimate{{glm::dvec3(caster.colour(0)), error, static_cast<double>(own.rays())},
                            split || sum.mirror_cut};
}

}  // namespace

std::optional<ReflectionEstimate> trace_reflection(const EyeContext& eye,
                                                   const Reflection& reflection, const Leaf& leaf,
                                                   RenderStatistics& counts) {
  if (reflection.one_width()) {
    auto found = trace_width(eye, reflection, leaf, reflection.width.x, counts);
    if (found) found->value = glm::dvec3(glm::vec3(found->value) * reflection.reflected);
    return found;
  }
  ReflectionEstimate all{Estimate::exact(glm::dvec3(0.0))};
  bool followed = true;
  for (int c = 0; c < 3; ++c) {
    if (!(reflection.reflected[c] > 0.0f)) continue;
    const auto one = trace_width(eye, reflection, leaf, reflection.width[c], counts);
    followed &= one.has_value();
    if (!one) continue;
    all.value[c] = static_cast<double>(static_cast<float>(one->value[c]) * reflection.reflected[c]);
    all.error += one->error;
    all.cost += one->cost;
    all.cut |= one->cut;
  }
  return followed ? std::optional(all) : std::nullopt;
}

}  // namespace asos
