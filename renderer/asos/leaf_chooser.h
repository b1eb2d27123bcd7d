#pragma once

#include "renderer/asos/error_terms.h"
#include "renderer/asos/eye_context.h"
#include "renderer/asos/eye_samples.h"
#include "renderer/asos/selected_lights.h"
#include "renderer/pyray/caster.h"
#include "renderer/pyray/error_budget.h"
#include "renderer/samples/thread_local_cache.h"
#include "renderer/shadows/leaf.h"
#include "renderer/shadows/shadow_context.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace asos {

/// Chooses the estimator of each leaf of a block and stores the leaves and the evenly lit patches.
class LeafChooser {
 public:
  /// All arguments have to outlive this.
  LeafChooser(const EyeContext& eye, const EyeSamples& samples,
              const SelectedLights& selected_lights, const ShadowContext& shadows);

  /// See ErrorTerms.
  void learn_normals(int side) { terms_.learn_normals(side); }

  /// Returns the estimator of a leaf, from the sum of its error terms. The decision's `record` is
  /// the number of the leaf that was made for it, from 1; 0: none.
  [[nodiscard]] LeafDecision decide(const PyrayLeaf& part, bool may_split);
  /// Returns a part of a root with its surface: the leaf of its decision, or a new one. It lives as
  /// long as this.
  [[nodiscard]] Leaf& leaf(const PyrayLeaf& part);

  /// Returns the evenly lit patch of the sample's surface that contains the region, if any.
  [[nodiscard]] UniformShadowPatch* even_around(const PyrayLeaf& part);
  /// Returns a patch whose lights are evaluated once for all of it. Does not check that it is
  /// evenly lit.
  [[nodiscard]] UniformShadowPatch even_patch(const Leaf& whole) const;

  /// Returns the cost of one part of a divided cell, in samples.
  [[nodiscard]] double part_price() const { return part_price_; }
  /// See ErrorTerms.
  [[nodiscard]] bool may_misplace_light(const Leaf& leaf) const {
    return terms_.may_misplace_light(leaf);
  }

 private:
  [[nodiscard]] LeafDecision decide(Leaf& leaf, bool shared, bool may_split);
  Leaf& add(const PyrayLeaf& part);
  [[nodiscard]] bool is_lit(SampleId sample) const;

  const EyeContext* eye_;
  const EyeSamples* samples_;
  ErrorTerms terms_;
  double shadows_price_, part_price_;
  /// Leaves by record, from 1. Only the first `count_` belong to this block.
  using Leaves = std::vector<std::unique_ptr<Leaf>>;
  CachedPtr<Leaves> leaves_ = ThreadLocalCache<Leaves>::make();
  std::uint32_t count_ = 0;
  std::vector<UniformShadowPatch> even_;
};

}  // namespace asos
