#pragma once

#include "renderer/film/image_io.h"
#include "renderer/result.h"
#include "ui/stoppable_job.h"

#include <string>
#include <vector>

namespace asos::ui {

/// The program and arguments that copy a PNG to the clipboard: wl-copy under Wayland, xclip under
/// X11. They read the PNG from standard input. The error names the package to install.
[[nodiscard]] Result<std::vector<std::string>> clipboard_command();

using ClipboardJob = StoppableJob<Result<void>>;

/// Starts to copy a picture, unless another copy is running. Errors are those of
/// `clipboard_command`.
[[nodiscard]] Result<void> copy_picture(ClipboardJob& job, RgbImage image);

}  // namespace asos::ui
