#pragma once

#include "renderer/scene/gltf/document.h"
#include "renderer/scene/scene.h"

namespace asos::gltf {

/// Whether these are the bytes of a WebP picture, by how they begin.
[[nodiscard]] bool is_webp(Bytes bytes);

/// Decodes a still WebP picture (EXT_texture_webp) to 8-bit RGBA. Faults: animations, broken data,
/// and dimensions that the bytes cannot stand for or that are more than `most_pixels`, before they
/// are allocated.
[[nodiscard]] Checked<Image> decode_webp(Bytes bytes, std::uint64_t most_pixels);

}  // namespace asos::gltf
