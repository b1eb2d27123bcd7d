#pragma once

#include "renderer/features/feature_edge.h"
#include "renderer/pyray/hit_list.h"
#include "renderer/pyray/subdivision_variant.h"
#include "renderer/settings/settings.h"

#include <algorithm>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace asos {

/// Kinds of boundaries, a bit for each FeatureKind.
class BoundaryKinds {
 public:
  void add(FeatureKind kind) { bits_ = static_cast<std::uint8_t>(bits_ | bit(kind)); }
  void add(BoundaryKinds other) { bits_ = static_cast<std::uint8_t>(bits_ | other.bits_); }
  [[nodiscard]] bool has(FeatureKind kind) const { return (bits_ & bit(kind)) != 0; }
  [[nodiscard]] bool empty() const { return bits_ == 0; }

 private:
  [[nodiscard]] static std::uint8_t bit(FeatureKind kind) {
    return static_cast<std::uint8_t>(1u << static_cast<unsigned>(kind));
  }
  std::uint8_t bits_ = 0;
};

/// The boundaries near the cells of one root frame: its hit lists with the detection, which defines
/// what counts as near (CGF'98 sections 3 and 6.1). One object per thread; `start` reuses its
/// memory.
class BoundarySearch {
 public:
  using List = HitLists::List;

  /// As HitLists::reset.
  void start(const FeatureSet& features, const Frame& frame, const SubdivisionVariant* variant,
             float finest_side, const SearchBounds& bounds) {
    lists_.reset(features, frame, finest_side, bounds);
    detection_ = variant ? variant->detection(frame) : nullptr;
  }

  /// The reach of the detection around a cell, and the plane of its cover, which hides boundaries.
  struct Sight {
    Square reach;
    CellOccluder hiding;
  };
  [[nodiscard]] Sight sight(const Square& cell, const OccluderPlane& cover) const {
    const Square reach = detection_ ? detection_->reach(cell) : cell;
    return {reach, CellOccluder::of(cover, lists_.frame(), reach.side)};
  }

  /// Computes the hit list of a cell from the list of any square that contains it. `seen`: see
  /// HitLists::refine.
  void refine(const Square& cell, const Sight& sight, std::span<const std::uint32_t> parent,
              List& list, bool seen) {
    lists_.refine(sight.reach, sight.hiding, parent, list, seen);
    if (!detection_) return;
    std::erase_if(list, [&](std::uint32_t i) {
      return lists_.entry(i).is_segment() && !detection_->near(lists_.segment(i), cell);
    });
  }

  /// Appends the visible boundaries of a list. Returns the number of hidden ones.
  std::uint32_t find_visible(std::span<const std::uint32_t> list, const Sight& sight,
                             List& visible) const {
    std::uint32_t hidden = 0;
    for (const std::uint32_t i : list) {
      if (lists_.hidden(i, sight.reach, sight.hiding)) {
        ++hidden;
      } else {
        visible.push_back(i);
      }
    }
    return hidden;
  }
  [[nodiscard]] bool all_hidden(std::span<const std::uint32_t> list, const Sight& sight) const {
    return std::all_of(list.begin(), list.end(), [&](std::uint32_t i) {
      return lists_.hidden(i, sight.reach, sight.hiding);
    });
  }

  /// Returns the kinds of the visible boundaries. Unresolved groups of edges count as silhouettes.
  [[nodiscard]] BoundaryKinds kinds_of(std::span<const std::uint32_t> entries) const {
    BoundaryKinds kinds;
    for (const std::uint32_t i : entries) {
      const auto kind =
          lists_.entry(i).is_segment() ? lists_.kind(i) : std::optional(FeatureKind::silhouette);
      if (kind) kinds.add(*kind);
    }
    return kinds;
  }

  [[nodiscard]] HitLists& lists() { return lists_; }
  [[nodiscard]] const HitLists& lists() const { return lists_; }
  [[nodiscard]] const Frame& frame() const { return lists_.frame(); }

 private:
  HitLists lists_;
  std::unique_ptr<const DetectionTest> detection_;  // null: a cell reaches no farther than itself
};

}  // namespace asos
