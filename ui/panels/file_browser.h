#pragma once

#include "ui/folder_listing.h"
#include "ui/panels/controls.h"

#include <filesystem>
#include <string>
#include <vector>

namespace asos::ui {

/// What a person looks through to find a file. What is typed filters the folder; with a slash it is
/// a path, whose folder is looked through in place of the one shown.
struct FileBrowser {
  std::filesystem::path folder;  ///< empty: none was looked through yet
  std::string typed;
  int chosen = 0;  ///< among the entries that match
  FolderListing listing;
  bool scroll_to_chosen = false;
  bool focus = false;  ///< the field is to be typed into

  /// Begins in this folder, or goes on where it was left; what lies there may have changed.
  void begin(const std::filesystem::path& first);
  /// The folder that is looked through, and by what.
  [[nodiscard]] std::filesystem::path shown_folder() const;
  [[nodiscard]] std::string filter() const;
  /// Reads the folder again where another is looked through.
  void follow();
  void enter(const std::filesystem::path& into);
  void complete();
  void move_choice(int by);
  /// Says what Enter does where no entry matches.
  [[nodiscard]] std::string no_match_words() const;
  /// What Enter opens: a file, or text that may be one; a folder is entered instead, and nothing is
  /// returned.
  [[nodiscard]] std::string take_entered();
};

/// The field, the folder and what lies in it. Returns the file that was chosen, or nothing.
[[nodiscard]] std::string browse_files(Controls& controls, FileBrowser& browser, float height);

}  // namespace asos::ui
