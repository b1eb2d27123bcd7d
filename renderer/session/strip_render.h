#pragma once

#include "renderer/film/picture_writer.h"
#include "renderer/result.h"
#include "renderer/session/render_session.h"

#include <functional>
#include <stop_token>

namespace asos {

enum class StripsEnd { finished, stopped };

/// Renders a snapshot into a file from top to bottom, in strips of at most about a million pixels,
/// so that the memory it takes does not grow with the picture. The same pixels as in one piece.
/// `on_progress` is told the finished share, about ten times a second. Leaves `writer` to be
/// finished, or dropped where it was stopped. Errors: settings out of range, and the writer's.
[[nodiscard]] Result<StripsEnd> render_strips(const Snapshot& snapshot, PictureWriter& writer,
                                              const std::stop_token& stop,
                                              const std::function<void(double)>& on_progress = {},
                                              int strip_pixels = 1 << 20);

}  // namespace asos
