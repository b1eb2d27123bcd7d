#pragma once

#include "renderer/film/image_io.h"
#include "renderer/result.h"
#include "ui/stoppable_job.h"

#include <string>
#include <vector>

namespace asos::ui {

/// The program and arguments that put a PNG onto the clipboard: wl-copy under Wayland, xclip under
/// X11, which read `file` as their input. The error says what is to be installed.
[[nodiscard]] Result<std::vector<std::string>> clipboard_command();

using ClipboardJob = StoppableJob<Result<void>>;

/// Begins to copy a picture, unless another one is being copied. The error is `clipboard_command`'s
/// one.
[[nodiscard]] Result<void> copy_picture(ClipboardJob& job, RgbImage image);

}  // namespace asos::ui
