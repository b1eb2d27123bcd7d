#pragma once

#include "renderer/result.h"
#include "ui/display_settings.h"
#include "ui/panel_tab.h"
#include "ui/window_look.h"

#include <glm/glm.hpp>

#include <cstddef>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace asos::ui {

/// The settings that the window remembers from run to run.
struct StoredSettings {
  static constexpr std::size_t most_recent = 10;

  DisplaySettings display;  ///< but for the split map's being shown: that is of a picture
  WindowLook look;
  bool tour_seen = false;
  bool show_panel = true;
  bool show_marks = true;     ///< of lights
  bool watch = false;         ///< load a file again when it changes
  glm::ivec2 window_size{0};  ///< in units of a plain screen; 0: not known
  PanelTab tab = PanelTab::antialias;
  std::map<std::string, bool> sections;  ///< of the panel that were opened or folded
  std::vector<std::string> recent;       ///< files, absolute, the newest first

  bool operator==(const StoredSettings&) const = default;

  /// Puts a file first. Built-in scenes, and what is no file, are left out.
  void add_recent(const std::string& source);
};

/// What is to be kept when several windows share the file: `ours`, but where nothing has changed
/// here since `before`, `theirs`; and the recent files of both.
[[nodiscard]] StoredSettings merged(const StoredSettings& before, const StoredSettings& ours,
                                    const StoredSettings& theirs);

/// asos/window.json in $XDG_CONFIG_HOME, or in ~/.config; empty where neither is known.
[[nodiscard]] std::filesystem::path settings_path();

/// A file that is not there gives the defaults, and so does each value that is missing or out of
/// range. The error names a file that cannot be read, or is no JSON.
[[nodiscard]] Result<StoredSettings> load_settings(const std::filesystem::path& path);
/// Makes the folder where it is missing; replaces the file as a whole.
[[nodiscard]] Result<void> save_settings(const std::filesystem::path& path,
                                         const StoredSettings& settings);

}  // namespace asos::ui
