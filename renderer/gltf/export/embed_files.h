#pragma once

#include "renderer/gltf/container.h"
#include "renderer/gltf/export/gltf_writer.h"
#include "renderer/gltf/files.h"

namespace asos::exporting {

/// Moves the buffers and image files that the document's JSON names into its binary buffer.
/// Buffer views that reach past the end of their buffer still do so. Buffers without data and files
/// that cannot be read stay as they are.
void embed_files(const gltf::Container& container, gltf::ModelFiles& files, GltfDocument& document);

}  // namespace asos::exporting
