#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

namespace asos {

/// The state of one object after level K: a row of the papers' tables (GI'93 tables 1 and 2).
struct ObjectStatistics {
  /// The number for clusters: boundaries too small to be resolved.
  static constexpr std::uint32_t clusters = 0xfffffffeu;

  std::uint32_t object = 0;  ///< a smooth surface of the FeatureSet
  std::uint32_t in = 0;      ///< marginal cells whose axis hits the object
  std::uint32_t out = 0;     ///< marginal cells whose axis misses it
  bool one_edge = true;      ///< each of its marginal cells is near one edge only

  /// Returns M.
  [[nodiscard]] std::uint32_t marginal() const { return in + out; }
  /// Returns L; for clusters, whose in and out are unknown, the sum.
  [[nodiscard]] std::uint32_t larger() const {
    return object == clusters ? in + out : std::max(in, out);
  }
  /// Returns the largest change of the object's fraction of the root by splitting: L / 2^2K. Near
  /// one edge, at most half of each cell can change, so it is L / 2^(2K+1) (CGF'98 section 6.2).
  [[nodiscard]] double change(int level) const {
    return std::ldexp(larger(), -2 * level - (one_edge ? 1 : 0));
  }
};

/// A root's state after level K.
struct LevelStatistics {
  int level = 0;                          ///< K
  std::uint32_t marginal = 0;             ///< M: all marginal cells
  std::vector<ObjectStatistics> objects;  ///< by number

  void start(int at_level);
  /// Counts a marginal cell: the objects whose boundaries pass through it, the object on its axis,
  /// and whether only one edge is near.
  void add_cell(std::span<const std::uint32_t> objects_near, std::uint32_t hit, bool one_edge);

  /// Returns the fraction of the root's area in marginal cells: M / 2^2K.
  [[nodiscard]] double unresolved_area() const { return std::ldexp(marginal, -2 * level); }
  /// Returns the largest change of any object.
  [[nodiscard]] double largest_change() const;
};

}  // namespace asos
