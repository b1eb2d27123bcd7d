#pragma once

#include "renderer/kernels/light_constants.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace asos {

/// Many lights as arrays, to be weighed at a point.
class LightTable {
 public:
  /// Weights are written for a multiple of so many lights.
  static constexpr std::size_t step = 16;

  void clear();
  /// Another light, which is the number `light` of who asks.
  void add(const LightConstants& light, std::uint32_t number);
  [[nodiscard]] std::size_t size() const { return numbers_.size(); }
  [[nodiscard]] std::size_t padded_size() const { return fields_[0].size(); }
  [[nodiscard]] std::uint32_t number(std::size_t i) const { return numbers_[i]; }

  /// Whether any has a range or a cone.
  [[nodiscard]] bool attenuates() const { return attenuates_; }

  /// One array a quantity, padded to a multiple of `step` by lights that give nothing.
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
    extent,     ///< times the power makes its intensity; of far ones, irradiance
    far,        ///< 1 where it comes from `towards`, whatever the position; else 0
    flat,       ///< 1 where it shines by the cosine to `towards`; else 0
    two_sided,  ///< 1 or 0
    radius,     ///< of the sphere about the position that holds the light; far: the tangent
    // Irradiance falls off by distance (distance + near_linear) + extent near_size, at least
    // `least`.
    near_linear,
    near_size,
    least,
    // Of the extent, what is within a distance of a place: part_linear distance +
    // part_square distance^2.
    part_linear,
    part_square,
    // Edges, halved, and 1 / their squared lengths; 0 where there are none. Of balls and suns
    // `round`, the radius, alone.
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
