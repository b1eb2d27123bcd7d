#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace asos::ui {

/// A folder, or a file that can be opened: a model or a saved picture.
struct FolderEntry {
  std::string name;
  bool is_folder = false;
  std::uintmax_t bytes = 0;
  std::filesystem::file_time_type written;
};

/// The folders and openable files of a folder, without hidden ones: folders first, each group
/// sorted by name.
struct FolderListing {
  static constexpr std::size_t most = 5000;
  enum class Kind { scenes, skies };

  Kind kind = Kind::scenes;  ///< of the files that are listed

  std::filesystem::path folder;
  std::vector<FolderEntry> entries;
  std::string error;  ///< why the folder cannot be read

  [[nodiscard]] static FolderListing of(const std::filesystem::path& folder,
                                        Kind kind = Kind::scenes);
  /// Indices of the entries whose names contain `filter`, ignoring case. Names that begin with it
  /// come first.
  [[nodiscard]] std::vector<std::size_t> matching(const std::string& filter) const;
};

/// Whether the file has the extension of a model.
[[nodiscard]] bool is_model(const std::filesystem::path& file);

/// The longest common prefix, ignoring case, of the names of these entries. It begins with `typed`.
[[nodiscard]] std::string completed(const FolderListing& listing,
                                    const std::vector<std::size_t>& matching,
                                    const std::string& typed);

/// The result of paging through a folder's models.
struct NextModel {
  std::string path;
  std::size_t number = 0, count = 0;  ///< its number, from 1, and the number of models
};

/// The model `step` places after `file` in its folder, sorted by name and wrapping around. If
/// `file` is alone there, the folders next to it are searched. None: `file` is no file, or the only
/// model.
[[nodiscard]] std::optional<NextModel> next_model(const std::string& file, int step);

}  // namespace asos::ui
