#pragma once

#include "renderer/pyray/square.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace asos {

/// Replaces chains of connected segments by fewer segments within a tolerance (Ramer 1972, Douglas
/// and Peucker 1973), so that a finely divided outline is one boundary (design section 5). Ends at
/// the same vertex have the same coordinates, bit for bit. Reuses its memory; one object per
/// thread.
class ChainSimplifier {
 public:
  /// Returns the simplified boundaries. Both sets are within `tolerance` (in the root frame) of
  /// each other. Chains begin and end where the given ones do, and where other than two segments
  /// meet. The result does not depend on the segments' order, except for closed chains, which are
  /// fixed at a joint of their first segment. Segments that are points are kept unconnected.
  [[nodiscard]] std::span<const Segment> simplify(std::span<const Segment> segments,
                                                  float tolerance);

  /// Returns the number of chains in the last call's segments.
  [[nodiscard]] std::size_t chain_count() const { return chain_count_; }

 private:
  struct End {
    glm::vec2 at;
    std::uint32_t segment;
    bool second;
  };
  struct Joint {
    float u, v, nearness;
  };

  void join(std::span<const Segment> segments);
  void walk(std::span<const Segment> segments, std::uint32_t start, bool from_second);
  void emit_chain(float tolerance);
  void emit_range(std::size_t first, std::size_t last, float tolerance);

  std::vector<End> ends_;
  std::vector<std::uint32_t> partner_;  // the connected end 2 s + (second), or none
  std::vector<std::uint8_t> used_;
  std::vector<Joint> chain_;
  std::uint32_t edge_ = 0;
  std::size_t chain_count_ = 0;
  std::vector<Segment> simplified_;
};

}  // namespace asos
