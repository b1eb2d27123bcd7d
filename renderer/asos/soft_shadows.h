#pragma once

#include "renderer/asos/eye_context.h"
#include "renderer/asos/weak_lights.h"
#include "renderer/shadows/shadow_context.h"

#include <cstdint>
#include <span>
#include <vector>

namespace asos {

/// Whether some light that has a size casts shadows.
[[nodiscard]] bool soft_shadows(const EyeContext& eye);

/// Edges of soft shadows that run through leaves: whether a leaf is to be split for them (CGF'98
/// section 4.3; design section 6), and which lights are to be looked at by rays instead.
class SoftShadows {
 public:
  /// All have to outlive this.
  SoftShadows(const EyeContext& eye, const WeakLights& weak_lights, const ShadowContext& shadows)
      : eye_(&eye), weak_lights_(&weak_lights), shadows_(&shadows), any_(soft_shadows(eye)) {}

  [[nodiscard]] bool any() const { return any_; }

  struct Verdict {
    float error = 0.0f;      ///< in display intensity, more than the tolerance; 0: it is even
    std::uint32_t note = 0;  ///< of an even one: names the saturated lights
  };
  /// Of a patch around a point that makes no more than `reflected` of irradiance and stands for
  /// `share` of its pixel, which was split `level` times.
  [[nodiscard]] Verdict judge(const SurfacePoint& point, const Patch& patch, float reflected,
                              int level, double share);
  /// The lights that a note names, until the end.
  [[nodiscard]] std::span<const std::uint32_t> saturated(std::uint32_t note) const;

  /// What finding all of them costs a leaf, in samples of it.
  [[nodiscard]] double price() const;

 private:
  [[nodiscard]] bool casts(std::uint32_t light) const;

  const EyeContext* eye_;
  const WeakLights* weak_lights_;
  const ShadowContext* shadows_;
  bool any_;
  std::vector<std::vector<std::uint32_t>> saturated_;  // by note - 1
};

}  // namespace asos
