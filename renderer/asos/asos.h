#pragma once

#include "renderer/pyray/observer.h"
#include "renderer/samples/block_job.h"

#include <glm/glm.hpp>

namespace asos {

/// A block by adaptive supersampling in object space (CGF'98), as the settings say: for what was
/// published hand over as_published(settings). Each fat pyray in it is worked on by itself.
[[nodiscard]] BlockResult render_block_asos(const BlockJob& job);

/// One pixel under observation while it is rendered, and what came of it.
struct PixelWatch {
  glm::ivec2 pixel{0};  ///< of the picture
  Observer observer;
  bool missed = false;           ///< split by the safety net, without a boundary near
  double unresolved_area = 0.0;  ///< share of the pixel whose leaves stayed marginal
};

/// The pixels of one fat pyray: the job's block is aligned to settings.asos.fat, and clipped to the
/// picture.
[[nodiscard]] BlockResult render_fat_pyray(const BlockJob& job, PixelWatch* watch = nullptr);

}  // namespace asos
