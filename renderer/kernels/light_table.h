#pragma once

#include "renderer/kernels/light_constants.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace asos {

/// The constants of many lights as arrays, to weigh all of them at a point.
class LightTable {
 public:
  /// Weights are written for a multiple of this number of lights.
  static constexpr std::size_t step = 16;

  void clear();
  /// Adds a light; `number` is the caller's number for it.
  void add(const LightConstants& light, std::uint32_t number);
  [[nodiscard]] std::size_t size() const { return numbers_.size(); }
  [[nodiscard]] std::size_t padded_size() const { return fields_[0].size(); }
  [[nodiscard]] std::uint32_t number(std::size_t i) const { return numbers_[i]; }

  /// Returns whether any light has a range or a cone.
  [[nodiscard]] bool attenuates() const { return attenuates_; }

  /// One array per quantity, padded to a multiple of `step` by lights without power.
  enum Field : std::size_t {
    position_x,
    position_y,
    position_z,
    towards_x,
    towards_y,
    towards_z,
    power_x,
    power_y,
    power_z,
    extent,     ///< power times this is the intensity; for distant lights, the irradiance
    far,        ///< 1 for distant lights, which shine from `towards` everywhere; else 0
    flat,       ///< 1 for lights that emit with the cosine to `towards`; else 0
    two_sided,  ///< 1 or 0
    /// Radius of the bounding sphere about the position; for distant lights its tangent.
    radius,
    // Irradiance is proportional to 1 / (distance (distance + near_linear) + extent near_size). The
    // denominator is at least `least`.
    near_linear,
    near_size,
    least,
    // The extent within a distance of a place is part_linear distance + part_square distance^2.
    part_linear,
    part_square,
    // Half edges, and 1 / their squared lengths; 0 where there are none. Balls and suns have only
    // `round`, their radius.
    half_u_x,
    half_u_y,
    half_u_z,
    half_v_x,
    half_v_y,
    half_v_z,
    per_u2,
    per_v2,
    round,
    inverse_range,
    cone_scale,
    cone_offset,
    shown_from,
    field_count
  };
  [[nodiscard]] const float* of(Field field) const { return fields_[field].data(); }

 private:
  std::array<std::vector<float>, field_count> fields_;
  std::vector<std::uint32_t> numbers_;
  bool attenuates_ = false;
};

}  // namespace asos
