// Projected solid angles of rectangles by Lambert's contour sum, with one point per lane. Included
// once for each instruction set.
#if defined(ASOS_KERNELS_CONTOUR_FORMS_H) == defined(HWY_TARGET_TOGGLE)
#ifdef ASOS_KERNELS_CONTOUR_FORMS_H
#undef ASOS_KERNELS_CONTOUR_FORMS_H
#else
#define ASOS_KERNELS_CONTOUR_FORMS_H
#endif

#include "renderer/kernels/arc_places.h"

#include <cstddef>
#include <vector>

HWY_BEFORE_NAMESPACE();
namespace asos::HWY_NAMESPACE {

/// A directed segment; lanes without one are marked.
struct SegmentLanes {
  DoubleVectors begin, end;
  MaskOf<DoubleTag> some;
};

/// Clips one side of a convex outline to the space above a plane. The outline leaves that space at
/// one point and enters it at another; `closing` becomes the segment in the plane that joins them.
HWY_INLINE SegmentLanes clipped(const SegmentLanes& side, const DoubleVectors& up,
                                SegmentLanes& closing) {
  const auto begin = dot(side.begin, up), end = dot(side.end, up);
  const auto begin_above = begin > 0.0, end_above = end > 0.0;
  const auto crosses = side.some && begin_above != end_above;
  const auto fall = selected(crosses, begin - end, 1.0);
  const auto met = side.begin + begin / fall * (side.end - side.begin);
  const auto leaves = crosses && begin_above;
  closing.begin = selected(leaves, met, closing.begin);
  closing.end = selected(crosses && !leaves, met, closing.end);
  closing.some = closing.some || crosses;
  return {selected(begin_above, side.begin, met), selected(end_above, side.end, met),
          side.some && (begin_above || end_above)};
}

/// Returns, for points from i on, the contour sum of a rectangle that horizons may cut, as
/// polygon_form.
inline DoubleLane cut_form(const ShadingPoints& points, const std::vector<glm::dvec3>& outline,
                           const DoubleVectors& normal, const DoubleVectors& geometric,
                           std::size_t i) {
  const auto nothing = MaskOf<DoubleTag>::first(0);
  const DoubleVectors nowhere{0.0, 0.0, 0.0};
  SegmentLanes by_normal{nowhere, nowhere, nothing}, by_geometric{nowhere, nowhere, nothing};
  DoubleLane form = 0.0;
  const auto add = [&](const SegmentLanes& side) HWY_ATTR {
    const SegmentLanes left = clipped(side, geometric, by_geometric);
    form += where(left.some, contour_term(left.begin, left.end, normal));
  };
  DoubleVectors last = to_middle(points, i, outline.back());
  for (const glm::dvec3& corner : outline) {
    const DoubleVectors to_corner = to_middle(points, i, corner);
    add(clipped({last, to_corner, !nothing}, normal, by_normal));
    last = to_corner;
  }
  add(by_normal);
  const SegmentLanes& closing = by_geometric;
  const auto side = contour_term(closing.begin, closing.end, normal);
  return form + where(closing.some, side);
}

/// First: the projected solid angle, as polygon_form.
inline void rectangle_forms(const ShadingPoints& points, const PreparedLight& light,
                            LightArcs& found) {
  const std::vector<glm::dvec3>& outline = light.outlines.front();
  const auto towards = DoubleVectors(light.towards);
  const auto thickness = light.thickness;
  for (std::size_t i = 0; i < points.count; i += DoubleLane::count()) {
    const DoubleVectors normal = doubles(points.normal, i);
    const DoubleVectors geometric = doubles(points.geometric, i);
    DoubleLane lowest = infinity, highest_normal = -infinity, highest_geometric = -infinity;
    for (const glm::dvec3& corner : outline) {
      const DoubleVectors to_corner = to_middle(points, i, corner);
      const auto above_normal = dot(to_corner, normal);
      const auto above_geometric = dot(to_corner, geometric);
      lowest = min(lowest, min(above_normal, above_geometric));
      highest_normal = max(highest_normal, above_normal);
      highest_geometric = max(highest_geometric, above_geometric);
    }
    const auto height = -dot(to_middle(points, i, light.position), towards);
    const auto dark = highest_normal <= 0.0 || highest_geometric <= 0.0 ||
                      (light.two_sided ? abs(height) : height) <= thickness;
    DoubleLane form = 0.0;
    const auto cut = lowest < 0.0 && !dark;
    if (!none(cut)) form = cut_form(points, outline, normal, geometric, i);
    if (!all(dark || cut)) {
      DoubleLane whole = 0.0;
      DoubleVectors last = to_middle(points, i, outline.back());
      for (const glm::dvec3& corner : outline) {
        const DoubleVectors to_corner = to_middle(points, i, corner);
        whole += contour_term(last, to_corner, normal);
        last = to_corner;
      }
      form = selected(cut, form, whole);
    }
    const auto seen = selected(height < 0.0, -form, form);
    store_floats(selected(dark, 0.0, max(0.0, seen)), &found.first[i]);
  }
}

}  // namespace asos::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
