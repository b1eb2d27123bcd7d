#include "renderer/shadows/shadow_pyrays.h"

#include "renderer/sampling/random.h"
#include "renderer/shading/shadow_ray.h"

#include <algorithm>
#include <cmath>

namespace asos {
namespace {

// Of a light, or a patch: a part costs a ray, and leaves no error.
constexpr int most_boundaries = 24;
constexpr int most_pieces = 64;
// A leaf of less than this share of a finest cell, whose sample stands for as little as no marginal
// leaf's does, is served by a ray like one.
constexpr double small_leaf = 0.25;
// A light whose square holds more groups than this is a thicket: no part of it is free of
// boundaries.
constexpr std::size_t most_entries = 400;
// A light that cannot be cut along its boundaries, nor its quarters, is sampled: more levels of
// pyrays cost more than rays that look from all over the patch.
constexpr int window_levels = 1;

Box box_of(const ShadowPatch& patch) {
  Box box;
  for (const glm::dvec3& corner : patch.corners) box.grow(glm::vec3(corner));
  return box;
}

float largest(glm::vec3 v) {
  return std::max({v.x, v.y, v.z});
}

}  // namespace

float finest_side(const SubdivisionRules& rules) {
  // Outlines are drawn at least as finely as in a pixel at MAX 3, so that they can be cut along.
  return std::ldexp(1.0f, -std::max(rules.max_level, 3));
}

// Well mixed bits (Steele, Lea and Flood 2014).
glm::dvec2 unit_pair_of(std::uint64_t bits) {
  const RandomPair pair = unit_pair(mix_bits(bits));
  return {pair.u, pair.v};
}

Receiver receiver_above(const SurfacePoint& point) {
  Receiver receiver = receiver_at(point);
  receiver.position += static_cast<double>(clear_height(point)) * receiver.geometric;
  return receiver;
}

ShadowPyrays::ShadowPyrays(const ShadowScene& scene, const ShadowRules& settings,
                           const Frame& frame, const PatchView& view, ShadowGroups& groups,
                           ShadowWorkspace& work)
    : scene_(scene),
      settings_(settings),
      frame_(frame),
      view_(view),
      groups_(groups),
      work_(work),
      window_caster_(scene, settings.see_through),
      patch_caster_(scene, settings.see_through),
      extended_caster_(scene, settings.see_through) {}

void ShadowPyrays::add(const Illumination& lit, glm::vec3& radiance, RenderStatistics& counts) {
  const glm::vec3 all = lit.reflected * lit.unshadowed;
  if (all == glm::vec3(0.0f)) return;
  // Whether a light this weak is shaded does not matter: all of them together stay below EPS.
  const double weakest = settings_.eps / static_cast<double>(scene_.world.lights.size());
  double share = 1.0;
  if (static_cast<double>(largest(all)) > weakest)
    share = leaf_.even && lit.layer == 0 ? even_share(lit, counts) : lit_share(lit, counts);
  if (share > 0.0) radiance += static_cast<float>(share) * all;
}

// What the middle of an even patch sees of a light of some size, all of it does; and all of it is
// in a hard shadow, or in none, where nothing bounds one.
double ShadowPyrays::even_share(const Illumination& lit, RenderStatistics& counts) {
  EvenPatch& even = *leaf_.even;
  double& share = even.shares[lit.index];
  const auto holds_for_all = [&] { return lit.light.extended() || share == 0.0 || share == 1.0; };
  if (share >= 0.0) return holds_for_all() ? share : lit_share(lit, counts);
  const glm::vec3 there = unshadowed_irradiance(lit.light, receiver_at(even.middle));
  // The light has set for the patch's middle, but not for this leaf.
  if (there == glm::vec3(0.0f)) return lit_share(lit, counts);
  const ShadedLeaf own = leaf_;
  leaf_.region = {even.square, {}};
  leaf_.weight = std::pow(even.square.side / leaf_.root_side, 2.0f);
  share = lit_share({lit.light, lit.index, even.middle, there, lit.reflected, 0}, counts);
  leaf_ = own;
  return holds_for_all() ? share : lit_share(lit, counts);
}

double ShadowPyrays::lit_share(const Illumination& lit, RenderStatistics& counts) {
  if (leaf_.region.marginal ||
      leaf_.weight < small_leaf * std::ldexp(1.0, -2 * settings_.max_level))
    return ray_share(lit, counts);
  const auto patch = lit.layer == 0 ? patch_of(lit.point, leaf_.region.square) : std::nullopt;
  Box around;
  if (patch) {
    around = box_of(*patch);
  } else {
    around.grow(lit.point.position);
  }
  const ShadowKnowledge known =
      groups_.ask(lit.light, lit.index, lit.point, around, counts.shadow_rays);
  // That nothing bounds the shadow does not rule out what stands in the light itself.
  if (known.verdict != ShadowKnowledge::Verdict::open && lit.light.cuts.empty())
    return known.verdict == ShadowKnowledge::Verdict::lit ? 1.0 : 0.0;
  SearchBounds found = own_part_ignored(scene_.world, lit.light);
  found.cut = known.cut;
  if (lit.light.shape == PreparedLight::Shape::segment) return segment_share(lit, found, counts);
  if (lit.light.extended()) return soft_share(lit, found, counts);
  return patch ? patch_share(lit, *patch, found, counts) : ray_share(lit, counts);
}

// One ray, to a random point of the light.
double ShadowPyrays::ray_share(const Illumination& lit, RenderStatistics& counts) {
  const glm::dvec2 at = unit_pair_of(leaf_.seed + 0x9e3779b97f4a7c15ULL * (lit.index + 1));
  const LightSample sample = sample_light(lit.light, receiver_at(lit.point), at.x, at.y);
  if (sample.irradiance == glm::vec3(0.0f)) return 0.0;
  ++counts.shadow_rays;
  return static_cast<double>(
      scene_.rays.transmittance(shadow_ray(lit.point, sample), lit.light.own_part));
}

int ShadowPyrays::levels_used() const {
  return static_cast<int>(std::lround(std::log2(leaf_.root_side / leaf_.region.square.side)));
}

int ShadowPyrays::levels_left() const {
  return std::clamp(settings_.max_level - levels_used(), 1, max_level_limit);
}

// One budget for nested pyrays: the levels that the parent left (CGF'98 section 4.1; design section
// 5), and EPS of what the leaf shows, so that all leaves together stay within EPS of their root.
SubdivisionRules ShadowPyrays::rules(const Illumination& lit) const {
  SubdivisionRules rules;
  rules.max_level = levels_left();
  const double intensity =
      std::min(1.0, static_cast<double>(largest(lit.reflected * lit.unshadowed)));
  rules.eps = settings_.eps >= intensity ? 1.0 : settings_.eps / intensity;
  rules.exact_leaves = settings_.exact_leaves;
  rules.jitter = true;
  rules.limits.most_groups = static_cast<int>(most_entries);
  rules.limits.most_boundaries = most_boundaries;
  rules.limits.most_pieces = most_pieces;
  rules.limits.tolerance = std::ldexp(finest_side(rules), -6);
  return rules;
}

// A search that costs more than the samples that would take its place gives up.
std::size_t ShadowPyrays::most_entries_for_samples() const {
  constexpr std::size_t least = 48;
  return std::max(least, (std::size_t{1} << 2 * levels_left()) / 2);
}

// The root of a shadow pyray, whose hit list has been refined by what its middle shows.
Root ShadowPyrays::look_at_middle(ShadowCaster& caster) {
  HitLists& lists = work_.lists;
  const Square whole{0.0f, 0.0f, 1.0f};
  // What shades the middle may hide all else; if it does not, nothing is lost but a ray.
  const glm::vec2 middle(0.5f);
  Root root;
  root.centre = caster.probe(std::span(&middle, 1));
  const HidingPlane hiding = HidingPlane::of(caster.cover(root.centre), lists.frame(), whole.side);
  lists.refine(whole, hiding, lists.root(), work_.list, true);
  root.square = whole;
  root.list = work_.list;
  root.seed = leaf_.seed;
  return root;
}

// Writes the subdivision down where that is asked for.
SubdivisionOutcome ShadowPyrays::subdivide(const Illumination& lit, const Root& root,
                                           const SubdivisionRules& subdivision,
                                           ShadowCaster& caster) {
  const bool logged = work_.log && work_.log->wants_more();
  SubdivisionTrace trace;
  if (logged) work_.subdivider.trace(root.id, trace);
  const SubdivisionOutcome outcome =
      work_.subdivider.run(work_.lists, std::span(&root, 1), subdivision, caster).front();
  if (!logged) return outcome;
  LoggedPyray& pyray = work_.log->at(work_.log->add(LoggedPyray::Kind::shadow));
  pyray.light = lit.index;
  pyray.result = glm::vec3(static_cast<float>(caster.lit_share().value_or(0.0)));
  for (const TracedCell& cell : trace.cells)
    for (const TracedLeaf& leaf : cell.leaves)
      pyray.leaves.emplace_back(caster.transmittance(leaf.sample));
  pyray.subdivision = std::move(trace);
  return outcome;
}

double ShadowPyrays::window_share(const Illumination& lit, const Receiver& receiver,
                                  const SearchBounds& found, RenderStatistics& counts) {
  const auto window = LightWindow::of(lit.light, receiver);
  if (!window) return ray_share(lit, counts);
  SubdivisionRules subdivision = rules(lit);
  // What varies between outlines is sampled; the paper's qualities split the light for it.
  const bool refined = settings_.quality == ShadowQuality::refined;
  const auto varies = [&] { return refined && window_caster_.met_see_through(); };
  if (refined || !settings_.see_through)
    subdivision.max_level = std::min(subdivision.max_level, window_levels);
  SearchBounds bounds = found;
  bounds.within = window->between();
  bounds.most_entries = most_entries_for_samples();
  work_.lists.reset(scene_.features, window->frame(), finest_side(subdivision), bounds);
  for (const Side& side : window->boundaries()) work_.lists.add_boundary(side.from, side.to);
  window_caster_.start(lit.light, *window);
  const Root root = look_at_middle(window_caster_);
  bool thicket = root.list.size() > most_entries || work_.lists.exhausted() || varies();
  if (!thicket) {
    const SubdivisionOutcome outcome = subdivide(lit, root, subdivision, window_caster_);
    thicket =
        outcome.unresolved_area > subdivision.eps || (refined && window_caster_.met_see_through());
  }
  counts.shadow_rays += window_caster_.rays_cast();
  counts.count_shadow_pyray(lit.index);
  return thicket ? thicket_share(lit, *window, receiver, counts)
                 : window_caster_.lit_share().value_or(0.0);
}

// The patch on the point's plane that a square of the eye's frame shows, with the leaf's sides if
// that is the leaf's own.
std::optional<ShadowPatch> ShadowPyrays::patch_of(const SurfacePoint& point, const Square& s) {
  ShadowPatch patch;
  const glm::dvec3 normal(point.geometric_normal);
  patch.plane = {normal, glm::dot(normal, glm::dvec3(point.position))};
  for (std::size_t i = 0; i < 4; ++i) {
    const glm::dvec2 corner(s.u + ((i & 1) ? s.side : 0.0f), s.v + ((i & 2) ? s.side : 0.0f));
    const auto at = frame_.on_plane(corner, patch.plane);
    if (!at) return std::nullopt;
    patch.corners[i] = *at;
  }
  work_.sides.clear();
  for (const Side& side : leaf_.region.sides) {
    const glm::vec2 origin(s.u, s.v);
    work_.sides.push_back({(side.from - origin) / s.side, (side.to - origin) / s.side});
  }
  patch.sides = work_.sides;
  patch.lift = static_cast<double>(clear_height(point));
  return patch;
}

// From a patch's middle to its corners.
double ShadowPyrays::departure(const SurfacePoint& point, const ShadowPatch& patch) const {
  const auto& p = patch.corners;
  const double reach = 0.5 * std::max(glm::distance(p[0], p[3]), glm::distance(p[1], p[2]));
  return scene_.features.departure(point.triangle, glm::dvec3(point.position), reach);
}

// Whether the surface leaves the patch's plane by more than the 64th of its size, by which edges of
// shadows on it would be out of place.
bool ShadowPyrays::bent(const Illumination& lit, const ShadowPatch& patch) const {
  const auto& p = patch.corners;
  const double size = std::min(glm::distance(p[0], p[3]), glm::distance(p[1], p[2]));
  return 64.0 * departure(lit.point, patch) > size;
}

double ShadowPyrays::patch_share(const Illumination& lit, ShadowPatch patch,
                                 const SearchBounds& found, RenderStatistics& counts) {
  const bool parallel = lit.light.shape == PreparedLight::Shape::distant;
  const auto frame =
      parallel ? PatchCaster::frame_along(lit.light.towards, world_reach(scene_.world), patch)
               : PatchCaster::frame_from(lit.light.position, patch);
  if (!frame) return ray_share(lit, counts);
  const HalfSpace above{patch.plane.normal,
                        patch.plane.offset + patch.lift + departure(lit.point, patch)};
  const SubdivisionRules subdivision = rules(lit);
  SearchBounds bounds = found;
  bounds.within = std::span(&above, 1);
  bounds.beyond_first = patch.lift;
  work_.lists.reset(scene_.features, *frame, finest_side(subdivision), bounds);
  // Nothing bounds the shadow: what its sample sees, all of the leaf does.
  work_.lists.refine({0.0f, 0.0f, 1.0f}, {}, work_.lists.root(), work_.list);
  if (work_.list.empty() && !settings_.see_through) return ray_share(lit, counts);
  if (settings_.quality == ShadowQuality::refined && bent(lit, patch))
    return bent_patch_share(lit, counts);
  if (parallel) {
    // The parallel frame's square is not the leaf's: the leaf is a region of it.
    work_.sides.clear();
    const auto placed = [&](glm::vec2 at) {
      return glm::vec2(frame->homogeneous(*frame_.on_plane(glm::dvec2(at), patch.plane)));
    };
    leaf_.region.for_each_side([&](const Side& side) {
      work_.sides.push_back({placed(side.from), placed(side.to)});
    });
    patch.sides = work_.sides;
  }
  for (const Side& side : patch.sides) work_.lists.add_boundary(side.from, side.to);
  patch_caster_.start(*frame, patch, parallel ? &frame_ : nullptr, lit.light.own_part);
  const Root root = look_at_middle(patch_caster_);
  subdivide(lit, root, subdivision, patch_caster_);
  counts.shadow_rays += patch_caster_.rays_cast();
  counts.count_shadow_pyray(lit.index);
  const auto share = patch_caster_.lit_share();
  return share ? *share : ray_share(lit, counts);
}

}  // namespace asos
