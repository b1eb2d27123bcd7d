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

/// One directed side of Lambert's contour sum, as contour_side.
HWY_INLINE DoubleLanes contour_side(const Vec3<DoubleLanes>& a, const Vec3<DoubleLanes>& b,
                                    const Vec3<DoubleLanes>& normal) {
  const DoubleTag d;
  const Vec3<DoubleLanes> across = cross(b - a, a);
  const auto sine2 = dot(across, across);
  const auto some = hn::Gt(sine2, hn::Zero(d));
  const auto sine = hn::Sqrt(hn::IfThenElse(some, sine2, hn::Set(d, 1.0)));
  const auto angle = arc_tangent(d, sine, dot(a, b));
  const auto side = hn::Mul(hn::Mul(hn::Set(d, 0.5), angle), hn::Div(dot(across, normal), sine));
  return hn::IfThenElseZero(some, side);
}

/// A directed segment; lanes without one are marked.
struct SegmentLanes {
  Vec3<DoubleLanes> begin, end;
  hn::Mask<DoubleTag> some;
};

/// Clips one side of a convex outline to the space above a plane. The outline leaves that space at
/// one point and enters it at another; `closing` becomes the segment in the plane that joins them.
HWY_INLINE SegmentLanes clipped(const SegmentLanes& side, const Vec3<DoubleLanes>& up,
                                SegmentLanes& closing) {
  const DoubleTag d;
  const auto zero = hn::Zero(d);
  const auto begin = dot(side.begin, up), end = dot(side.end, up);
  const auto begin_above = hn::Gt(begin, zero), end_above = hn::Gt(end, zero);
  const auto crosses = hn::And(side.some, hn::Xor(begin_above, end_above));
  const auto fall = hn::IfThenElse(crosses, hn::Sub(begin, end), hn::Set(d, 1.0));
  const auto met = side.begin + scaled(hn::Div(begin, fall), side.end - side.begin);
  const auto leaves = hn::And(crosses, begin_above);
  closing.begin = select(leaves, met, closing.begin);
  closing.end = select(hn::AndNot(leaves, crosses), met, closing.end);
  closing.some = hn::Or(closing.some, crosses);
  return {select(begin_above, side.begin, met), select(end_above, side.end, met),
          hn::And(side.some, hn::Or(begin_above, end_above))};
}

/// Returns, for points from i on, the contour sum of a rectangle that horizons may cut, as
/// polygon_form.
inline DoubleLanes cut_form(const ShadingPoints& points, const std::vector<glm::dvec3>& outline,
                            const Vec3<DoubleLanes>& normal, const Vec3<DoubleLanes>& geometric,
                            std::size_t i) {
  const DoubleTag d;
  const auto none = hn::FirstN(d, 0);
  const Vec3<DoubleLanes> nowhere{hn::Zero(d), hn::Zero(d), hn::Zero(d)};
  SegmentLanes by_normal{nowhere, nowhere, none}, by_geometric{nowhere, nowhere, none};
  auto form = hn::Zero(d);
  const auto add = [&](const SegmentLanes& side) HWY_ATTR {
    const SegmentLanes left = clipped(side, geometric, by_geometric);
    form = hn::Add(form, hn::IfThenElseZero(left.some, contour_side(left.begin, left.end, normal)));
  };
  Vec3<DoubleLanes> last = to_middle(points, i, outline.back());
  for (const glm::dvec3& corner : outline) {
    const Vec3<DoubleLanes> to_corner = to_middle(points, i, corner);
    add(clipped({last, to_corner, hn::Not(none)}, normal, by_normal));
    last = to_corner;
  }
  add(by_normal);
  const SegmentLanes& closing = by_geometric;
  const auto side = contour_side(closing.begin, closing.end, normal);
  return hn::Add(form, hn::IfThenElseZero(closing.some, side));
}

/// First: the projected solid angle, as polygon_form.
inline void rectangle_forms(const ShadingPoints& points, const PreparedLight& light,
                            LightArcs& found) {
  const DoubleTag d;
  const auto zero = hn::Zero(d);
  const std::vector<glm::dvec3>& outline = light.outlines.front();
  const auto towards = broadcast(d, light.towards);
  const auto thickness = hn::Set(d, light.thickness);
  for (std::size_t i = 0; i < points.count; i += hn::Lanes(d)) {
    const Vec3<DoubleLanes> normal = doubles(points.normal, i);
    const Vec3<DoubleLanes> geometric = doubles(points.geometric, i);
    auto lowest = hn::Inf(d), highest_normal = hn::Neg(hn::Inf(d));
    auto highest_geometric = highest_normal;
    for (const glm::dvec3& corner : outline) {
      const Vec3<DoubleLanes> to_corner = to_middle(points, i, corner);
      const auto above_normal = dot(to_corner, normal);
      const auto above_geometric = dot(to_corner, geometric);
      lowest = hn::Min(lowest, hn::Min(above_normal, above_geometric));
      highest_normal = hn::Max(highest_normal, above_normal);
      highest_geometric = hn::Max(highest_geometric, above_geometric);
    }
    const auto height = hn::Neg(dot(to_middle(points, i, light.position), towards));
    const auto dark = hn::Or(hn::Or(hn::Le(highest_normal, zero), hn::Le(highest_geometric, zero)),
                             hn::Le(light.two_sided ? hn::Abs(height) : height, thickness));
    auto form = zero;
    const auto cut = hn::AndNot(dark, hn::Lt(lowest, zero));
    if (!hn::AllFalse(d, cut)) form = cut_form(points, outline, normal, geometric, i);
    if (!hn::AllTrue(d, hn::Or(dark, cut))) {
      auto whole = zero;
      Vec3<DoubleLanes> last = to_middle(points, i, outline.back());
      for (const glm::dvec3& corner : outline) {
        const Vec3<DoubleLanes> to_corner = to_middle(points, i, corner);
        whole = hn::Add(whole, contour_side(last, to_corner, normal));
        last = to_corner;
      }
      form = hn::IfThenElse(cut, form, whole);
    }
    const auto seen = hn::IfThenElse(hn::Lt(height, zero), hn::Neg(form), form);
    store_floats(hn::IfThenElse(dark, zero, hn::Max(zero, seen)), &found.first[i]);
  }
}

}  // namespace asos::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
