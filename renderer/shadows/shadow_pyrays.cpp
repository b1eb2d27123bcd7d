#include "renderer/shadows/shadow_pyrays.h"

#include "renderer/shading/shadow_ray.h"

#include <algorithm>
#include <cmath>

namespace asos {
namespace {

// Into how many parts boundaries may cut a light, or a patch, where levels are used up: a part
// costs a ray, and leaves no error.
constexpr int most_parts = 16;

Box box_of(const ShadowPatch& patch) {
  Box box;
  for (const glm::dvec3& corner : patch.corners) box.grow(glm::vec3(corner));
  return box;
}

float largest(glm::vec3 v) {
  return std::max({v.x, v.y, v.z});
}

// Two numbers in [0, 1) of 64 bits that are well mixed once (Steele, Lea and Flood 2014).
glm::dvec2 unit_pair_of(std::uint64_t z) {
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebULL;
  z ^= z >> 31;
  return {static_cast<double>(z >> 32) * 0x1p-32, static_cast<double>(z & 0xffffffffu) * 0x1p-32};
}

}  // namespace

ShadowPyrays::ShadowPyrays(const ShadowScene& scene, const ShadowSettings& settings,
                           const Frame& frame, ShadowGroups& groups, ShadowWorkspace& work)
    : scene_(scene),
      settings_(settings),
      frame_(frame),
      groups_(groups),
      work_(work),
      window_caster_(scene),
      patch_caster_(scene) {}

void ShadowPyrays::add(const Illumination& lit, glm::vec3& radiance, RenderStatistics& counts) {
  const glm::vec3 all = lit.reflected * lit.unshadowed;
  if (all == glm::vec3(0.0f)) return;
  // Whether a light this weak is shaded does not matter: all of them together stay below EPS.
  const double weakest = settings_.eps / static_cast<double>(scene_.world.lights.size());
  const double share = static_cast<double>(largest(all)) <= weakest ? 1.0 : lit_share(lit, counts);
  if (share > 0.0) radiance += static_cast<float>(share) * all;
}

double ShadowPyrays::lit_share(const Illumination& lit, RenderStatistics& counts) {
  if (leaf_.region.marginal) return ray_share(lit, counts);
  const auto patch = lit.layer == 0 ? patch_of(lit.point) : std::nullopt;
  Box around;
  if (patch) {
    around = box_of(*patch);
  } else {
    around.grow(lit.point.position);
  }
  const ShadowKnowledge known =
      groups_.ask(lit.light, lit.index, lit.point, around, counts.shadow_rays);
  if (known.verdict != ShadowKnowledge::Verdict::open)
    return known.verdict == ShadowKnowledge::Verdict::lit ? 1.0 : 0.0;
  SearchBounds found = own_part_ignored(scene_.world, lit.light);
  found.cut = known.cut;
  if (lit.light.shape == PreparedLight::Shape::segment) return segment_share(lit, found, counts);
  if (lit.light.extended()) return window_share(lit, found, counts);
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

int ShadowPyrays::levels_left() const {
  const int used =
      static_cast<int>(std::lround(std::log2(leaf_.root_side / leaf_.region.square.side)));
  return std::clamp(settings_.max_level - used, 1, max_level_limit);
}

// One budget for nested pyrays: the levels that the parent left, and an error that counts as little
// as the leaf does (CGF'98 section 4.1; design section 5).
SubdivisionRules ShadowPyrays::rules(const Illumination& lit) const {
  SubdivisionRules rules;
  rules.max_level = levels_left();
  const double weight =
      leaf_.share * static_cast<double>(std::min(1.0f, largest(lit.reflected * lit.unshadowed)));
  rules.eps = settings_.eps >= weight ? 1.0 : settings_.eps / weight;
  rules.exact_leaves = settings_.exact_leaves;
  rules.least_faces = most_parts;
  rules.jitter = true;
  return rules;
}

void ShadowPyrays::subdivide(const SubdivisionRules& rules, ShadowCaster& caster) {
  HitLists& lists = work_.lists;
  const Square whole{0.0f, 0.0f, 1.0f};
  lists.refine(whole, {}, lists.root(), work_.list);
  Root root;
  root.square = whole;
  root.list = work_.list;
  root.seed = leaf_.seed;
  (void)work_.subdivider.run(lists, std::span(&root, 1), rules, caster);
}

double ShadowPyrays::window_share(const Illumination& lit, const SearchBounds& found,
                                  RenderStatistics& counts) {
  Receiver receiver = receiver_at(lit.point);
  receiver.position += static_cast<double>(clear_height(lit.point)) * receiver.geometric;
  const auto window = LightWindow::of(lit.light, receiver);
  if (!window) return ray_share(lit, counts);
  const SubdivisionRules subdivision = rules(lit);
  SearchBounds bounds = found;
  bounds.within = window->between();
  work_.lists.reset(scene_.features, window->frame(), std::ldexp(1.0f, -subdivision.max_level),
                    bounds);
  for (const Side& side : window->boundaries())
    work_.lists.add_boundary(side.from, side.to, window->nearness());
  window_caster_.start(lit.light, *window);
  subdivide(subdivision, window_caster_);
  counts.shadow_rays += window_caster_.rays_cast();
  return window_caster_.lit_share().value_or(0.0);
}

// The parts of a linear light that are seen: between the places where boundaries cross it, one ray
// each. Only its middle line counts of the thin strip that is searched.
double ShadowPyrays::segment_share(const Illumination& lit, const SearchBounds& found,
                                   RenderStatistics& counts) {
  Receiver receiver = receiver_at(lit.point);
  receiver.position += static_cast<double>(clear_height(lit.point)) * receiver.geometric;
  const glm::dvec3 middle = lit.light.position - receiver.position;
  const glm::dvec3 across = glm::cross(middle, lit.light.half_u);
  const double length = glm::length(lit.light.half_u);
  if (!(glm::length(across) > 1e-9 * glm::length(middle) * length)) return ray_share(lit, counts);
  constexpr double strip = 1e-4;
  const glm::dvec3 half_v = glm::normalize(across) * (strip * length);
  const Frame frame = Frame::pyramid(receiver.position, middle - lit.light.half_u - half_v,
                                     2.0 * lit.light.half_u, 2.0 * half_v);
  const glm::dvec3 back = -glm::normalize(glm::cross(across, lit.light.half_u));
  const double side = glm::dot(back, middle) > 0.0 ? -1.0 : 1.0;
  const HalfSpace between[2] = {
      {receiver.geometric, glm::dot(receiver.geometric, receiver.position)},
      {side * back,
       glm::dot(side * back, receiver.position) + (1.0 - 1e-5) * glm::dot(side * back, middle)}};
  SearchBounds bounds = found;
  bounds.within = between;
  HitLists& lists = work_.lists;
  lists.reset(scene_.features, frame, 0.0f, bounds);
  const Square whole{0.0f, 0.0f, 1.0f};
  const std::size_t most = std::size_t{1} << (levels_left() + 3);
  std::vector<double>& ends = work_.ends;
  ends.assign({-1.0, 1.0});
  HitLists::List& crossing = work_.list;
  crossing.clear();
  bool told_apart = true;
  for (const std::uint32_t i : lists.root())
    told_apart = told_apart && lists.tell_apart(i, whole, 0.0f, most, crossing);
  if (told_apart) {
    for (const std::uint32_t i : crossing) {
      const Segment& s = lists.segment(i);
      if ((s.v0 > 0.5f) == (s.v1 > 0.5f)) continue;
      const double t = (0.5 - static_cast<double>(s.v0)) / (static_cast<double>(s.v1) - s.v0);
      ends.push_back(2.0 * (s.u0 + t * (static_cast<double>(s.u1) - s.u0)) - 1.0);
    }
  } else {
    // Too many: as many equal parts.
    for (std::size_t i = 1; i < most; ++i)
      ends.push_back(2.0 * static_cast<double>(i) / static_cast<double>(most) - 1.0);
  }
  std::sort(ends.begin(), ends.end());
  double lit_parts = 0.0, all = 0.0;
  for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
    const double t0 = std::max(-1.0, ends[i]), t1 = std::min(1.0, ends[i + 1]);
    if (!(t0 < t1)) continue;
    const double part =
        static_cast<double>(largest(segment_irradiance(lit.light, receiver, t0, t1)));
    if (!(part > 0.0)) continue;
    const glm::dvec3 to = middle + 0.5 * (t0 + t1) * lit.light.half_u;
    const double distance = glm::length(to);
    ++counts.shadow_rays;
    all += part;
    lit_parts +=
        part * static_cast<double>(scene_.rays.transmittance(
                   shadow_ray(lit.point, {to / distance, distance, {}}), lit.light.own_part));
  }
  return all > 0.0 ? lit_parts / all : 0.0;
}

std::optional<ShadowPatch> ShadowPyrays::patch_of(const SurfacePoint& point) {
  const Square& s = leaf_.region.square;
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

double ShadowPyrays::patch_share(const Illumination& lit, const ShadowPatch& patch,
                                 const SearchBounds& found, RenderStatistics& counts) {
  const bool parallel = lit.light.shape == PreparedLight::Shape::distant;
  const auto frame =
      parallel ? PatchCaster::frame_along(lit.light.towards, world_reach(scene_.world), patch)
               : PatchCaster::frame_from(lit.light.position, patch);
  if (!frame) return ray_share(lit, counts);
  const double departure = scene_.features.departure(lit.point.triangle);
  const HalfSpace above{patch.plane.normal, patch.plane.offset + patch.lift + departure};
  const SubdivisionRules subdivision = rules(lit);
  SearchBounds bounds = found;
  bounds.within = std::span(&above, 1);
  work_.lists.reset(scene_.features, *frame, std::ldexp(1.0f, -subdivision.max_level), bounds);
  // Behind everything: what shades the patch hides where the leaf ends, too.
  double farthest = 0.0;
  for (const glm::dvec3& corner : patch.corners)
    farthest = std::min(farthest, frame->parallel() ? -frame->homogeneous(corner).z : 0.0);
  for (const Side& side : patch.sides)
    work_.lists.add_boundary(side.from, side.to, static_cast<float>(farthest));
  patch_caster_.start(*frame, patch, lit.light.own_part);
  subdivide(subdivision, patch_caster_);
  counts.shadow_rays += patch_caster_.rays_cast();
  const auto share = patch_caster_.lit_share();
  return share ? *share : ray_share(lit, counts);
}

}  // namespace asos
