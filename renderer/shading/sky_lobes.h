#pragma once

#include <glm/glm.hpp>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>
#include <utility>
#include <vector>

namespace asos {

class SkyMap;

/// Values by direction, on a lattice that is folded around an octahedron ("octahedral
/// environment maps", Engelhardt and Dachsbacher 2008): +Y is in the centre of the square from -1
/// to 1, and -Y in its corners. Kernels read the nodes, so this layout is public.
struct OctahedralMap {
  std::int32_t cells = 0;        ///< along one side of the square; even
  std::vector<glm::vec4> nodes;  ///< cells + 2 per row; the last node of each row and column is
                                 ///< a copy that is never weighted

  [[nodiscard]] std::int32_t stride() const { return cells + 2; }
  /// Returns the place of a direction, which need not be unit. NaN if there is none.
  [[nodiscard]] static glm::vec2 place(glm::vec3 direction) {
    const float scale =
        1.0f / (std::abs(direction.x) + std::abs(direction.y) + std::abs(direction.z));
    const glm::vec2 p(direction.x * scale, direction.z * scale);
    if (!(direction.y < 0.0f)) return p;
    return {std::copysign(1.0f - std::abs(p.y), p.x), std::copysign(1.0f - std::abs(p.x), p.y)};
  }
  /// Returns the bilinear value at a place.
  [[nodiscard]] glm::vec4 at(glm::vec2 place) const {
    const float half = 0.5f * static_cast<float>(cells);
    const float x = (place.x + 1.0f) * half, y = (place.y + 1.0f) * half;
    const float column = lower(x), row = lower(y);
    const auto first = static_cast<std::size_t>(static_cast<std::int32_t>(row) * stride() +
                                                static_cast<std::int32_t>(column));
    const glm::vec4* above = &nodes[first];
    const glm::vec4* below = above + stride();
    const float right = x - column;
    const glm::vec4 a = above[0] + right * (above[1] - above[0]);
    const glm::vec4 b = below[0] + right * (below[1] - below[0]);
    return a + (y - row) * (b - a);
  }

 private:
  /// Returns the node below a coordinate; 0 for NaN, which must not become an index.
  [[nodiscard]] float lower(float x) const {
    return x >= 0.0f ? std::min(std::floor(x), static_cast<float>(cells)) : 0.0f;
  }
};

/// Means of a sky's picture over what surfaces reflect: the lobes of rough surfaces, and the
/// hemisphere of a matte one. Each is one look-up. Immutable, except that the map of a roughness is
/// computed when it is first used; any thread.
class SkyLobes {
 public:
  /// The maps' roughnesses are `least_roughness` to 1, in steps of 1 / `steps`. Narrower lobes
  /// would need larger maps.
  static constexpr int steps = 32;
  static constexpr int first_step = 8;
  static constexpr float least_roughness = static_cast<float>(first_step) / steps;
  static constexpr std::size_t maps = steps - first_step + 1;

  explicit SkyLobes(const SkyMap& picture);

  /// Returns the irradiance over pi of a surface with this normal, from its half of the sky.
  [[nodiscard]] glm::vec3 irradiance_over_pi(glm::vec3 normal) const {
    return glm::vec3(irradiance_.at(OctahedralMap::place(normal)));
  }
  /// Returns the mean over a square of lobe_width(roughness) around a direction; see Sky::around.
  /// From least_roughness on.
  [[nodiscard]] glm::vec3 around(glm::vec3 direction, float roughness) const;

  /// The maps of the same two functions, for kernels: linear interpolation between maps i and
  /// i + 1 at roughness (i + first_step + fraction) / steps.
  [[nodiscard]] const OctahedralMap& irradiance() const { return irradiance_; }
  [[nodiscard]] const OctahedralMap& lobe(std::size_t i) const {
    const OctahedralMap* made = made_[i].load(std::memory_order_acquire);
    return made ? *made : make(i);
  }
  [[nodiscard]] std::size_t memory_bytes() const;

 private:
  const OctahedralMap& make(std::size_t i) const;

  std::vector<OctahedralMap> sources_;  ///< the picture in fewer and fewer nodes
  OctahedralMap irradiance_;            ///< over pi, by normal
  mutable std::mutex making_;
  mutable std::array<std::unique_ptr<const OctahedralMap>, maps> lobes_;
  mutable std::array<std::atomic<const OctahedralMap*>, maps> made_{};
};

}  // namespace asos
