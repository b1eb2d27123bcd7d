#pragma once

#include <glm/glm.hpp>

#include <array>
#include <cstdint>
#include <vector>

namespace asos::ui {

/// `display_bytes` for one exposure, about ten times as fast: the smallest radiance that gives each
/// byte is found once, by bisection of `display_bytes` itself, so both agree bit for bit. That the
/// transform treats the channels alike and never falls with rising radiance is all it relies on.
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
  std::array<float, 257> least_;     // least_[b]: smallest radiance shown as b or more
  std::vector<std::uint8_t> guess_;  // by the leading bits of a float: byte of the bucket's start
};

}  // namespace asos::ui
