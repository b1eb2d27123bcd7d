#pragma once

#include "ui/file_watch.h"
#include "ui/panels/controls.h"
#include "ui/panels/file_browser.h"
#include "ui/scene_edits.h"
#include "ui/sky_reader.h"

#include <optional>
#include <string>

namespace asos::ui {

/// State of the sky panel that the settings' sky does not contain.
struct SkyEdit {
  bool gradient = false;  ///< edit a gradient, although both colours are equal
  bool file = false;      ///< edit an image sky, although none is loaded yet
  std::string path;       ///< typed
  bool browse = false;    ///< the dialog is asked for
  FileBrowser browser;
  /// The file that the sky was read from, as it was then; an unchanged file is not read again.
  std::optional<FileStamp> read;
  std::optional<FileStamp> reading;
  std::string error;           ///< why it could not be read
  bool dropped = false;        ///< the file was dropped on the window
  std::optional<Error> fault;  ///< of a dropped file, to be shown over the picture
  std::string remark;          ///< warning about unsupported parts of the image
};

/// Whether a file is a sky: an .hdr, or an .exr that was not saved by this program.
[[nodiscard]] bool is_sky_file(const std::string& path);
/// Reads the file; update_sky then sets it as the sky.
void read_as_sky(SkyEdit& choice, SkyReader& reader, const std::string& path);

/// Call once a frame, whether the panel is shown or not: sets the sky that was read.
void update_sky(SceneEdits& edits, SkyEdit& choice, SkyReader& reader);

/// The controls of sky and background.
void sky_panel(Controls& controls, SceneEdits& edits, SkyEdit& choice, SkyReader& reader);

}  // namespace asos::ui
