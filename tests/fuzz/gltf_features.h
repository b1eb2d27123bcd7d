#pragma once

#include "tests/fuzz/json_mutator.h"

namespace asos::fuzz {

/// Adds a random feature that the reader supports to a glTF document: an extension, cut-out or blur
/// of a material; mode, targets or variants of a primitive; visibility, levels, instances or
/// animation of a node; surroundings; another scene. Values are mostly valid. Does nothing if there
/// is no object to add it to.
void add_feature(Json& document, std::mt19937& random);

}  // namespace asos::fuzz
