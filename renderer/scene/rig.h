#pragma once

#include "renderer/result.h"
#include "renderer/scene/scene.h"

#include <optional>

namespace asos {

/// A file that is kept open so that its scene can be had at any times, without the file being read
/// again. What does not move is neither read nor made again.
class Rig {
 public:
  Rig() = default;
  Rig(const Rig&) = delete;
  Rig& operator=(const Rig&) = delete;
  virtual ~Rig() = default;

  /// The scene as it is at `time`, or where the file's nodes place it: the same to the bit whatever
  /// was asked for before. Errors name the file: no such animation, a time that is not finite or
  /// below 0, nothing that can be drawn then. Any thread; one call waits for another.
  [[nodiscard]] virtual Result<Scene> pose(const std::optional<ClipTime>& time) = 0;
};

}  // namespace asos
