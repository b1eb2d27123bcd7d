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

/// The file that a URI names.
struct UriFile {
  std::filesystem::path path;      ///< canonical where it exists
  std::filesystem::path relative;  ///< to the model's folder, links not followed
  std::string remark;              ///< how it differs from the URI as written; empty: it does not
};

/// The contents that a URI refers to.
struct UriBytes {
  FileBytes bytes;
  std::string remark;  ///< on a URI that breaks the rules of glTF; else empty
};

/// Finds and reads the contents that a model's URIs refer to: embedded `data:` URIs, and files in
/// its asset folders. Other schemes, absolute paths and paths that lead out of the folders (also
/// through symbolic links) are refused, so that a downloaded model cannot read elsewhere. Where
/// no file has the name that a URI stands for, these are tried: the URI as written
/// ("red%20wall.png"), without a query or fragment, with slashes for backslashes, and the one
/// file whose name differs in case alone. One thread.
class ModelFiles {
 public:
  /// Nothing can be read.
  ModelFiles() = default;
  explicit ModelFiles(AssetFolders folders) : folders_(std::move(folders)) {}

  /// Finds a file, which need not exist. Faults: it is refused, or the URI names no file.
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

/// ASCII letters in lower case; other bytes stay.
[[nodiscard]] std::string lower_case(std::string_view text);

/// Whether a URI embeds its data.
[[nodiscard]] bool is_data_uri(std::string_view uri);

/// Takes %41 back to A. Incomplete escapes stay as they are.
[[nodiscard]] std::string percent_decoded(std::string_view text);

/// A uri as a message may show it: data URIs and very long names are shortened.
[[nodiscard]] std::string shown_uri(std::string_view uri);

}  // namespace asos::gltf
