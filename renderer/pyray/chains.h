#pragma once

#include "renderer/pyray/square.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace asos {

/// Replaces chains of segments joined end to end by fewer segments that stay within a tolerance of
/// them (Ramer 1972, Douglas and Peucker 1973), so that a finely drawn outline is one boundary
/// (design section 5). Ends that belong to one vertex have the same coordinates, bit for bit.
/// Keeps its memory between calls; one object a thread.
class ChainSimplifier {
 public:
  /// The simplified boundaries, no further than `tolerance` (in the root frame) from the given ones
  /// and the other way round; chains begin and end where the given ones do, and where other than
  /// two segments meet. Does not depend on the segments' order but for closed chains, which are
  /// held at a joint of their first segment. Segments that are points are kept, and join nothing.
  [[nodiscard]] std::span<const Segment> simplify(std::span<const Segment> segments,
                                                  float tolerance);

  /// How many chains the segments given last form.
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
  std::vector<std::uint32_t> partner_;  // the end joined to end 2 s + (second), or none
  std::vector<std::uint8_t> used_;
  std::vector<Joint> chain_;
  std::uint32_t edge_ = 0;
  std::size_t chain_count_ = 0;
  std::vector<Segment> simplified_;
};

}  // namespace asos
