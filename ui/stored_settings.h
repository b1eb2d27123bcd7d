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

/// The settings that the window remembers between runs.
struct StoredSettings {
  static constexpr std::size_t most_recent = 10;

  DisplaySettings display;  ///< without show_split_map, which belongs to one picture
  WindowLook look;
  bool tour_seen = false;
  bool show_panel = true;
  bool show_marks = true;     ///< of lights
  bool watch = false;         ///< reload a file when it changes
  glm::ivec2 window_size{0};  ///< in units of a screen at scale 1; 0: not known
  PanelTab tab = PanelTab::antialias;
  std::map<std::string, bool> sections;  ///< sections of the panel that were opened or folded
  std::vector<std::string> recent;       ///< absolute paths of files, newest first

  bool operator==(const StoredSettings&) const = default;

  /// Puts a file first. Ignores built-in scenes and paths that are no files.
  void add_recent(const std::string& source);
};

/// Merges the settings of several windows that share the file: `theirs` for each value that is
/// unchanged here since `before`, otherwise `ours`; and the recent files of both.
[[nodiscard]] StoredSettings merged(const StoredSettings& before, const StoredSettings& ours,
                                    const StoredSettings& theirs);

/// asos/window.json in $XDG_CONFIG_HOME or in ~/.config; empty if neither is known.
[[nodiscard]] std::filesystem::path settings_path();

/// Reads the settings. A missing file gives the defaults, and so does each value that is missing or
/// out of range. The error names a file that cannot be read or is not JSON.
[[nodiscard]] Result<StoredSettings> load_settings(const std::filesystem::path& path);
/// Creates the folder if it is missing; replaces the file atomically.
[[nodiscard]] Result<void> save_settings(const std::filesystem::path& path,
                                         const StoredSettings& settings);

}  // namespace asos::ui
