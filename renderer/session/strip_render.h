#pragma once

#include "renderer/film/picture_writer.h"
#include "renderer/result.h"
#include "renderer/session/render_session.h"

#include <functional>
#include <stop_token>

namespace asos {

enum class StripsEnd { finished, stopped };

/// Renders a snapshot into a file from top to bottom, in strips of at most about a million pixels,
/// so that the memory does not grow with the picture. The pixels are the same as in one piece.
/// `on_progress` gets the finished fraction about ten times a second. The caller finishes `writer`,
/// or drops it if the render was stopped. Errors: settings out of range, and the writer's.
[[nodiscard]] Result<StripsEnd> render_strips(const Snapshot& snapshot, PictureWriter& writer,
                                              const std::stop_token& stop,
                                              const std::function<void(double)>& on_progress = {},
                                              int strip_pixels = 1 << 20);

}  // namespace asos
