#pragma once

#include "renderer/pyray/caster.h"

#include <cstdint>

namespace asos {

/// How a root of a camera with a lens is determined.
enum class LensEstimator : std::uint8_t {
  sharp,    ///< as through a pinhole: its circles of confusion are negligible
  smooth,   ///< one leaf, as wide as the blur
  sampled,  ///< samples over the root and the lens together
  widened,  ///< as through a pinhole, by a square as wide as the blur (CGF'98 section 8)
};

/// The lens-specific part of a caster, which knows the blur of its roots by depth. Roots are
/// numbered, and so are the samples of their centres.
class LensCaster {
 public:
  virtual ~LensCaster() = default;

  /// Returns the estimator of a root. `bounded`: a boundary that may be visible passes through the
  /// root or its search region. `missed`: samples show that a boundary was not found.
  [[nodiscard]] virtual LensEstimator way(std::uint32_t root, bool bounded, bool missed) = 0;
  /// Shades a root as one leaf. Returns false if it varies too much and has to be sampled.
  [[nodiscard]] virtual bool shade_smooth(std::uint32_t root) = 0;
  /// Returns the square of a widened root.
  [[nodiscard]] virtual Square widened_square(std::uint32_t root) const = 0;
  /// Samples a root as a whole, now or in Caster::finish.
  virtual void sample_root(std::uint32_t root) = 0;
  /// Returns a caster for a trial of the sharp roots with boundaries. It only determines whether
  /// all of their leaves are sharp.
  [[nodiscard]] virtual Caster& trial() = 0;
  [[nodiscard]] virtual bool stayed_sharp(std::uint32_t root) const = 0;
};

}  // namespace asos
