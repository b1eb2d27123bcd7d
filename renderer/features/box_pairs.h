#pragma once

#include "renderer/world/world.h"

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <stop_token>
#include <vector>

namespace asos {

/// A tree over the boxes of a world's first triangles, with eight children per node and leaves
/// along a Morton curve (Karras 2012 orders triangles so; here the tree is the implicit complete
/// one). Finds the pairs of triangles with overlapping boxes. Immutable: any number of threads.
class BoxTree {
 public:
  static constexpr std::size_t width = 8;

  /// Throws SearchStopped once `stop` is requested.
  BoxTree(const World& world, std::size_t triangles, const std::stop_token& stop = {});
  /// Builds the tree of some triangles.
  BoxTree(const World& world, std::vector<std::uint32_t> triangles,
          const std::stop_token& stop = {});
  explicit BoxTree(const World& world, const std::stop_token& stop = {})
      : BoxTree(world, world.triangles.size(), stop) {}

  [[nodiscard]] std::size_t leaf_count() const { return levels_.empty() ? 0 : levels_[0].size(); }

  /// Visits the pairs of triangles with overlapping boxes, including touching ones. One triangle is
  /// in `leaf`, and the other there or in a later leaf, so all leaves together give each pair once.
  /// `visit` gets the two triangles, the lower one first, and returns whether to continue.
  template <typename Visit>
  void visit_pairs(std::size_t leaf, Visit&& visit) const {
    const OneBox all = box_of_leaf(leaf);
    // Nodes to visit: at most `width` are added for each level.
    struct Place {
      std::size_t level, node;
    };
    std::array<Place, width * most_levels> stack;
    std::size_t count = 0;
    stack[count++] = {levels_.size() - 1, 0};
    while (count > 0) {
      const auto [level, node] = stack[--count];
      if (level == 0) {
        if (!visit_leaves(leaf, node, visit)) return;
        continue;
      }
      for (Lanes lanes = overlapping(levels_[level][node], all); lanes; lanes &= lanes - 1) {
        const std::size_t child = node * width + first(lanes);
        const std::size_t last_leaf = ((child + 1) << (3 * (level - 1))) - 1;
        if (last_leaf >= leaf) stack[count++] = {level - 1, child};
      }
    }
  }

 private:
  // Eight boxes by coordinate. Unused ones are empty and overlap nothing.
  struct Boxes {
    float lo[3][width];
    float hi[3][width];
  };
  struct OneBox {
    float lo[3];
    float hi[3];
  };
  using Lanes = std::uint32_t;                    // one bit for each of eight boxes
  static constexpr std::size_t most_levels = 12;  // one more than 2^32 triangles need

  [[nodiscard]] static OneBox union_of(const Boxes& boxes);
  [[nodiscard]] static OneBox at(const Boxes& boxes, std::size_t i) {
    OneBox box;
    for (int k = 0; k < 3; ++k) box.lo[k] = boxes.lo[k][i], box.hi[k] = boxes.hi[k][i];
    return box;
  }
  [[nodiscard]] OneBox box_of_leaf(std::size_t leaf) const {
    return at(levels_[1][leaf / width], leaf % width);
  }
  static void put(Boxes& boxes, std::size_t i, const OneBox& box);
  /// Returns which of eight boxes overlap a box.
  [[nodiscard]] static Lanes overlapping(const Boxes& boxes, const OneBox& box);
  [[nodiscard]] static std::size_t first(Lanes lanes) {
    return static_cast<std::size_t>(std::countr_zero(lanes));
  }

  template <typename Visit>
  [[nodiscard]] bool visit_leaves(std::size_t leaf, std::size_t other, Visit&& visit) const {
    Lanes near = overlapping(levels_[0][leaf], box_of_leaf(other));
    for (; near; near &= near - 1) {
      const std::size_t i = first(near);
      const std::uint32_t s = triangles_[leaf * width + i];
      Lanes lanes = overlapping(levels_[0][other], at(levels_[0][leaf], i));
      if (leaf == other) lanes &= ~Lanes{0} << (i + 1);
      for (; lanes; lanes &= lanes - 1) {
        const std::uint32_t t = triangles_[other * width + first(lanes)];
        if (!(s < t ? visit(s, t) : visit(t, s))) return false;
      }
    }
    return true;
  }

  std::vector<std::uint32_t> triangles_;  // along the curve, `width` per leaf
  // [0]: triangles, by leaf; the others: nodes of the level before.
  std::vector<std::vector<Boxes>> levels_;
};

}  // namespace asos
