#include "renderer/asos/reflected_pyrays.h"

#include "renderer/asos/eye_caster.h"
#include "renderer/asos/subdivision_rules.h"
#include "renderer/lights/bare_lights.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <optional>

namespace asos {
namespace {

constexpr Square whole_square{0.0f, 0.0f, 1.0f};

// Blur beside which a leaf's own outline does not matter, in leaves.
constexpr double outline_matters = 0.25;

/// What is left for a reflection of this weight in its root: a level less for each quarter.
int levels_left(const RenderSettings& settings, const MirroredLeaf& leaf, double weight,
                int bounces) {
  if (leaf.region.marginal || settings.asos.max_level == 0) return 0;
  const int used = static_cast<int>(std::floor(0.5 * std::log2(1.0 / weight)));
  return std::clamp(settings.asos.max_level - std::max(0, used),
                    bounces > 0 || used > settings.asos.max_level ? 0 : 1, settings.asos.max_level);
}

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

// The part of a line within the square.
void add_line(HitLists& lists, const Segment& s) {
  const Clip c = clip(s, {0.0f, 0.0f, 1.0f});
  if (c.empty()) return;
  const glm::vec2 p(s.u0, s.v0), d(s.u1 - s.u0, s.v1 - s.v0);
  lists.add_boundary(p + c.t0 * d, p + c.t1 * d);
}

// Lights that are seen in mirrors only have no edges among the scene's.
void add_lights(HitLists& lists, const Frame& frame, const Shader& shader) {
  for (const std::uint32_t i : shader.bare_lights()) {
    const PreparedLight& light = shader.lights()[i];
    const auto apex = frame.parallel() ? std::nullopt : std::optional(frame.apex());
    for (const auto& outline : light_outlines(light, apex, frame.direction())) {
      for (std::size_t k = 0; k < outline.size(); ++k) {
        if (const auto s = projected(frame, outline[k], outline[(k + 1) % outline.size()]))
          add_line(lists, *s);
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

std::vector<Side> outline_in(const LeafRegion& region, const Bounds2& part) {
  std::vector<Side> outline;
  const glm::vec2 size = part.hi - part.lo;
  for (const Side& side : region.sides)
    outline.push_back({(side.from - part.lo) / size, (side.to - part.lo) / size});
  return outline;
}

glm::vec2 random_place(std::uint64_t seed) {
  const glm::dvec2 p = unit_pair_of(seed);
  return glm::vec2(p);
}

}  // namespace

ReflectionWorkspace::Bounce& ReflectionWorkspace::at(int bounce) {
  const auto index = static_cast<std::size_t>(bounce);
  while (bounces_.size() <= index) bounces_.push_back(std::make_unique<Bounce>());
  return *bounces_[index];
}

Mirrored ReflectedPyrays::trace(const Reflection& reflection, const MirroredLeaf& leaf,
                                RenderStatistics& counts) const {
  Mirrored all;
  if (reflection.one_width()) {
    all = trace(reflection, leaf, reflection.width.x, counts);
  } else {
    for (int c = 0; c < 3; ++c) {
      if (!(reflection.reflected[c] > 0.0f)) continue;
      const Mirrored one = trace(reflection, leaf, reflection.width[c], counts);
      all.radiance[c] = one.radiance[c];
      all.split |= one.split;
      all.followed &= one.followed;
    }
  }
  all.radiance *= reflection.reflected;
  return all;
}

// The part of the parent's frame, in double precision: the reflection hangs on it. Its distance is
// that of the plane through the sample's hit.
IncidentPyray ReflectedPyrays::pyray_of(const Reflection& reflection, const Bounds2& part) const {
  const glm::dvec2 size(part.hi - part.lo);
  const glm::dvec2 middle = glm::dvec2(part.lo) + 0.5 * size;
  IncidentPyray pyray;
  pyray.perspective = !frame.parallel();
  pyray.right = size.x * frame.base_u();
  pyray.down = size.y * frame.base_v();
  pyray.axis = pyray.perspective
                   ? frame.base_corner() + middle.x * frame.base_u() + middle.y * frame.base_v()
                   : frame.direction();
  const glm::dvec3 n(reflection.point.geometric_normal);
  pyray.distance =
      glm::dot(n, glm::dvec3(reflection.point.position) - start_of(part)) / glm::dot(n, pyray.axis);
  return pyray;
}

// Where the axis of a part of the frame starts.
glm::dvec3 ReflectedPyrays::start_of(const Bounds2& part) const {
  if (!frame.parallel()) return frame.apex();
  const glm::vec2 middle = 0.5f * (part.lo + part.hi);
  return frame.world({static_cast<double>(middle.x), static_cast<double>(middle.y), 0.0});
}

std::optional<MirroredSight> ReflectedPyrays::sight_of(const Reflection& reflection,
                                                       const Bounds2& part, float width) const {
  IncidentPyray pyray = pyray_of(reflection, part);
  MirroredSight sight;
  MirrorSurface& surface = sight.surface;
  surface = mirror_surface(scene.world, reflection.hit, reflection.point, pyray,
                           settings.mirror.curved == CurvedMirror::approximate);
  // From the middle of the part, on the mirror's plane.
  const glm::dvec3 start = start_of(part);
  pyray.distance = glm::dot(surface.geometric, surface.position - start) /
                   glm::dot(surface.geometric, pyray.axis);
  if (pyray.distance > 0.0 && std::isfinite(pyray.distance)) {
    surface.position = start + pyray.distance * pyray.axis;
  } else {
    // Seen along its very plane: from where the sample met it.
    pyray.distance = static_cast<double>(reflection.hit.t) / glm::length(pyray.axis);
  }
  const MirrorLobe lobe = lobe_around(surface, mirrored_direction(surface, pyray.axis), pyray.right,
                                      static_cast<double>(width));
  const auto reflected = mirrored(pyray, surface, lobe);
  if (!reflected) return std::nullopt;
  sight.pyray = *reflected;
  return sight;
}

// The radiance that a pyray may show: a picture's white, or a light's.
double ReflectedPyrays::brightest_in(const PyrayPicture& picture) const {
  double brightest = 1.0;
  const glm::dvec3 middle = glm::normalize(picture.corner + 0.5 * (picture.right + picture.down));
  const double half_angle =
      std::atan(0.5 * (glm::length(picture.right) + glm::length(picture.down)));
  for (const PreparedLight& light : viewer.shader.lights()) {
    const auto radiance =
        static_cast<double>(std::max({light.power.x, light.power.y, light.power.z}));
    if (radiance > brightest && may_show(light, picture.apex, middle, half_angle))
      brightest = radiance;
  }
  return brightest;
}

// One budget for all: the levels that this share of the root deserves, and EPS of what is
// reflected, so that all leaves together stay within EPS of their root.
ReflectionWorkspace::Bounce& ReflectedPyrays::level_of(const Reflection& reflection,
                                                       const MirroredLeaf& leaf,
                                                       double brightest) const {
  const glm::vec3 c = reflection.reflected;
  const double reflected =
      std::clamp(brightest * static_cast<double>(std::max({c.x, c.y, c.z})), 1e-6, 1.0);
  ReflectionWorkspace::Bounce& level = work.reflections.at(viewer.bounces);
  level.settings = settings;
  level.settings.asos.max_level =
      levels_left(settings, leaf, leaf.weight * reflected, viewer.bounces);
  level.settings.asos.eps = std::min(1.0, settings.asos.eps / reflected);
  level.settings.seed = static_cast<int>(leaf.seed >> 33);
  return level;
}

Mirrored ReflectedPyrays::trace(const Reflection& reflection, const MirroredLeaf& leaf, float width,
                                RenderStatistics& counts) const {
  const Bounds2 part = bounds_of(leaf.region);
  const auto sight = sight_of(reflection, part, width);
  if (!sight) return {{}, false, false};
  const View view(sight->pyray.picture);
  const Frame mirrored_frame = view.frame(0, 0, 1, 1);
  const Viewer mirrored_viewer{view,
                               viewer.shader,
                               PixelSpacing::of(view),
                               viewer.width + width,
                               viewer.bounces + 1,
                               reflection.throughput(),
                               plane_of(sight->surface)};
  MirroredMask mask;
  if (width > 0.0f) {
    mask.horizon = horizon_of(sight->pyray, sight->surface);
    mask.blur = {sight->pyray.sharp_share, sight->pyray.apex_distance, view.start()};
  }
  const double sharp = std::min(sight->pyray.sharp_share.x, sight->pyray.sharp_share.y);
  if (!leaf.region.sides.empty() && 1.0 - sharp < outline_matters * sharp)
    mask.outline = outline_in(leaf.region, part);

  ReflectionWorkspace::Bounce& level =
      level_of(reflection, leaf, brightest_in(sight->pyray.picture));
  RenderStatistics own;
  EyeCaster caster(scene, mirrored_viewer, level.settings, mirrored_frame, {0, 0, 1, 1}, 1, work,
                   stop, own, &mask);
  bool split = false;
  if (level.settings.asos.max_level == 0) {
    // One ray: through the leaf's own sample, or anywhere in the lobe.
    glm::vec2 at = (leaf.at - part.lo) / (part.hi - part.lo);
    if (mask.blur)
      at = BlurKernel(mask.blur->far_share).warped(random_place(leaf.seed), whole_square);
    const auto sample = caster.probe({&at, 1});
    caster.leaf(0, sample, 1.0, {whole_square, {}, true});
  } else {
    find_boundaries(level, mirrored_frame, *sight, mask);
    const glm::vec2 middle(0.5f);
    Root root;
    root.square = whole_square;
    root.centre = caster.probe({&middle, 1});
    // What the middle shows hides what lies behind it; often nothing is left to look at.
    const Square reach = Detector(mirrored_frame, settings.asos.detect).reach(whole_square);
    const HidingPlane hiding =
        HidingPlane::of(caster.cover(root.centre), mirrored_frame, reach.side);
    level.lists.refine(reach, hiding, level.lists.root(), level.list, true);
    root.list = level.list;
    root.seed = leaf.seed;
    caster.gather_surfaces(1);
    split = subdivide(level, root, caster);
  }
  own.reflection_rays += std::exchange(own.eye_rays, 0);
  counts += own;
  return {caster.colour(0), split || caster.mirror_cut(0)};
}

// Whether it was split. Writes the subdivision down where that is asked for, and what its own
// leaves send on.
bool ReflectedPyrays::subdivide(ReflectionWorkspace::Bounce& level, const Root& root,
                                EyeCaster& caster) const {
  PyrayLog* log = work.shadows.log;
  const auto run = [&] {
    return level.subdivider.run(level.lists, {&root, 1}, rules_of(level.settings), caster)[0]
               .deepest > 0;
  };
  if (!log || !log->wants_more()) return run();
  const int index = log->add(LoggedPyray::Kind::mirror);
  log->at(index).bounces = viewer.bounces;
  SubdivisionTrace trace;
  level.subdivider.trace(root.id, trace);
  caster.log_leaves(root.id);
  const PyrayLog::Leaf outer = log->set_leaf({true, index, glm::vec2(0.5f), 1.0});
  const bool split = run();
  log->set_leaf(outer);
  LoggedPyray& pyray = log->at(index);
  pyray.result = caster.colour(root.id);
  for (const TracedCell& cell : trace.cells)
    for (const TracedLeaf& leaf : cell.leaves)
      pyray.leaves.push_back(caster.logged_radiance(leaf.sample));
  pyray.subdivision = std::move(trace);
  return split;
}

// The scene's beyond the mirror, the leaf's own, the horizon, and lights without a surface.
void ReflectedPyrays::find_boundaries(ReflectionWorkspace::Bounce& level,
                                      const Frame& mirrored_frame, const MirroredSight& sight,
                                      const MirroredMask& mask) const {
  SearchBounds bounds;
  bounds.within = {&sight.pyray.picture.beyond, 1};
  bounds.beyond_first = 2.0 * sight.surface.clearance;
  level.lists.reset(scene.features, mirrored_frame,
                    std::ldexp(1.0f, -level.settings.asos.max_level), bounds);
  for (const Side& s : mask.outline)
    add_line(level.lists, {s.from.x, s.from.y, 0.0f, s.to.x, s.to.y, 0.0f});
  if (mask.horizon) {
    if (const auto line = mask.horizon->line()) level.lists.add_boundary(line->first, line->second);
  }
  add_lights(level.lists, mirrored_frame, viewer.shader);
}

}  // namespace asos
