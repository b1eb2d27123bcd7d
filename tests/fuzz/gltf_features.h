#pragma once

#include "tests/fuzz/json_mutator.h"

namespace asos::fuzz {

/// Gives a glTF document something that the reader knows and that the document may lack: a
/// material's extension, cut-out or blur, a primitive's mode, targets or variants, a node's
/// visibility, levels, copies or movement, surroundings, another scene. Values are mostly those
/// that the specification allows. Does nothing where there is nothing to give it to.
void add_feature(Json& document, std::mt19937& random);

}  // namespace asos::fuzz
