#pragma once

#include "renderer/geometry/ray.h"

#include <cstdint>

namespace asos {

/// Counts the visible surfaces along a ray, up to `most`; the rest is dropped. Clear surfaces do
/// not count, unless there are so many of them that the stack is endless.
class LayerCount {
 public:
  static constexpr int most = 1024;

  [[nodiscard]] int layers() const { return layers_; }
  [[nodiscard]] bool full() const { return layers_ >= most || passed_ >= most_passed; }
  void add_layer() { ++layers_; }
  void pass_clear() { ++passed_; }

 private:
  static constexpr int most_passed = 1 << 16;
  int layers_ = 0;
  int passed_ = 0;
};

/// The transparent surfaces that a ray has passed before it was continued.
struct PassedLayers {
  LayerCount count;
  std::uint32_t last = Hit::none;  ///< triangle of the last one
  float left = 1.0f;               ///< weight of the rest in the whole ray's radiance
  float distance = 0.0f;           ///< of the last one
};

}  // namespace asos
