#pragma once

#include <glm/glm.hpp>

#include <array>
#include <cstdint>
#include <vector>

namespace asos::ui {

/// `display_bytes` for one exposure, about ten times as fast. For each byte the smallest radiance
/// that gives it is found once, by bisection of `display_bytes`, so both agree exactly. Requires
/// that the transform treats all channels alike and is monotonic.
class ToneTable {
 public:
  explicit ToneTable(float exposure_ev = 0.0f);

  [[nodiscard]] float exposure_ev() const { return exposure_ev_; }
  [[nodiscard]] glm::u8vec3 bytes(glm::vec3 radiance) const {
    return {byte(radiance.x), byte(radiance.y), byte(radiance.z)};
  }

 private:
  [[nodiscard]] std::uint8_t byte(float radiance) const;

  float exposure_ev_;
  std::array<float, 257> least_;     // least_[b]: smallest radiance with byte b or more
  std::vector<std::uint8_t> guess_;  // by a float's leading bits: byte of the bucket's start
};

}  // namespace asos::ui
