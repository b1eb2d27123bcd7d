#pragma once

#include "renderer/geometry/ray.h"
#include "renderer/result.h"
#include "renderer/scene/world.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>

namespace asos {

/// What a ray's alpha test needs to know of a world: opacity of `triangle` at (b1, b2), 0 to 1.
using AlphaAt = float (*)(const World& world, std::uint32_t triangle, float b1, float b2);

/// Rays against a world's triangles, through Embree. Masked surfaces are tested against their
/// cut-off; blended ones are met by `closest` and attenuate `transmittance`. Both sides of every
/// surface are met, also of single-sided materials: many models are wound carelessly, and a
/// previewer must not lose their surfaces. Keeps a pointer into the world, which must stay where it
/// is and outlive it. Thread-safe once built.
///
/// The same call gives the same bits on one machine. The two forms of `closest`, and spans cut
/// differently, may differ in a hit's last bits, so what goes into one span must not depend on the
/// timing of threads. A ray that is not finite, or has no direction, meets nothing; so does every
/// ray on a RayScene that was not built.
class RayScene {
 public:
  RayScene();
  ~RayScene();
  RayScene(RayScene&&) noexcept;
  RayScene& operator=(RayScene&&) noexcept;

  /// Errors: Embree's, such as lack of memory.
  [[nodiscard]] static Result<RayScene> build(const World& world, AlphaAt alpha);

  /// The nearest hit of each ray; `hits` is as long as `rays`. Coherent rays go in packets.
  void closest(std::span<const Ray> rays, std::span<Hit> hits) const;
  [[nodiscard]] Hit closest(const Ray& ray) const;

  /// The share of light that passes along the ray, 0 (blocked) to 1.
  [[nodiscard]] float transmittance(const Ray& ray) const;

  /// What Embree holds for this scene, and the copies made for it.
  [[nodiscard]] std::size_t memory_bytes() const;

  /// Rays traced at once by the span form of `closest`: 16, 8, 4 or 1. Chosen for the processor by
  /// `build`; another width may be set for a measurement, while no ray is under way.
  [[nodiscard]] int packet_width() const;
  void set_packet_width(int width);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace asos
