#pragma once

#include "renderer/film/rgbe.h"

#include <glm/glm.hpp>

#include <cstddef>
#include <utility>
#include <vector>

namespace asos {

/// Texels of linear radiance: as floats, or packed as in a Radiance picture, which takes a third of
/// the memory for the same radiance.
class SkyTexels {
 public:
  SkyTexels() = default;
  SkyTexels(std::vector<glm::vec3> radiance) : radiance_(std::move(radiance)) {}
  /// The radiance is that of `packed` times `scale`.
  SkyTexels(std::vector<Rgbe> packed, glm::vec3 scale = glm::vec3(1.0f))
      : packed_(std::move(packed)), scale_(scale) {}

  [[nodiscard]] glm::vec3 operator[](std::size_t i) const {
    return packed_.empty() ? radiance_[i] : scale_ * radiance_of(packed_[i]);
  }
  [[nodiscard]] std::size_t size() const { return radiance_.size() + packed_.size(); }
  [[nodiscard]] std::size_t memory_bytes() const {
    return radiance_.capacity() * sizeof(glm::vec3) + packed_.capacity() * sizeof(Rgbe);
  }

  void reserve(std::size_t count) { radiance_.reserve(count); }
  void add(glm::vec3 radiance) { radiance_.push_back(radiance); }

 private:
  std::vector<glm::vec3> radiance_;
  std::vector<Rgbe> packed_;
  glm::vec3 scale_{1.0f};
};

}  // namespace asos
