#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace asos::ui {

/// A folder, or a file that can be opened: a model, or a saved picture.
struct FolderEntry {
  std::string name;
  bool is_folder = false;
  std::uintmax_t bytes = 0;
  std::filesystem::file_time_type written;
};

/// What of a folder is worth showing to who wants to open something: folders first, each by name.
/// Hidden ones are left out.
struct FolderListing {
  static constexpr std::size_t most = 5000;
  enum class Kind { scenes, skies };

  Kind kind = Kind::scenes;  ///< of the files that are listed

  std::filesystem::path folder;
  std::vector<FolderEntry> entries;
  std::string error;  ///< why the folder cannot be read

  [[nodiscard]] static FolderListing of(const std::filesystem::path& folder,
                                        Kind kind = Kind::scenes);
  /// The entries, by index, in whose names the letters of `filter` occur, whatever their case;
  /// those that begin with them first.
  [[nodiscard]] std::vector<std::size_t> matching(const std::string& filter) const;
};

/// Whether the name ends as those of models do.
[[nodiscard]] bool is_model(const std::filesystem::path& file);

/// The longest text that begins with `typed`, in any case, and that all names of these entries
/// begin with.
[[nodiscard]] std::string completed(const FolderListing& listing,
                                    const std::vector<std::size_t>& matching,
                                    const std::string& typed);

/// A file among those that one pages through.
struct NextModel {
  std::string path;
  std::size_t number = 0, count = 0;  ///< which one it is, from 1, of how many
};

/// The model `step` after this one in its folder, by name, from the last on to the first; where it
/// is alone there, in the folders beside it. None: it is no file, or the only model.
[[nodiscard]] std::optional<NextModel> next_model(const std::string& file, int step);

}  // namespace asos::ui
