#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>

namespace asos {

/// Kinds of work for opening a scene.
enum class Work : std::uint8_t {
  geometries,          ///< worlds with a ray hierarchy
  boundary_searches,   ///< begun
  coplanar_pairs,      ///< pairs of triangles that the search compared
  emission_lookups,    ///< places where the emission of a surface was read
  decoded_bytes,       ///< of textures, 4 or 8 bytes a texel
  hierarchy_surfaces,  ///< triangles and faces of new ray hierarchies; a shared mesh counts once
  files_read,          ///< models, buffers and pictures
};
inline constexpr std::size_t work_kinds = 7;

/// The work that this process has done, for tests and benchmarks. Thread-safe.
class WorkDone {
 public:
  static void add(Work kind, std::uint64_t amount = 1) {
    counts[static_cast<std::size_t>(kind)].fetch_add(amount, std::memory_order_relaxed);
  }
  [[nodiscard]] static std::uint64_t of(Work kind) {
    return counts[static_cast<std::size_t>(kind)].load(std::memory_order_relaxed);
  }

 private:
  static inline std::array<std::atomic<std::uint64_t>, work_kinds> counts{};
};

}  // namespace asos
