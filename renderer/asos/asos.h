#pragma once

#include "renderer/asos/started_pyray.h"
#include "renderer/pyray/observer.h"
#include "renderer/samples/block_job.h"
#include "renderer/samples/unfinished_block.h"

#include <glm/glm.hpp>

namespace asos {

/// A block by adaptive supersampling in object space (CGF'98), as the settings say: for what was
/// published hand over as_published(settings). Each fat pyray in it is worked on by itself.
[[nodiscard]] BlockResult render_block_asos(const BlockJob& job);
/// The same in two stages: what is exact, and few samples of the rest, first. In the end the same
/// bits.
[[nodiscard]] StartedBlock start_block_asos(const BlockJob& job);

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

/// Its first stage.
[[nodiscard]] StartedPyray start_fat_pyray(const BlockJob& job, PixelWatch* watch = nullptr);
/// Its second stage: samples the open regions until they are within their allowance.
void finish_fat_pyray(const BlockJob& job, StartedPyray& started, PixelWatch* watch = nullptr);

}  // namespace asos
