#pragma once

#include "renderer/pyray/caster.h"

#include <cstdint>

namespace asos {

/// How a root of a camera with a lens is determined.
enum class LensWay : std::uint8_t {
  sharp,    ///< as through a pinhole: its circles of confusion are negligible
  smooth,   ///< one leaf, as wide as the blur
  sampled,  ///< samples over the root and the lens together
  widened,  ///< as through a pinhole, by a square as wide as the blur (CGF'98 section 8)
};

/// The side of a caster that knows how a lens blurs its roots by depth. Roots are numbered, and so
/// are the samples of their middles.
class LensCaster {
 public:
  virtual ~LensCaster() = default;

  /// The way for a root. `bounded`: a boundary that may be visible passes through it or through
  /// what is searched around it; `missed`: samples show that there is one that was not found.
  [[nodiscard]] virtual LensWay way(std::uint32_t root, bool bounded, bool missed) = 0;
  /// Shades a root as one leaf. False: it varies too much, and is to be sampled.
  [[nodiscard]] virtual bool shade_smooth(std::uint32_t root) = 0;
  /// The square of a widened root.
  [[nodiscard]] virtual Square widened_square(std::uint32_t root) const = 0;
  /// Samples a root as a whole, now or until Caster::finish.
  virtual void sample_root(std::uint32_t root) = 0;
  /// A caster for a trial of the sharp roots that boundaries cross: it only finds out whether all
  /// of their leaves are sharp.
  [[nodiscard]] virtual Caster& trial() = 0;
  [[nodiscard]] virtual bool stayed_sharp(std::uint32_t root) const = 0;
};

}  // namespace asos
