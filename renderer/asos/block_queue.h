#pragma once

#include "renderer/pyray/caster.h"

#include <glm/glm.hpp>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace asos {

/// A leaf's radiance, or a part of that radiance. The block determines it later.
struct Contribution {
  const PyrayLeaf* leaf = nullptr;
  glm::dvec3 radiance{0.0};  ///< linear, times the leaf's weight
  double rays = 0.0;         ///< number of rays cast to find it
  bool dropped = false;
};

/// Contributions that wait until all cells of a block are examined, so that many leaves share
/// packets of rays (design section 13). They are numbered from 0 in the order in which they are
/// added, until they are taken.
class BlockQueue {
 public:
  /// Adds a contribution to a leaf, which has to outlive it. Returns its number.
  std::uint32_t add(const PyrayLeaf& leaf) {
    waiting_.push_back({&leaf});
    return static_cast<std::uint32_t>(waiting_.size() - 1);
  }

  [[nodiscard]] Contribution& operator[](std::uint32_t number) { return waiting_[number]; }
  [[nodiscard]] const Contribution& operator[](std::uint32_t number) const {
    return waiting_[number];
  }
  [[nodiscard]] std::size_t size() const { return waiting_.size(); }
  [[nodiscard]] bool empty() const { return waiting_.empty(); }

  /// Distributes rays over all contributions, dropped ones too, in proportion to `parts`, which has
  /// one entry for each.
  void share_rays(double rays, std::span<const double> parts) {
    double all = 0.0;
    for (const double part : parts) all += part;
    if (!(all > 0.0)) return;
    for (std::size_t i = 0; i < waiting_.size(); ++i) waiting_[i].rays += rays * parts[i] / all;
  }

  /// Takes all contributions and empties the queue. Valid until the next call.
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
