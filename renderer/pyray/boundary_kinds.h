#pragma once

#include "renderer/features/feature_edge.h"

#include <cstdint>

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

}  // namespace asos
