#pragma once

#include "renderer/asos/eye_context.h"
#include "renderer/asos/eye_samples.h"
#include "renderer/asos/leaf_gloss.h"
#include "renderer/asos/normal_variation.h"
#include "renderer/asos/shading_error.h"
#include "renderer/asos/soft_shadows.h"
#include "renderer/asos/weak_lights.h"
#include "renderer/pyray/caster.h"
#include "renderer/reflections/mirrored_pyray.h"
#include "renderer/shadows/leaf_context.h"
#include "renderer/shadows/shadow_context.h"

#include <cstdint>
#include <span>
#include <vector>

namespace asos {

/// Whether one sample can stand for what a leaf looks like, and if not, why: shading, light and
/// reflections that vary over it by more than the tolerance, and edges of soft shadows (CGF'98
/// sections 3.2 and 4.3; design section 6).
class Refinement {
 public:
  /// All have to outlive this.
  Refinement(const EyeContext& eye, const EyeSamples& samples, const WeakLights& weak_lights,
             const ShadowContext& shadows);

  /// Learns from the first samples, the middles of side x side roots in rows, how much normals vary
  /// from one to the next.
  void learn_normals(int side);

  /// The verdict's note names the lights that were found saturated.
  [[nodiscard]] LeafVerdict judge(SampleId sample, double share, const LeafRegion& region);
  /// The lights that a verdict's note names.
  [[nodiscard]] std::span<const std::uint32_t> saturated(std::uint32_t note) const {
    return shadows_.saturated(note);
  }

  /// Whether a normal map scatters the lights' highlights all over a leaf: splitting would not make
  /// it even, so it is sampled as it is.
  [[nodiscard]] bool glints(SampleId sample, double share) const;
  /// Whether a mirror, which is sampled in another, may show a light without geometry that is
  /// brighter than white: the other's pyray places it worse than samples would.
  [[nodiscard]] bool may_misplace_light(SampleId sample, const LeafRegion& region) const;
  /// Whether only samples tell what textures cut out of a leaf, or let through one before the
  /// other, or tell more of what lies behind; `judge` says so, too.
  [[nodiscard]] BySamples by_samples(SampleId sample, double share, const LeafRegion& region) const;
  /// Whether a leaf is of a bent or bumpy mesh under lights of some size, and without bright
  /// highlights, unless it shows several triangles of one: its middle's normal stands for none of
  /// its other points', and where these look past their own surface's horizon at a light is for
  /// rays to say, so that as many samples tell more of it. Or of one whose texture several
  /// triangles bring to it, each in its own way.
  [[nodiscard]] bool better_sampled_at_once(SampleId sample, double share,
                                            const LeafRegion& region) const;
  /// What each of many parts of a cell costs, in samples.
  [[nodiscard]] double part_price() const;
  /// Whether a leaf would be split further for its shading, were there any levels left.
  [[nodiscard]] bool uneven_at_last(SampleId sample, double share, const LeafRegion& region) const;

  /// The even patch of the sample's surface that a region is a part of, if any.
  [[nodiscard]] EvenPatch* even_around(SampleId sample, const LeafRegion& region);
  /// A patch that one look at each light does for.
  [[nodiscard]] EvenPatch even_patch(SampleId sample, const LeafRegion& region,
                                     std::uint32_t note) const;

 private:
  [[nodiscard]] SoftShadows::Verdict judge_shadows(SampleId sample, double share,
                                                   const LeafRegion& region);
  [[nodiscard]] ShadingError shading_error(SampleId sample, double share,
                                           const LeafRegion& region) const;
  [[nodiscard]] float normal_error(SampleId sample, const LeafRegion& region) const;
  [[nodiscard]] float light_error(SampleId sample, const LeafRegion& region) const;
  [[nodiscard]] double highlights_price() const;
  [[nodiscard]] double mirrored_width(SampleId sample, const LeafRegion& region) const;
  [[nodiscard]] glm::ivec2 pixel_of(const LeafRegion& region) const;
  [[nodiscard]] double strayed_width(const Hit& hit, const MirrorSurface& mirror,
                                     const LeafRegion& region, float side) const;
  [[nodiscard]] bool refracts_too_widely(SampleId sample, const LeafRegion& region) const;
  [[nodiscard]] bool is_finest(const LeafRegion& region) const;
  [[nodiscard]] bool nearly_flat(SampleId sample, double share) const;
  [[nodiscard]] Patch patch_around(SampleId sample, const LeafRegion& region) const;

  const EyeContext* eye_;
  const EyeSamples* samples_;
  const WeakLights* weak_lights_;
  SoftShadows shadows_;
  LeafGloss gloss_;
  bool spots_ = false;
  NormalVariation normals_;
  int border_ = 0;  // pixels of the frame around the roots
  std::vector<EvenPatch> even_;
};

}  // namespace asos
