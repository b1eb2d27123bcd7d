#include "renderer/features/welded_vertices.h"

#include "renderer/features/stoppable_loop.h"

#include <atomic>
#include <bit>
#include <cstddef>
#include <limits>

namespace asos {
namespace {

constexpr std::uint32_t no_vertex = std::numeric_limits<std::uint32_t>::max();

std::uint64_t mix(std::uint64_t x) {
  x ^= x >> 33;
  x *= 0xff51afd7ed558ccdULL;
  x ^= x >> 33;
  x *= 0xc4ceb9fe1a85ec53ULL;
  return x ^ (x >> 33);
}

/// A hash table of places, with the first vertex at each. Open addressing, keyed by the
/// coordinates' bits; adding zero makes -0 equal 0. Any number of threads may add concurrently: the
/// slot of a place depends on them, but its vertex does not.
class PlaceTable {
 public:
  explicit PlaceTable(const std::vector<glm::vec3>& positions)
      : positions_(positions), slots_(std::bit_ceil(2 * positions.size() + 1), no_vertex) {}

  void add(std::uint32_t vertex) {
    std::size_t at = first_slot(vertex);
    for (;; at = (at + 1) & (slots_.size() - 1)) {
      std::atomic_ref slot(slots_[at]);
      std::uint32_t there = slot.load(std::memory_order_relaxed);
      if (there == no_vertex &&
          slot.compare_exchange_strong(there, vertex, std::memory_order_relaxed))
        return;
      if (positions_[there] != positions_[vertex]) continue;
      while (vertex < there &&
             !slot.compare_exchange_weak(there, vertex, std::memory_order_relaxed)) {
      }
      return;
    }
  }
  /// Returns the first vertex at a vertex' place, after all were added.
  [[nodiscard]] std::uint32_t first_at_place_of(std::uint32_t vertex) const {
    std::size_t at = first_slot(vertex);
    while (slots_[at] != vertex && positions_[slots_[at]] != positions_[vertex])
      at = (at + 1) & (slots_.size() - 1);
    return slots_[at];
  }

 private:
  [[nodiscard]] std::size_t first_slot(std::uint32_t vertex) const {
    const glm::vec3 p = positions_[vertex] + 0.0f;
    const std::uint64_t xy = std::bit_cast<std::uint32_t>(p.x) |
                             (std::uint64_t{std::bit_cast<std::uint32_t>(p.y)} << 32);
    return mix(xy ^ mix(std::bit_cast<std::uint32_t>(p.z) + 0x9e3779b97f4a7c15ULL)) &
           (slots_.size() - 1);
  }

  const std::vector<glm::vec3>& positions_;
  std::vector<std::uint32_t> slots_;
};

}  // namespace

std::vector<std::uint32_t> welded_vertices(const std::vector<glm::vec3>& positions,
                                           const std::stop_token& stop) {
  PlaceTable table(positions);
  in_parallel(positions.size(), stop, [&](std::uint32_t i) { table.add(i); });
  std::vector<std::uint32_t> first(positions.size());
  in_parallel(positions.size(), stop,
              [&](std::uint32_t i) { first[i] = table.first_at_place_of(i); });
  return first;
}

}  // namespace asos
