#pragma once

#include "renderer/asos/error_terms.h"
#include "renderer/asos/eye_context.h"
#include "renderer/asos/eye_samples.h"
#include "renderer/asos/selected_lights.h"
#include "renderer/pyray/caster.h"
#include "renderer/pyray/error_budget.h"
#include "renderer/shadows/leaf_context.h"
#include "renderer/shadows/light_view.h"
#include "renderer/shadows/shadow_context.h"

#include <cstdint>
#include <vector>

namespace asos {

/// A leaf whose estimator is to be chosen.
struct LeafChoice {
  double weight = 1.0;  ///< fraction of the root's area
  ErrorBound bound;     ///< error bound of its centre: the sum of all error terms
  double price = 1.0;   ///< cost of one leaf of its surface, in samples
  bool may_split = false;
};

/// Returns whether MAX or EPS allows so few samples for a part of this weight that sampling it
/// costs no more than shading one leaf exactly.
[[nodiscard]] bool samples_cost_least(const ErrorBudget& error_budget, double weight);

/// Returns the cheapest estimator with an error within the allowance: the leaf's centre, samples of
/// the leaf, or its four quarters. If none qualifies, returns the one with the least error (design
/// section 14).
[[nodiscard]] Estimator choose(const ErrorBudget& error_budget, const LeafChoice& leaf);

/// Chooses the estimator of each leaf of a block and stores the evenly lit patches and the views of
/// the lights that it finds.
class LeafChooser {
 public:
  /// All arguments have to outlive this.
  LeafChooser(const EyeContext& eye, const EyeSamples& samples,
              const SelectedLights& selected_lights, const ShadowContext& shadows);

  /// See ErrorTerms.
  void learn_normals(int side) { terms_.learn_normals(side); }

  /// Returns the estimator of a leaf of this weight, from the sum of its error terms. The
  /// decision's `record` is the index of the leaf's `views`.
  [[nodiscard]] LeafDecision decide(SampleId sample, double weight, const LeafRegion& region,
                                    bool may_split);
  /// Returns a leaf's views of the lights that were computed so far.
  [[nodiscard]] const LightViews& views(const LeafDecision& decision) const {
    return views_[decision.record];
  }

  /// Returns the evenly lit patch of the sample's surface that contains the region, if any.
  [[nodiscard]] UniformShadowPatch* even_around(SampleId sample, const LeafRegion& region);
  /// Returns a patch whose lights are evaluated once for all of it. Does not check that it is
  /// evenly lit.
  [[nodiscard]] UniformShadowPatch even_patch(SampleId sample, const LeafRegion& region,
                                              const LightViews& views) const;

  /// Returns the cost of one part of a divided cell, in samples.
  [[nodiscard]] double part_price() const { return part_price_; }
  /// See ErrorTerms.
  [[nodiscard]] bool may_misplace_light(SampleId sample, double weight,
                                        const LeafRegion& region) const;

 private:
  [[nodiscard]] bool is_lit(SampleId sample) const;
  [[nodiscard]] bool nearly_flat(const Leaf& leaf) const;

  const EyeContext* eye_;
  const EyeSamples* samples_;
  ErrorTerms terms_;
  double shadows_price_, part_price_;
  std::vector<LightViews> views_{1};  // by record; the first is empty
  std::vector<UniformShadowPatch> even_;
};

}  // namespace asos
