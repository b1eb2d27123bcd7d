#pragma once

#include "renderer/pyray/subdivision_variant.h"
#include "renderer/settings/choices.h"

namespace asos {

/// Subdivision as published (CGF'98 sections 3 and 3.1), with parts that can be selected: the
/// detection by a cone, the rule that considers one object at a time, and point leaves.
class PublishedSubdivision final : public SubdivisionVariant {
 public:
  PublishedSubdivision(Detection detection, StoppingRule rule, LeafKind leaf)
      : detection_(detection), rule_(rule), leaf_(leaf) {}

  [[nodiscard]] std::unique_ptr<const DetectionTest> detection(const Frame& frame) const override;
  [[nodiscard]] bool ends(const LevelStatistics& tally, double eps) const override;
  [[nodiscard]] bool cuts_cells() const override { return leaf_ == LeafKind::exact; }
  /// Returns whether any part differs from the engine's method.
  [[nodiscard]] bool differs() const {
    return detection_ != Detection::square || rule_ != StoppingRule::unresolved || !cuts_cells();
  }

 private:
  Detection detection_;
  StoppingRule rule_;
  LeafKind leaf_;
};

/// Returns the level from which on the published rule always holds for an object with only one
/// edge: the least K >= log2(1 / EPS) - 1 (CGF'98 section 6.2). EPS in (0, 1].
[[nodiscard]] int one_edge_level_bound(double eps);

}  // namespace asos
