// Lanes with operators, for templates that are written for numbers. Included once for each
// instruction set.
#if defined(ASOS_KERNELS_LANE_H) == defined(HWY_TARGET_TOGGLE)
#ifdef ASOS_KERNELS_LANE_H
#undef ASOS_KERNELS_LANE_H
#else
#define ASOS_KERNELS_LANE_H
#endif

#include "renderer/kernels/lanes.h"

HWY_BEFORE_NAMESPACE();
namespace asos::HWY_NAMESPACE {

/// Floats in lanes, with the operators that Highway 1.0 lacks. Converts to and from Lanes.
class Lane {
 public:
  HWY_INLINE Lane(Lanes lanes) : lanes_(lanes) {}
  /// Copies a number to all lanes.
  HWY_INLINE explicit Lane(double number) : lanes_(all_lanes(static_cast<float>(number))) {}
  HWY_INLINE operator Lanes() const { return lanes_; }

  friend HWY_INLINE Lane operator+(Lane a, Lane b) { return hn::Add(a.lanes_, b.lanes_); }
  friend HWY_INLINE Lane operator-(Lane a, Lane b) { return hn::Sub(a.lanes_, b.lanes_); }
  friend HWY_INLINE Lane operator*(Lane a, Lane b) { return hn::Mul(a.lanes_, b.lanes_); }
  friend HWY_INLINE Lane operator/(Lane a, Lane b) { return hn::Div(a.lanes_, b.lanes_); }
  friend HWY_INLINE Lane operator-(Lane a) { return hn::Neg(a.lanes_); }
  friend HWY_INLINE LaneMask operator<=(Lane a, Lane b) { return hn::Le(a.lanes_, b.lanes_); }
  friend HWY_INLINE LaneMask operator>(Lane a, Lane b) { return hn::Gt(a.lanes_, b.lanes_); }
  friend HWY_INLINE Lane sqrt(Lane a) { return hn::Sqrt(a.lanes_); }
  friend HWY_INLINE Lane copysign(Lane a, Lane sign) { return hn::CopySign(a.lanes_, sign.lanes_); }
  friend HWY_INLINE Lane min(Lane a, Lane b) { return hn::Min(a.lanes_, b.lanes_); }
  friend HWY_INLINE Lane max(Lane a, Lane b) { return hn::Max(a.lanes_, b.lanes_); }
  friend HWY_INLINE Lane selected(const LaneMask& mask, Lane yes, Lane no) {
    return hn::IfThenElse(mask, yes.lanes_, no.lanes_);
  }

 private:
  Lanes lanes_;
};

}  // namespace asos::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
