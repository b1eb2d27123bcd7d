#pragma once

#include "renderer/files/read_file.h"
#include "renderer/gltf/asset_root.h"
#include "renderer/gltf/warnings.h"

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace asos::gltf {

/// The file that a URI refers to.
struct UriFile {
  std::filesystem::path path;      ///< canonical if it exists
  std::filesystem::path relative;  ///< relative to the model's folder, links not followed
  std::string remark;              ///< the difference from the URI as written; empty: none
};

/// The contents that a URI refers to.
struct UriBytes {
  FileBytes bytes;
  std::string remark;  ///< about a URI that violates the rules of glTF; else empty
};

/// Finds and reads the contents to which a model's URIs refer: embedded `data:` URIs, and files in
/// its asset folders. Other schemes, absolute paths, and paths that lead out of the folders (also
/// through symbolic links) are rejected, so that a downloaded model cannot read other files. If no
/// file has the URI's name, these are tried:
/// - the URI as written ("red%20wall.png")
/// - without a query or fragment
/// - with slashes for backslashes
/// - the only file whose name differs in case alone
/// One thread.
class ModelFiles {
 public:
  /// Without folders, nothing can be read.
  ModelFiles() = default;
  explicit ModelFiles(AssetFolders folders) : folders_(std::move(folders)) {}

  /// Finds a file, which need not exist. Faults: it is rejected, or the URI refers to no file.
  [[nodiscard]] Checked<UriFile> find(std::string_view uri);
  [[nodiscard]] Checked<UriBytes> read(std::string_view uri);

 private:
  struct Place {
    UriFile file;
    bool exists = false;
  };
  using FoldedNames = std::unordered_multimap<std::string, std::string>;

  [[nodiscard]] Checked<Place> inside(const std::string& relative);
  [[nodiscard]] const std::filesystem::path& canonical_folder(
      const std::filesystem::path& relative);
  [[nodiscard]] Checked<std::optional<UriFile>> other_case(const std::string& relative);
  [[nodiscard]] const FoldedNames& names_in(const std::filesystem::path& folder);

  AssetFolders folders_;
  std::map<std::filesystem::path, std::filesystem::path> folders_known_;  // by relative path
  std::map<std::filesystem::path, FoldedNames> listed_;  // by folder: names by lower case
  std::size_t entries_listed_ = 0;
};

/// Returns the text with ASCII letters in lower case; other bytes stay the same.
[[nodiscard]] std::string lower_case(std::string_view text);

/// Returns whether a URI embeds its data.
[[nodiscard]] bool is_data_uri(std::string_view uri);

/// Decodes escapes such as %41. Incomplete escapes stay the same.
[[nodiscard]] std::string percent_decoded(std::string_view text);

/// Returns a URI for messages: data URIs and very long names are shortened.
[[nodiscard]] std::string shown_uri(std::string_view uri);

}  // namespace asos::gltf
