#pragma once

#include "renderer/asos/started_pyray.h"
#include "renderer/pyray/observer.h"
#include "renderer/samples/block_job.h"
#include "renderer/samples/unfinished_block.h"

#include <glm/glm.hpp>

namespace asos {

/// Renders a block by adaptive supersampling in object space (CGF'98) with the job's settings; use
/// as_published(settings) for a published mode. Each fat pyray in the block is rendered by itself.
[[nodiscard]] BlockResult render_block_asos(const BlockJob& job);
/// Starts the same rendering in two stages: the exact parts first, with few samples of the rest.
/// After both stages the result is the same, bit for bit.
[[nodiscard]] StartedBlock start_block_asos(const BlockJob& job);

/// One pixel that is observed while it is rendered, and its outcome.
struct PixelWatch {
  glm::ivec2 pixel{0};  ///< of the picture
  Observer observer;
  bool missed = false;           ///< split by the safety net, without a boundary nearby
  double unresolved_area = 0.0;  ///< fraction of the pixel whose leaves stayed marginal
};

/// Renders the pixels of one fat pyray. The job's block is aligned to settings.asos.fat and clipped
/// to the picture.
[[nodiscard]] BlockResult render_fat_pyray(const BlockJob& job, PixelWatch* watch = nullptr);

/// Runs the first stage of render_fat_pyray.
[[nodiscard]] StartedPyray start_fat_pyray(const BlockJob& job, PixelWatch* watch = nullptr);
/// Runs the second stage of render_fat_pyray: samples the open regions until their error is within
/// the allowance.
void finish_fat_pyray(const BlockJob& job, StartedPyray& started, PixelWatch* watch = nullptr);

}  // namespace asos
