#pragma once

#include "renderer/gltf/files.h"

#include <string_view>

namespace asos::gltf {

/// Decodes an embedded `data:` URI. White space in base64 is skipped, with a remark. Faults: no
/// data, characters that are not base64, an impossible length.
[[nodiscard]] Checked<UriBytes> read_data_uri(std::string_view uri);

}  // namespace asos::gltf
