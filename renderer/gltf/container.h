#pragma once

#include "renderer/gltf/document.h"

namespace asos::gltf {

/// Returns the requirements for a scene's file: a .glb with plausible lengths and version, or a
/// .gltf of at most 1 GiB.
[[nodiscard]] FileRules scene_file_rules();

/// The JSON and the binary chunk of a file's bytes. Spans point into `file`.
struct Container {
  Bytes json;
  Bytes bin;
  bool is_binary = false;  ///< a .glb file
  bool has_bin = false;    ///< there is a BIN chunk, which may be empty
};

/// Distinguishes .glb from .gltf by the first bytes, and checks the chunks' lengths.
[[nodiscard]] Checked<Container> open_container(Bytes file, Warnings& warnings);

/// Returns the nesting depth of objects and arrays in a JSON text, without parsing it.
[[nodiscard]] std::size_t nesting_depth(Bytes text);

}  // namespace asos::gltf
