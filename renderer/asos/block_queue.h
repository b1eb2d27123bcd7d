#pragma once

#include "renderer/pyray/caster.h"

#include <glm/glm.hpp>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace asos {

/// A part of a leaf's radiance, or all of it, that its block determines later.
struct Contribution {
  std::uint32_t root = 0;
  SampleId sample = no_sample;  ///< the leaf's
  double weight = 1.0;          ///< the leaf's
  glm::dvec3 radiance{0.0};     ///< linear, times the weight
  double rays = 0.0;            ///< cast for it
  bool dropped = false;
};

/// Contributions that wait until all cells of a block are examined: what is determined for many
/// leaves together shares packets of rays (design section 13). Numbers are those of the order of
/// their coming, from 0, until they are taken.
class BlockQueue {
 public:
  /// Adds one; its number.
  std::uint32_t add(std::uint32_t root, SampleId sample, double weight) {
    waiting_.push_back({root, sample, weight});
    return static_cast<std::uint32_t>(waiting_.size() - 1);
  }
  /// Leaves one out, whose leaf is determined otherwise.
  void drop(std::uint32_t number) { waiting_[number].dropped = true; }

  [[nodiscard]] Contribution& operator[](std::uint32_t number) { return waiting_[number]; }
  [[nodiscard]] const Contribution& operator[](std::uint32_t number) const {
    return waiting_[number];
  }
  [[nodiscard]] std::size_t size() const { return waiting_.size(); }
  [[nodiscard]] bool empty() const { return waiting_.empty(); }

  /// Shares rays out among those that were not dropped, in proportion to `parts`, one of each.
  void share_rays(double rays, std::span<const double> parts) {
    double all = 0.0;
    for (const double part : parts) all += part;
    if (!(all > 0.0)) return;
    for (std::size_t i = 0; i < waiting_.size(); ++i) waiting_[i].rays += rays * parts[i] / all;
  }

  /// All of them; none waits then. Valid until the next call.
  [[nodiscard]] std::span<const Contribution> take() {
    done_.swap(waiting_);
    waiting_.clear();
    return done_;
  }

 private:
  std::vector<Contribution> waiting_;
  std::vector<Contribution> done_;
};

}  // namespace asos
