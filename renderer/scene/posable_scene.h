#pragma once

#include "renderer/result.h"
#include "renderer/scene/scene.h"

#include <optional>

namespace asos {

/// A file that is kept open, so that its scene can be posed at any time without reading the file
/// again. Parts that do not move are neither read nor built again.
class PosableScene {
 public:
  PosableScene() = default;
  PosableScene(const PosableScene&) = delete;
  PosableScene& operator=(const PosableScene&) = delete;
  virtual ~PosableScene() = default;

  /// Returns the scene at `time`, or as the file's nodes place it. The result is bit-identical
  /// whatever was posed before. Errors name the file: no such animation, a time that is not finite
  /// or below 0, nothing that can be drawn at that time. Any thread; concurrent calls wait for each
  /// other.
  [[nodiscard]] virtual Result<Scene> pose(const std::optional<ClipTime>& time) = 0;
};

}  // namespace asos
