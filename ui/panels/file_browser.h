#pragma once

#include "ui/folder_listing.h"
#include "ui/panels/controls.h"

#include <filesystem>
#include <string>
#include <vector>

namespace asos::ui {

/// The state of a file browser. Typed text filters the folder; text with a slash is a path, whose
/// folder is listed instead.
struct FileBrowser {
  std::filesystem::path folder;  ///< empty: none was listed yet
  std::string typed;
  int chosen = 0;  ///< index among the matching entries
  FolderListing listing;
  bool scroll_to_chosen = false;
  bool focus = false;  ///< move the keyboard focus to the text field

  /// Starts in this folder, or continues in the last one and lists it again.
  void begin(const std::filesystem::path& first);
  /// The folder to list, and the text to filter it with.
  [[nodiscard]] std::filesystem::path shown_folder() const;
  [[nodiscard]] std::string filter() const;
  /// Lists the folder again if it has changed.
  void follow();
  void enter(const std::filesystem::path& into);
  void complete();
  void move_choice(int by);
  /// Says what Enter does if no entry matches.
  [[nodiscard]] std::string no_match_words() const;
  /// Returns what Enter opens: a file, or text that may be one. A folder is entered instead, and
  /// nothing is returned.
  [[nodiscard]] std::string take_entered();
};

/// Draws the text field and the folder's entries. Returns the chosen file, or nothing.
[[nodiscard]] std::string browse_files(Controls& controls, FileBrowser& browser, float height);

}  // namespace asos::ui
