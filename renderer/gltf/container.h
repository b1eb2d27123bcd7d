#pragma once

#include "renderer/gltf/document.h"

namespace asos::gltf {

/// What a scene's file has to be to be read: lengths and version of a .glb that can be true, a
/// .gltf of at most 1 GiB.
[[nodiscard]] FileRules scene_file_rules();

/// The JSON and the binary chunk of a file's bytes. Spans point into `file`.
struct Container {
  Bytes json;
  Bytes bin;
  bool is_binary = false;  ///< a .glb file
  bool has_bin = false;    ///< it has a BIN chunk, which may be empty
};

/// Tells .glb from .gltf by its first bytes and checks the chunks' lengths.
[[nodiscard]] Checked<Container> open_container(Bytes file, Warnings& warnings);

/// How deep objects and arrays nest in a JSON text, found without parsing it.
[[nodiscard]] std::size_t nesting_depth(Bytes json);

}  // namespace asos::gltf
