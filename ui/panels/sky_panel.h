#pragma once

#include "ui/file_watch.h"
#include "ui/panels/controls.h"
#include "ui/panels/file_browser.h"
#include "ui/scene_edits.h"
#include "ui/sky_reader.h"

#include <optional>
#include <string>

namespace asos::ui {

/// The person's choices that the settings' sky does not tell.
struct SkyEdit {
  bool gradient = false;  ///< a sky of one colour is a gradient whose colours are the same
  bool file = false;      ///< a picture is asked for and none is there yet
  std::string path;       ///< typed
  bool browse = false;    ///< the dialog is asked for
  FileBrowser browser;
  /// The file that the sky was read from, as it was then: read again, it is no other sky.
  std::optional<FileStamp> read;
  std::optional<FileStamp> reading;
  std::string error;           ///< why it could not be read
  bool dropped = false;        ///< the file was dropped on the window
  std::optional<Error> fault;  ///< of a dropped file, to be reported over the picture
  std::string remark;          ///< what of the picture is not shown
};

/// Whether a file is a sky: an .hdr, or an .exr that is no picture saved by this program.
[[nodiscard]] bool is_sky_file(const std::string& path);
/// Reads the file and makes it the sky, by update_sky.
void read_as_sky(SkyEdit& choice, SkyReader& reader, const std::string& path);

/// Call once a frame, whether the panel is shown or not: takes over what was read.
void update_sky(SceneEdits& edits, SkyEdit& choice, SkyReader& reader);

/// The controls of the scene's surroundings.
void sky_panel(Controls& controls, SceneEdits& edits, SkyEdit& choice, SkyReader& reader);

}  // namespace asos::ui
