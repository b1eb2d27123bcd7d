#pragma once

#include "renderer/gltf/load.h"

#include <string>
#include <string_view>

namespace asos::gltf {

/// Whether assimp converts files with this ending: .3ds, .3mf, .dae, .fbx, .obj, .off, .ply, .stl
/// or .x3d, in any case.
[[nodiscard]] bool is_convertible(std::string_view path);

/// Converts a model of another format to glTF by the program assimp and imports it. The program
/// runs in a process of its own, with limits of time, memory and output, into a folder that is
/// removed. A warning lists possible losses. Errors name the file: assimp is not
/// installed (with the command that installs it), it fails or takes too long, or its glTF cannot be
/// imported.
[[nodiscard]] Result<Scene> import_converted(const std::string& path, LoadOptions options);

}  // namespace asos::gltf
