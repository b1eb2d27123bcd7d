#pragma once

#include "renderer/asos/eye_context.h"
#include "renderer/asos/eye_samples.h"
#include "renderer/asos/shading_error.h"
#include "renderer/asos/soft_shadows.h"
#include "renderer/asos/weak_lights.h"
#include "renderer/reflections/mirrored_pyray.h"
#include "renderer/shading/highlight_unevenness.h"

#include <cstdint>

namespace asos {

/// How far what a glossy leaf shows may be off its mean by one sample: what it mirrors, and the
/// highlights of lights that have a size.
class LeafGloss {
 public:
  /// All have to outlive this.
  LeafGloss(const EyeContext& eye, const EyeSamples& samples, const WeakLights& weak_lights)
      : eye_(&eye),
        samples_(&samples),
        weak_lights_(&weak_lights),
        extended_lights_(soft_shadows(eye)) {}

  /// Of the patch that a leaf of weight `share` shows.
  [[nodiscard]] ShadingError error(SampleId sample, double share, const Patch& patch) const;

 private:
  [[nodiscard]] HighlightError highlights_error(const GlossyPatch& glossy) const;

  const EyeContext* eye_;
  const EyeSamples* samples_;
  const WeakLights* weak_lights_;
  bool extended_lights_;
};

}  // namespace asos
