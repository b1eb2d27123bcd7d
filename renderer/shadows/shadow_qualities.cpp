#include "renderer/shadows/extended_pyray.h"
#include "renderer/shadows/shadow_pyrays.h"

#include <algorithm>
#include <cmath>

// How the paper finds a soft shadow over a patch (CGF'98 sections 4.2 to 4.3.4), one function a
// quality. Each returns the mean share of the light over the leaf.

namespace asos {
namespace {

Square part_of(const Square& s, int n, int i) {
  const float side = s.side / static_cast<float>(n);
  return {s.u + static_cast<float>(i % n) * side, s.v + static_cast<float>(i / n) * side, side};
}

}  // namespace

double ShadowPyrays::soft_share(const Illumination& lit, const SearchBounds& found,
                                RenderStatistics& counts) {
  // An extended pyray needs a patch that lies on the surface as a whole. What is seen through
  // another surface has none at all.
  const bool whole = leaf_.region.sides.empty();
  if (lit.layer == 0) {
    switch (settings_.quality) {
      case ShadowQuality::refined:
        if (found_thicket(lit) || uneven_at_last(lit, counts)) {
          const Receiver receiver = receiver_above(lit.point);
          if (const auto window = LightWindow::of(lit.light, receiver))
            return thicket_share(lit, *window, receiver, counts);
        }
        break;
      case ShadowQuality::centre:
        break;
      case ShadowQuality::supersampling:
      case ShadowQuality::forced:
        return divided_share(lit, found, counts);
      case ShadowQuality::extended_divided:
        if (whole) return divided_share(lit, found, counts);
        break;
      case ShadowQuality::extended:
        if (whole) return extended_share(lit, leaf_.region.square, found, counts);
        break;
      case ShadowQuality::extended_adaptive:
        if (whole) return adaptive_share(lit, leaf_.region.square, levels_left(), found, counts);
        break;
    }
  }
  return window_share(lit, receiver_above(lit.point), found, counts);
}

bool ShadowPyrays::found_thicket(const Illumination& lit) const {
  return std::any_of(thickets_.begin(), thickets_.end(), [&](const Thicket& thicket) {
    return thicket.light == lit.index && thicket.at == lit.point.position;
  });
}

// Whether the leaf would be split further for its shadow, had its parent left any levels: rays from
// all over it are then the better last word than a pyray from its middle.
bool ShadowPyrays::uneven_at_last(const Illumination& lit, RenderStatistics& counts) {
  if (levels_used() < settings_.max_level) return false;
  const auto patch = patch_of(lit.point, leaf_.region.square);
  if (!patch) return false;
  const auto& p = patch->corners;
  const Patch shown{glm::vec3(0.5 * (p[1] - p[0] + p[3] - p[2])),
                    glm::vec3(0.5 * (p[2] - p[0] + p[3] - p[1]))};
  const float reflected = std::max({lit.reflected.x, lit.reflected.y, lit.reflected.z});
  return midpoint_error(lit.light, lit.index, lit.point, shown, reflected, counts) >
         settings_.most_uneven;
}

double ShadowPyrays::divided_share(const Illumination& lit, const SearchBounds& found,
                                   RenderStatistics& counts) {
  const int n = settings_.divisions;
  const bool extended = settings_.quality == ShadowQuality::extended_divided;
  const bool jittered = settings_.quality == ShadowQuality::supersampling;
  const Receiver middle = receiver_above(lit.point);
  const glm::dvec3 lift = static_cast<double>(clear_height(lit.point)) * middle.geometric;
  const HalfSpace plane{middle.geometric, glm::dot(middle.geometric, middle.position - lift)};
  double sum = 0.0;
  int parts = 0;
  for (int i = 0; i < n * n; ++i) {
    const Square part = part_of(leaf_.region.square, n, i);
    const glm::dvec2 inside =
        jittered ? unit_pair_of(leaf_.seed + 0x9e3779b97f4a7c15ULL * static_cast<std::uint64_t>(i))
                 : glm::dvec2(0.5);
    const glm::vec2 at(part.u + part.side * static_cast<float>(inside.x),
                       part.v + part.side * static_cast<float>(inside.y));
    if (!leaf_.region.holds(at)) continue;
    if (extended) {
      sum += extended_share(lit, part, found, counts);
    } else {
      Receiver receiver = middle;
      receiver.position =
          frame_.on_plane(glm::dvec2(at), plane).value_or(middle.position - lift) + lift;
      sum += window_share(lit, receiver, found, counts);
    }
    ++parts;
  }
  return parts > 0 ? sum / parts : window_share(lit, middle, found, counts);
}

double ShadowPyrays::extended_share(const Illumination& lit, const Square& part,
                                    const SearchBounds& found, RenderStatistics& counts) {
  const auto share = trace_extended(lit, part, false, found, counts);
  return share ? *share : window_share(lit, receiver_above(lit.point), found, counts);
}

// Parts that do not lie inside the light's projection are divided in four.
double ShadowPyrays::adaptive_share(const Illumination& lit, const Square& part, int levels,
                                    const SearchBounds& found, RenderStatistics& counts) {
  if (const auto share = trace_extended(lit, part, true, found, counts)) return *share;
  if (levels <= 0) return extended_share(lit, part, found, counts);
  double sum = 0.0;
  for (int i = 0; i < 4; ++i)
    sum += 0.25 * adaptive_share(lit, part.quarter(i), levels - 1, found, counts);
  return sum;
}

std::optional<double> ShadowPyrays::trace_extended(const Illumination& lit, const Square& part,
                                                   bool around, const SearchBounds& found,
                                                   RenderStatistics& counts) {
  const auto patch = patch_of(lit.point, part);
  if (!patch) return std::nullopt;
  Receiver middle = receiver_above(lit.point);
  middle.position =
      0.25 * (patch->corners[0] + patch->corners[1] + patch->corners[2] + patch->corners[3]) +
      patch->lift * middle.geometric;
  const auto window = LightWindow::of(lit.light, middle);
  if (!window) return std::nullopt;
  const auto fit = around ? ExtendedPyray::Fit::around : ExtendedPyray::Fit::inside;
  const auto pyray = ExtendedPyray::of(*window, *patch, fit);
  if (!pyray) return std::nullopt;

  SubdivisionRules subdivision = rules(lit);
  subdivision.max_level = std::max(1, levels_left());
  SearchBounds bounds = found;
  bounds.within = pyray->between;
  work_.lists.reset(scene_.features, pyray->frame, finest_side(subdivision), bounds);
  for (const Side& side : window->boundaries()) work_.lists.add_boundary(side.from, side.to);
  for (std::size_t i = 0; around && i < 4; ++i)
    work_.lists.add_boundary(pyray->outline[i].from, pyray->outline[i].to);
  extended_caster_.start(*pyray, *window, lit.light.own_part);
  const Root root = look_at_middle(extended_caster_);
  subdivide(lit, root, subdivision, extended_caster_);
  counts.shadow_rays += extended_caster_.rays_cast();
  counts.count_shadow_pyray(lit.index);
  return extended_caster_.lit_share();
}

}  // namespace asos
