#pragma once

#include "renderer/files/read_file.h"
#include "renderer/gltf/warnings.h"

#include <filesystem>
#include <string>
#include <string_view>

namespace asos::gltf {

/// The contents that a glTF `uri` refers to: an embedded `data:` URI, or a file in `folder` or
/// below it. Other schemes, absolute paths and paths that lead out of the folder (also through
/// symbolic links) are refused, so that a downloaded model cannot read elsewhere. A file whose name
/// is the uri as it is written, "red%20wall.png", is taken where there is none of the name that it
/// stands for: uploads and archives leave such names behind.
[[nodiscard]] Checked<FileBytes> read_uri(const std::filesystem::path& folder,
                                          std::string_view uri);

/// The file that a uri names, with all links followed: what `read_uri` reads. Faults: it is
/// refused, or embedded.
[[nodiscard]] Checked<std::filesystem::path> file_of_uri(const std::filesystem::path& folder,
                                                         std::string_view uri);

/// Takes %41 back to A. Incomplete escapes stay as they are.
[[nodiscard]] std::string percent_decoded(std::string_view text);

/// Faults: characters that are not base64, a length that no bytes have.
[[nodiscard]] Checked<FileBytes> base64_decoded(std::string_view text);

/// A uri as a message may show it: data URIs and very long names are shortened.
[[nodiscard]] std::string shown_uri(std::string_view uri);

}  // namespace asos::gltf
