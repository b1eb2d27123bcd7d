#pragma once

#include "renderer/scene/builtin/scene_assembler.h"

#include <glm/glm.hpp>

// The furniture of the built-in office, each piece standing on the floor at its place.

namespace asos::builtin {

/// A desk, 1.7 m wide, its front towards +z, with a lamp, a mug, papers and a screen on it.
void add_desk(SceneAssembler& stage, glm::dvec3 place);
/// A wooden chair with thin legs, rungs and spindles; its back is towards +z.
void add_chair(SceneAssembler& stage, const glm::dmat4& placement);
/// A shelf with books against the wall behind it, its lower left back corner at `place`.
void add_shelf(SceneAssembler& stage, glm::dvec3 place);
void add_waste_bin(SceneAssembler& stage, glm::dvec3 place);

}  // namespace asos::builtin
